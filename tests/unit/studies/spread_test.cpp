// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/spread.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Spread, OfSeveralValues) {
  const Spread spread = spread_of(std::vector{2.0, 4.0, 9.0});
  EXPECT_DOUBLE_EQ(spread.mean, 5.0);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(13.0));
  EXPECT_EQ(spread.min, 2.0);
  EXPECT_EQ(spread.max, 9.0);
  EXPECT_EQ(spread.values, 3u);
  EXPECT_EQ(spread.runs, 3u);
}

TEST(Spread, LeavesOutWhatIsNoNumber) {
  const Spread spread = spread_of(std::vector{nan, 3.0, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(spread.mean, 3.0);
  EXPECT_EQ(spread.deviation, 0.0);
  EXPECT_EQ(spread.values, 1u);
  EXPECT_EQ(spread.runs, 3u);
}

TEST(Spread, OfNothingIsNoNumber) {
  EXPECT_TRUE(std::isnan(spread_of({}).mean));
  EXPECT_TRUE(std::isnan(spread_of(std::vector{nan}).max));
  EXPECT_EQ(spread_of(std::vector{nan}).runs, 1u);
}

}  // namespace
}  // namespace echoarc::studies
