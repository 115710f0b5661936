// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/cost_map.hpp"
#include "echoarc/nav/path.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

DenseGrid<float> costs_of(std::int32_t width, std::int32_t height, float cost_per_m = 1.0F) {
  return {{0.1, {}}, width, height, cost_per_m};
}

TEST(Path, CostOfAStraightWayByTheLengthInEachCell) {
  DenseGrid<float> costs = costs_of(4, 1);
  costs.at({1, 0}) = 3.0F;
  EXPECT_NEAR(*straight_cost(costs, {0.05, 0.05}, {0.35, 0.05}), 0.05 + 0.1 * 3.0 + 0.1 + 0.05, 1e-12);
  EXPECT_NEAR(*straight_cost(costs, {0.12, 0.02}, {0.18, 0.02}), 0.06 * 3.0, 1e-12);
  EXPECT_EQ(straight_cost(costs, {0.15, 0.05}, {0.15, 0.05}), 0.0);
}

TEST(Path, AWayThroughACornerTouchesAllFourCells) {
  for (const Cell blocked : {Cell{0, 1}, Cell{1, 0}}) {
    DenseGrid<float> costs = costs_of(2, 2);
    EXPECT_NEAR(*straight_cost(costs, {0.05, 0.05}, {0.15, 0.15}), 0.1 * std::numbers::sqrt2, 1e-12);
    costs.at(blocked) = 0.0F;
    EXPECT_FALSE(straight_cost(costs, {0.05, 0.05}, {0.15, 0.15}));
    EXPECT_FALSE(straight_cost(costs, {0.15, 0.15}, {0.05, 0.05}));
  }
}

TEST(Path, NoWayOffTheGridOrToNoPlace) {
  const DenseGrid<float> costs = costs_of(5, 5);
  EXPECT_FALSE(straight_cost(costs, {0.25, 0.25}, {0.25, 0.75}));
  EXPECT_FALSE(straight_cost(costs, {-0.5, 0.25}, {0.25, 0.25}));
  EXPECT_FALSE(straight_cost(costs, {0.25, 0.25}, {1e300, 0.25}));
  EXPECT_FALSE(straight_cost(costs, {0.25, 0.25}, {std::nan(""), 0.25}));
  EXPECT_FALSE(straight_cost({}, {}, {}));
  const DenseGrid<CellState> map = drawn_map({"  #  ", "?????"});
  EXPECT_FALSE(in_sight(map, {0.05, 0.15}, {0.45, 0.15}));
  EXPECT_TRUE(in_sight(map, {0.05, 0.05}, {0.45, 0.05})) << "through the unknown";
  EXPECT_FALSE(in_sight(map, {0.05, 0.05}, {0.05, 0.55}));
}

TEST(Path, ShortcutGoesStraightWhereNothingStandsInTheWay) {
  const std::vector<Vec2> stairs{{0.05, 0.05}, {0.15, 0.05}, {0.25, 0.15}, {0.35, 0.15}, {0.45, 0.25}};
  DenseGrid<float> costs = costs_of(5, 5);
  EXPECT_EQ(shortcut(costs, stairs), (std::vector<Vec2>{stairs.front(), stairs.back()}));
  costs.at({2, 1}) = 0.0F;
  const std::vector<Vec2> around{{0.05, 0.15}, {0.05, 0.05}, {0.25, 0.05}, {0.45, 0.05}, {0.45, 0.15}};
  const std::vector<Vec2> shorter = shortcut(costs, around);
  EXPECT_TRUE(path_cost(costs, shorter));
  EXPECT_LT(length_m(shorter), length_m(around));
  EXPECT_TRUE(shortcut(costs, {}).empty());
  EXPECT_EQ(shortcut(costs, std::vector<Vec2>{{0.05, 0.05}}).size(), 1U);
}

TEST(Path, ShortcutKeepsTheClearanceThatWasPaidFor) {
  DenseGrid<float> costs = costs_of(40, 12);
  for (std::int32_t i = 5; i < 35; ++i)
    for (std::int32_t j = 0; j < 6; ++j) costs.at({i, j}) = 5.0F;
  const std::vector<Vec2> around{{0.05, 0.05}, {0.05, 0.65}, {0.45, 0.65}, {3.55, 0.65}, {3.95, 0.65}, {3.95, 0.05}};
  const std::vector<Vec2> shorter = shortcut(costs, around);
  EXPECT_GT(shorter.size(), 2U) << "straight is shorter, but dearer";
  EXPECT_LE(*path_cost(costs, shorter), *path_cost(costs, around));
}

TEST(Path, PlacesOnAPath) {
  const std::vector<Vec2> path{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}};
  EXPECT_DOUBLE_EQ(length_m(path), 3.0);
  EXPECT_EQ(point_at(path, 2.5), (Vec2{2.0, 0.5}));
  EXPECT_EQ(point_at(path, -1.0), path.front());
  EXPECT_EQ(point_at(path, 9.0), path.back());
  const auto place = nearest_place(path, {1.2, 0.3}, 0.0, infinite);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->leg, 0U);
  EXPECT_DOUBLE_EQ(place->along_m, 1.2);
  EXPECT_DOUBLE_EQ(place->distance_m, 0.3);
  EXPECT_DOUBLE_EQ(nearest_place(path, {1.2, 0.3}, 2.5, infinite)->along_m, 2.5) << "of the stretch that is asked for";
  EXPECT_DOUBLE_EQ(nearest_place(path, {1.9, 5.0}, 0.0, 2.25)->along_m, 2.25);
  EXPECT_FALSE(nearest_place({}, {}, 0.0, infinite));
  EXPECT_DOUBLE_EQ(nearest_place(std::vector<Vec2>{{1.0, 1.0}}, {1.0, 3.0}, 0.0, infinite)->distance_m, 2.0);
}

/// The cells between two places by looking closely.
RC_GTEST_PROP(PathProperty, CostIsWhatSamplingTheWayGives, (std::uint64_t seed)) {
  Rng rng(seed);
  const DenseGrid<CellState> map = random_map(rng, 30);
  CostMap costs({.unknown_passable = true}, 0.1);
  costs.update(map);
  const Vec2 a = random_place(rng, map);
  const Vec2 b = random_place(rng, map);
  constexpr int samples = 4000;
  double sum = 0.0;
  bool clear = true;
  for (int k = 0; k < samples; ++k) {
    const Cell c = map.geometry().cell_of(a + (k + 0.5) / samples * (b - a));
    clear = clear && costs.cost_per_m().at(c) > 0.0F;
    sum += norm(b - a) / samples * double(costs.cost_per_m().at(c));
  }
  const auto cost = straight_cost(costs.cost_per_m(), a, b);
  if (cost) RC_ASSERT(clear);
  if (cost) RC_ASSERT(std::abs(*cost - sum) < 0.01 * (1.0 + sum));
  const auto back = straight_cost(costs.cost_per_m(), b, a);
  RC_ASSERT(back.has_value() == cost.has_value());
  if (cost) RC_ASSERT(std::abs(*cost - *back) < 1e-9 * (1.0 + sum));
}

}  // namespace
}  // namespace echoarc::nav
