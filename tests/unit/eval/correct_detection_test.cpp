// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/correct_detection.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "points.hpp"

namespace echoarc {
namespace {

using test::point_set;
using test::reference_of;

/// Ten columns of 1 m, rows 0 to 9.
const DirectionSet ten_columns = column_directions({1.0, {0.0, 0.0}}, 10, 10);

TEST(CorrectDetection, CountsAgreementDirectionByDirection) {
  // Column:            0           1           2          3
  // reference          full        full        full       empty ...
  // map                far away    -           two        one
  const Reference reference = reference_of({{0.5, 9.5}, {1.5, 9.5}, {2.5, 9.5}});
  const PointSet map = point_set({{0.5, 0.5}, {2.5, 9.5}, {2.6, 1.5}, {3.5, 9.5}});
  const auto score = correct_detection(map, reference, ten_columns);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->full, 3U);
  EXPECT_EQ(score->empty, 7U);
  EXPECT_EQ(score->correct_full, 2U) << "no matter how far along the direction";
  EXPECT_EQ(score->correct_empty, 6U);
  EXPECT_NEAR(score->full_ratio(), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(score->empty_ratio(), 6.0 / 7.0, 1e-12);
  EXPECT_NEAR(score->overall_ratio(), 0.8, 1e-12);
}

TEST(CorrectDetection, AToleranceAsksForANearPoint) {
  const Reference reference = reference_of({{0.5, 9.5}, {1.5, 9.5}});
  const PointSet map = point_set({{0.5, 0.5}, {1.5, 9.0}, {2.5, 0.5}});
  const auto score = correct_detection(map, reference, ten_columns, 0.5);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->correct_full, 1U);
  EXPECT_EQ(score->correct_empty, 7U) << "a far point still fills a direction that ought to be empty";
  EXPECT_EQ(correct_detection(map, reference, ten_columns, 1e300)->correct_full, 2U);
  EXPECT_FALSE(correct_detection(map, reference, ten_columns, -0.1));
  EXPECT_FALSE(correct_detection(map, reference, ten_columns, std::numeric_limits<double>::quiet_NaN()));
}

TEST(CorrectDetection, AnEmptyMapFindsEmptyDirectionsAlone) {
  const auto score = correct_detection({}, reference_of({{0.5, 9.5}}), ten_columns);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->full_ratio(), 0.0);
  EXPECT_EQ(score->empty_ratio(), 1.0);
  EXPECT_EQ(score->overall_ratio(), 0.9);
}

TEST(CorrectDetection, ARatioOfNothingIsNoNumberAndLeftOut) {
  const auto all_empty = correct_detection({}, reference_of({{-5.0, 0.0}}), ten_columns);
  ASSERT_TRUE(all_empty);
  EXPECT_TRUE(std::isnan(all_empty->full_ratio()));
  EXPECT_EQ(all_empty->overall_ratio(), 1.0) << "of the empty directions alone";
  const auto no_lines = correct_detection(point_set({{0.0, 0.0}}), reference_of({{0.0, 0.0}}), DirectionSet{});
  ASSERT_TRUE(no_lines);
  EXPECT_TRUE(std::isnan(no_lines->overall_ratio()));
}

}  // namespace
}  // namespace echoarc
