// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/wall_distance.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "points.hpp"

namespace echoarc {
namespace {

using test::point_set;
using test::reference_of;

TEST(WallDistance, SharesAndDistances) {
  const Reference wall = reference_of({{0.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {9.0, 1.0}});
  const PointSet map = point_set({{0.0, 1.04}, {1.0, 1.09}, {1.0, 1.19}, {2.0, 1.5}});
  const auto score = wall_distance(map, wall, point_set({{1.0, 0.0}})).all;
  EXPECT_EQ(score.points, 4U);
  EXPECT_EQ(score.accuracy, (std::array{0.25, 0.5, 0.75}));
  EXPECT_NEAR(score.mean_m, (0.04 + 0.09 + 0.19 + 0.5) / 4, 1e-12);
  EXPECT_NEAR(score.median_m, 0.14, 1e-12);
  EXPECT_NEAR(score.p95_m, 0.5, 1e-12);
  EXPECT_EQ(score.reference_points, 3U) << "the fourth is 8 m from the path";
  EXPECT_EQ(score.covered_points, 2U);
  EXPECT_NEAR(score.coverage, 2.0 / 3.0, 1e-12);
}

TEST(WallDistance, WholeCellsApartIsNotFurtherByRounding) {
  // 0.8 - 0.7 exceeds 0.1 in doubles.
  const auto score = wall_distance(point_set({{0.8, 0.0}}), reference_of({{0.7, 0.0}}), point_set({{3.2, 0.0}}));
  EXPECT_GT(0.8 - 0.7, 0.1);
  EXPECT_EQ(score.all.accuracy[1], 1.0);
  EXPECT_EQ(score.all.coverage, 1.0);
  EXPECT_EQ(score.all.reference_points, 1U) << "2.5 m from the path";
}

TEST(WallDistance, OnePerCellTakesTheWeightFromClusters) {
  std::vector<Vec2> points(99, Vec2{0.01, 0.01});
  points.push_back({5.01, 0.01});
  const auto score = wall_distance(point_set(points), reference_of({{0.0, 0.0}}), point_set({{0.0, 0.0}}));
  EXPECT_EQ(score.all.points, 100U);
  EXPECT_EQ(score.all.accuracy[0], 0.99);
  EXPECT_EQ(score.one_per_cell.points, 2U);
  EXPECT_EQ(score.one_per_cell.accuracy[0], 0.5);
  EXPECT_EQ(score.one_per_cell.coverage, 1.0);
}

TEST(WallDistance, OfAnEmptyMap) {
  const auto score = wall_distance({}, reference_of({{0.0, 0.0}}), point_set({{0.0, 0.0}}));
  for (const WallDistance& one : {score.all, score.one_per_cell}) {
    EXPECT_EQ(one.points, 0U);
    EXPECT_TRUE(std::isnan(one.accuracy[0]));
    EXPECT_TRUE(std::isnan(one.mean_m));
    EXPECT_TRUE(std::isnan(one.p95_m));
    EXPECT_EQ(one.coverage, 0.0);
  }
}

TEST(WallDistance, WithoutAPathNothingCanBeCovered) {
  const auto score = wall_distance(point_set({{0.0, 0.0}}), reference_of({{0.0, 0.0}}), {});
  EXPECT_EQ(score.all.accuracy[0], 1.0);
  EXPECT_EQ(score.all.reference_points, 0U);
  EXPECT_TRUE(std::isnan(score.all.coverage));
}

}  // namespace
}  // namespace echoarc
