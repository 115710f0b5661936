// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/point_set.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "points.hpp"

namespace echoarc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Vec2> list(const PointSet& set) {
  return {set.points().begin(), set.points().end()};
}

TEST(PointSet, RefusesPointsNoMapCanHave) {
  for (const double bad : {nan, infinity, -infinity, 1e300, -1.1e7}) {
    EXPECT_FALSE(PointSet::make({{0.0, 0.0}, {bad, 0.0}})) << bad;
    EXPECT_FALSE(PointSet::make({{0.0, bad}})) << bad;
    EXPECT_FALSE(PointSet::of_cells({{0.0, bad}}, 0.05)) << bad;
  }
  const auto refused = PointSet::make({{0.0, 0.0}, {nan, 0.0}});
  EXPECT_NE(refused.error().message.find("point 1"), std::string::npos) << refused.error().message;
  EXPECT_FALSE(refused.error().remedy.empty());
}

TEST(PointSet, RefusesCellsWithoutSize) {
  for (const double bad : {0.0, -0.05, nan, infinity}) EXPECT_FALSE(PointSet::of_cells({}, bad)) << bad;
}

TEST(PointSet, TakesOccupiedCellsAloneByTheirCentres) {
  DenseGrid<CellState> grid({0.1, {1.0, 2.0}}, 3, 2);
  grid.at({0, 0}) = CellState::free;
  grid.at({2, 0}) = CellState::occupied;
  grid.at({1, 1}) = CellState::occupied;
  const auto set = PointSet::of_occupied(grid);
  ASSERT_TRUE(set);
  ASSERT_EQ(set->size(), 2U);
  EXPECT_NEAR(set->points()[0].x, 1.25, 1e-12);
  EXPECT_NEAR(set->points()[0].y, 2.05, 1e-12);
  EXPECT_NEAR(set->points()[1].x, 1.15, 1e-12);
  EXPECT_EQ(set->cell_m(), 0.1);
}

TEST(PointSet, OfAnEmptyGridIsEmpty) {
  const auto set = PointSet::of_occupied(DenseGrid<CellState>{});
  ASSERT_TRUE(set);
  EXPECT_TRUE(set->empty());
}

TEST(PointSet, KeepsTheOrderOfAPointMap) {
  PointMap map;
  MapPoint point;
  for (const Vec2 position : {Vec2{2.0, 1.0}, Vec2{-1.0, 0.0}}) {
    point.position = position;
    map.add(point);
  }
  const auto set = PointSet::of_points(map);
  ASSERT_TRUE(set);
  EXPECT_EQ(list(*set), (std::vector<Vec2>{{2.0, 1.0}, {-1.0, 0.0}}));
  EXPECT_EQ(set->cell_m(), 0.0);
  point.position.y = nan;
  map.add(point);
  EXPECT_FALSE(PointSet::of_points(map));
}

TEST(PointSet, OnePerCellKeepsTheFirstOfEachCell) {
  const PointSet set = test::point_set({{0.04, 0.01}, {0.20, 0.20}, {0.01, 0.04}, {-0.01, 0.01}, {0.05, 0.01}});
  EXPECT_EQ(list(set.one_per_cell(0.05)), (std::vector<Vec2>{{0.04, 0.01}, {0.20, 0.20}, {-0.01, 0.01}, {0.05, 0.01}}));
  EXPECT_TRUE(PointSet{}.one_per_cell(0.05).empty());
}

}  // namespace
}  // namespace echoarc
