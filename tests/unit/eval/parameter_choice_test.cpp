// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/parameter_choice.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

using Indices = std::vector<std::size_t>;

// [Barshan07] Table 2: voting in room (a), thresholds 1 to 10. The paper prints both 4 and 5.
TEST(ParameterChoice, TakesFiveInTheRoomAndNamesFour) {
  const std::vector<double> full{1.000, 1.000, .977, .951, .847, .813, .746, .717, .659, .604};
  const std::vector<double> empty{.348, .627, .764, .863, .926, .957, .969, .969, .969, .969};
  std::vector<ParameterScore> values;
  for (std::size_t k = 0; k < full.size(); ++k) values.push_back({full[k], empty[k], 0.5, 0.02});
  const auto choice = choose_parameter(values);
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->best, 4U);
  EXPECT_EQ(choice->candidates, (Indices{4, 3}));
}

// [Barshan07] Table 5: the rule takes n_t = 1 (.514) where the paper chose 2 (.647).
TEST(ParameterChoice, TakesOneTriangulation) {
  const std::vector<ParameterScore> values{{.443, .957, .517, .0663}, {.334, .981, .427, .0282}};
  EXPECT_EQ(choose_parameter(values)->candidates, Indices{0});
}

TEST(ParameterChoice, BreaksTiesByOverallRatioThenByError) {
  const std::vector<ParameterScore> values{
      {.8, .9, .84, .01}, {.9, .8, .86, .03}, {.9, .8, .86, .02}, {.9, .8, .86, .02}, {.9, .84, .5, .9}};
  EXPECT_EQ(choose_parameter(values)->candidates, (Indices{4, 2, 3, 1, 0}));
  EXPECT_EQ(choose_parameter(std::span(values).first(4))->best, 2U);
}

TEST(ParameterChoice, ASmallDifferenceOfRoundingIsATie) {
  const std::vector<ParameterScore> values{{0.3, 0.1 + 0.2, .5, .02}, {0.3, 0.3, .6, .03}};
  EXPECT_EQ(choose_parameter(values)->best, 1U);
}

TEST(ParameterChoice, LeavesOutWhatCannotBeJudged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(choose_parameter({}));
  EXPECT_FALSE(choose_parameter(std::vector<ParameterScore>{{nan, .9, .9, .1}}));
  EXPECT_EQ(choose_parameter(std::vector<ParameterScore>{{nan, .9, .9, .1}, {.1, .9, .5, .1}})->best, 1U);
}

}  // namespace
}  // namespace echoarc
