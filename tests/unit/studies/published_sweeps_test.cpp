// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/published_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "echoarc/eval/parameter_choice.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::studies {
namespace {

TEST(PublishedSweeps, SetOptionsThatTheMethodsHave) {
  std::set<std::string> ids;
  for (const PublishedSweep& sweep : published_sweeps()) {
    EXPECT_TRUE(ids.insert(sweep.id).second) << sweep.id;
    for (const PublishedValue& value : sweep.values) {
      OptionMap options = sweep.fixed;
      options[sweep.option] = value.value;
      const auto method = make_method(sweep.method, options);
      ASSERT_TRUE(method) << sweep.id << " " << method.error().message;
    }
  }
  EXPECT_EQ(ids.size(), 4U + 4U + 6U);
}

TEST(PublishedSweeps, HaveAsManyValuesAsThePaper) {
  for (const PublishedSweep& sweep : published_sweeps()) {
    const std::string table = sweep.id.substr(0, 2);
    const std::size_t values = table == "T2" ? 10 : table == "T3" ? 9 : table == "T4" ? 11 : table[0] == 'T' ? 8 : 91;
    EXPECT_EQ(sweep.values.size(), values) << sweep.id;
    const bool printed = table[0] == 'T' && !sweep.id.ends_with("-10");
    for (const PublishedValue& value : sweep.values) EXPECT_EQ(std::isfinite(value.mae_cm), printed) << sweep.id;
  }
}

// The printed overall ratio lies between the two it is made of, as counts of directions require.
TEST(PublishedSweeps, ArePrintedConsistently) {
  for (const PublishedSweep& sweep : published_sweeps())
    for (const PublishedValue& value : sweep.values) {
      if (!std::isfinite(value.cdr_overall)) continue;
      EXPECT_GE(value.cdr_overall, std::min(value.cdr_full, value.cdr_empty) - 5e-4) << sweep.id << " " << value.label;
      EXPECT_LE(value.cdr_overall, std::max(value.cdr_full, value.cdr_empty) + 5e-4) << sweep.id << " " << value.label;
    }
}

TEST(PublishedSweeps, NameTheLastThresholdAsPrinted) {
  const auto sweeps = published_sweeps();
  const auto bu = std::ranges::find(sweeps, "T4-bu", &PublishedSweep::id);
  ASSERT_NE(bu, sweeps.end());
  EXPECT_EQ(bu->values.front().label, "0.990");
  EXPECT_EQ(bu->values.back().label, "1.000");
  EXPECT_EQ(std::get<double>(bu->values.back().value), 0.9995);
}

}  // namespace
}  // namespace echoarc::studies
