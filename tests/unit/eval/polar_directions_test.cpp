// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/correct_detection.hpp"
#include "echoarc/eval/directions.hpp"

namespace echoarc {
namespace {

const Box region{{-2.0, -2.0}, {2.0, 2.0}};

Reference reference_of(std::vector<Vec2> points) {
  return {PointSet::make(std::move(points)).value(), 0.0, "test"};
}

TEST(PolarDirections, FanOutFromAPoint) {
  const DirectionSet whole = polar_directions(region, {0.0, 0.0}, degrees(0.25));
  EXPECT_EQ(whole.line_count(), 1440);
  EXPECT_TRUE(validate(whole));
  const DirectionSet quarter = polar_directions(region, {0.0, 0.0}, degrees(1.0), degrees(45.0), degrees(135.0));
  EXPECT_EQ(quarter.line_count(), 90);
  EXPECT_EQ(polar_directions(region, {0.0, 0.0}, degrees(0.7), degrees(0.0), degrees(1.0)).line_count(), 2);
  EXPECT_EQ(polar_directions(region, {0.0, 0.0}, degrees(1.0), degrees(9.0), degrees(9.0)).line_count(), 0);
}

TEST(PolarDirections, ARayHasWhatLiesInItsWedge) {
  const DirectionSet fan = polar_directions(region, {0.5, 0.0}, degrees(10.0), degrees(-20.0), degrees(20.0));
  const auto point_at = [](double deg) { return Vec2{0.5, 0.0} + unit(degrees(deg)); };
  // Truth on rays 0 and 3; the map on rays 0 and 1.
  const auto score = correct_detection(PointSet::make({point_at(-15.0), point_at(-5.0)}).value(),
                                       reference_of({point_at(-19.0), point_at(11.0)}), fan);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->full, 2u);
  EXPECT_EQ(score->empty, 2u);
  EXPECT_EQ(score->correct_full, 1u);
  EXPECT_EQ(score->correct_empty, 1u);
}

TEST(PolarDirections, ACellLiesOnEveryRayWhoseMiddleItCovers) {
  const DirectionSet fan = polar_directions(region, {0.0, 0.0}, degrees(1.0));
  // Half a cell of 10 cm at 1 m is 2.86 degrees: middles at 0.5, 1.5 and 2.5 degrees on both sides.
  const auto score = correct_detection(PointSet::of_cells({{1.0, 0.0}}, 0.1).value(), reference_of({{1.0, 0.0}}), fan);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->correct_full, 1u);
  EXPECT_EQ(score->empty - score->correct_empty, 5u);
}

TEST(PolarDirections, TheCentreAndTheOutsideAreOnNoRay) {
  const DirectionSet fan = polar_directions(region, {0.0, 0.0}, degrees(1.0));
  const auto score = correct_detection({}, reference_of({{0.0, 0.0}, {3.0, 0.0}}), fan);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->full, 0u);
  EXPECT_EQ(score->correct_empty, 360u);
}

TEST(PolarDirections, RefusesFansThatCannotBe) {
  const auto refuses = [](RayFamily fan) { return !validate(DirectionSet{region, {}, {fan}}); };
  EXPECT_FALSE(refuses({{0.0, 0.0}, degrees(0.0), degrees(1.0), 360}));
  EXPECT_TRUE(refuses({{0.0, 0.0}, degrees(0.0), degrees(1.0), 361}));
  EXPECT_TRUE(refuses({{0.0, 0.0}, degrees(0.0), degrees(0.0), 1}));
  EXPECT_TRUE(refuses({{0.0, 0.0}, degrees(0.0), degrees(1.0), -1}));
  EXPECT_TRUE(refuses({{std::numeric_limits<double>::quiet_NaN(), 0.0}, degrees(0.0), degrees(1.0), 1}));
}

}  // namespace
}  // namespace echoarc
