// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/findings.hpp"

#include <array>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

TEST(Findings, LessHoldsOnTheMean) {
  const std::array a{1.0, 2.0, no_figure, 9.0};
  const std::array b{2.0, 3.0, 5.0, 8.0};
  const Claim claim = claim_less({"x", "a < b", "Section 1"}, a, b, {.unit = "cm", .decimals = 1, .factor = 100.0});
  EXPECT_EQ(claim.verdict, Verdict::holds);
  EXPECT_EQ(claim.seeds, 3U);
  EXPECT_EQ(claim.holds_on, 2U);
  EXPECT_EQ(claim.evidence, "400.0 cm against 433.3 cm");
  EXPECT_EQ(claim_less({}, b, a, {}).verdict, Verdict::fails);
  EXPECT_EQ(claim_less({}, std::array{no_figure}, b, {}).verdict, Verdict::undecided);
}

TEST(Findings, AtLeast) {
  const Claim claim = claim_at_least({}, std::array{0.4, 0.6}, 0.45, {.unit = "m"});
  EXPECT_EQ(claim.verdict, Verdict::holds);
  EXPECT_EQ(claim.holds_on, 1U);
  EXPECT_EQ(claim.evidence, "0.50 m on the mean, 0.40 m to 0.60 m; limit 0.45 m");
  EXPECT_EQ(claim_at_least({}, {}, 1.0, {}).verdict, Verdict::undecided);
}

TEST(Findings, Rows) {
  const StudyRow row = row_of({"gap", "ATM", "m", 2}, "> 0", std::array{1.0, 3.0});
  EXPECT_EQ(row.ours.mean, 2.0);
  EXPECT_EQ(row.paper_text, "> 0");
  EXPECT_EQ(figure_text(no_figure, 2, "m"), "-");
}

}  // namespace
}  // namespace echoarc::studies
