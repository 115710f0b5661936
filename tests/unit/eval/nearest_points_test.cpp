// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/nearest_points.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/mean_absolute_error.hpp"
#include "points.hpp"

namespace echoarc {
namespace {

using test::point_set;
using test::reference_of;

TEST(NearestPoints, AmongNoneIsInfinitelyFar) {
  const PointSet none;
  EXPECT_EQ(NearestPoints(none).distance_m({1.0, 2.0}), std::numeric_limits<double>::infinity());
}

TEST(NearestPoints, AmongOneIsThatOne) {
  const PointSet one = point_set({{3.0, 4.0}});
  EXPECT_EQ(NearestPoints(one).distance_m({0.0, 0.0}), 5.0);
}

TEST(NearestPoints, CopesWithManyEqualPoints) {
  const PointSet same = point_set(std::vector<Vec2>(1000, Vec2{1.0, 1.0}));
  EXPECT_EQ(NearestPoints(same).distance_m({1.0, 3.0}), 2.0);
}

TEST(NearestPoints, CanBeMoved) {
  const PointSet one = point_set({{3.0, 4.0}});
  NearestPoints first(one);
  const NearestPoints second = std::move(first);
  EXPECT_EQ(second.distance_m({3.0, 5.0}), 1.0);
}

// V5.1 of the method specification, in metres.
TEST(MeanAbsoluteError, WorkedNumbers) {
  std::vector<Vec2> wall;
  for (int x = 0; x <= 100; ++x) wall.push_back({double(x), 100.0});
  const PointSet map = point_set({{10, 101}, {20, 98}, {50, 100}, {60, 130}});
  const Reference reference = reference_of(wall);
  EXPECT_EQ(nearest_distances_m(map, reference.points), (std::vector<double>{1, 2, 0, 30}));
  EXPECT_EQ(mean_absolute_error_m(map, reference), 8.25);
}

TEST(MeanAbsoluteError, OfAnEmptyMapIsNoNumber) {
  EXPECT_TRUE(std::isnan(mean_absolute_error_m({}, reference_of({{0.0, 0.0}}))));
}

TEST(MeanAbsoluteError, OfTheReferenceItselfIsZero) {
  const Reference reference = reference_of({{0.0, 0.0}, {1.0, 0.3}, {2.0, -7.0}});
  EXPECT_EQ(mean_absolute_error_m(reference.points, reference), 0.0);
}

}  // namespace
}  // namespace echoarc
