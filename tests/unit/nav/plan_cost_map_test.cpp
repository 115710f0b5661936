// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/cost_map.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

TEST(CostMap, CostRisesTowardsAnObstacle) {
  DenseGrid<CellState> map = free_map(20, 3);
  map.at({0, 1}) = CellState::occupied;
  CostMap costs({.margin_m = 0.05, .clearance_m = 0.5, .clearance_weight = 2.0}, 0.2);
  costs.update(map);
  EXPECT_DOUBLE_EQ(costs.inflation_m(), 0.25);
  EXPECT_EQ(costs.cost_per_m().at({2, 1}), 0.0F) << "0.2 m from it";
  EXPECT_NEAR(costs.cost_per_m().at({3, 1}), 1.0 + 2.0 * (1.0 - 0.3 / 0.5), 1e-6);
  EXPECT_NEAR(costs.cost_per_m().at({5, 1}), 1.0, 1e-6);
  EXPECT_FLOAT_EQ(costs.cost_per_m().at({15, 1}), 1.0F);
}

TEST(CostMap, UnknownCellsArePassableByOption) {
  const DenseGrid<CellState> map = drawn_map({"  ??  "});
  CostMap wary({}, 0.1);
  wary.update(map);
  EXPECT_EQ(wary.cost_per_m().at({2, 0}), 0.0F);
  CostMap bold({.unknown_passable = true}, 0.1);
  bold.update(map);
  EXPECT_EQ(bold.cost_per_m().at({2, 0}), 1.0F);
}

TEST(CostMap, TakesFinerCellsTogether) {
  CostMap costs({.cell_m = 0.1}, 0.0);
  costs.update(drawn_map({"??? ??", "?#?? ?"}, 0.05));
  EXPECT_DOUBLE_EQ(costs.geometry().cell_m, 0.1);
  ASSERT_EQ(costs.cells().box(), (CellBox{0, 0, 3, 1}));
  EXPECT_EQ(costs.cells().at({0, 0}), CellState::occupied) << "one occupied part makes it so";
  EXPECT_EQ(costs.cells().at({1, 0}), CellState::free) << "known in part is known";
  EXPECT_EQ(costs.cells().at({2, 0}), CellState::free);
  CostMap coarse({.cell_m = 0.1}, 0.0);
  coarse.update(drawn_map({"  #"}, 0.3));
  EXPECT_DOUBLE_EQ(coarse.geometry().cell_m, 0.3) << "cells are never split";
}

TEST(CostMap, TellsWhatChanged) {
  DenseGrid<CellState> map = free_map(50, 40);
  CostMap costs({}, 0.2);
  EXPECT_EQ(costs.update(map), map.box());
  EXPECT_TRUE(costs.update(map).empty());
  map.at({7, 9}) = CellState::occupied;
  map.at({12, 30}) = CellState::unknown;
  EXPECT_EQ(costs.update(map), (CellBox{7, 9, 13, 31}));
  EXPECT_TRUE(costs.update({}).empty()) << "no map changes nothing";
  EXPECT_EQ(costs.rebuilds(), 1U);
}

TEST(CostMap, FollowsAMapThatGrows) {
  CostMap costs({}, 0.2);
  costs.update(free_map(30, 30));
  costs.update(free_map(40, 30, 0.1, {-1.0, 0.0}));
  EXPECT_EQ(costs.rebuilds(), 2U);
  EXPECT_EQ(costs.cells().at(costs.geometry().cell_of({-0.95, 0.05})), CellState::free);
  const CellBox changed = costs.update(free_map(50, 30, 0.1, {-2.0, 0.0}));
  EXPECT_EQ(costs.rebuilds(), 2U) << "there was room for it";
  EXPECT_EQ(changed.width(), 10);
  EXPECT_EQ(costs.cells().at(costs.geometry().cell_of({-1.95, 0.05})), CellState::free);
  EXPECT_EQ(costs.cells().at(costs.geometry().cell_of({-2.05, 0.05})), CellState::unknown);
}

TEST(CostMap, WhereTheRobotHasDrivenNothingStands) {
  DenseGrid<CellState> map = free_map(40, 20);
  occupy(map, {{2.0, 0.0}, {2.1, 2.0}});
  CostMap costs({}, 0.225);
  costs.update(map);
  const auto cost_at = [&](Vec2 p) { return costs.cost_per_m().at(costs.geometry().cell_of(p)); };
  ASSERT_EQ(cost_at({2.05, 1.05}), 0.0F);
  const std::uint64_t version = costs.version();
  const CellBox changed = costs.drive_through({1.05, 1.05}, {3.05, 1.05});
  EXPECT_TRUE(changed.contains(costs.geometry().cell_of({2.05, 1.05})));
  EXPECT_NE(costs.version(), version);
  for (double x = 1.05; x < 3.1; x += 0.1) EXPECT_GT(cost_at({x, 1.05}), 0.0F) << x;
  EXPECT_EQ(costs.cells().at(costs.geometry().cell_of({2.05, 1.15})), CellState::free) << "under its body";
  EXPECT_EQ(costs.cells().at(costs.geometry().cell_of({2.05, 1.35})), CellState::occupied) << "beside it";
  EXPECT_EQ(cost_at({2.05, 1.15}), 0.0F) << "its centre was not there";
  occupy(map, {{2.2, 0.0}, {2.3, 2.0}});
  costs.update(map);
  EXPECT_GT(cost_at({2.25, 1.05}), 0.0F) << "whatever the map comes to say";
  costs.update(free_map(60, 20, 0.1, {-1.0, 0.0}));
  occupy(map, {{1.5, 0.0}, {1.6, 2.0}});
  costs.update(map);
  EXPECT_GT(cost_at({1.55, 1.05}), 0.0F) << "nor how large it grows";
  EXPECT_TRUE(costs.drive_through({1.05, 1.05}, {3.05, 1.05}).empty());
  EXPECT_TRUE(costs.drive_through({1e9, 0.0}, {std::nan(""), 0.0}).empty());
}

/// Like a map built at once of what the other one shows.
bool equals_a_new_one(const CostMap& costs, const CostMapOptions& options, double radius_m) {
  CostMap fresh({.cell_m = costs.geometry().cell_m,
                 .margin_m = options.margin_m,
                 .clearance_m = options.clearance_m,
                 .clearance_weight = options.clearance_weight,
                 .unknown_passable = options.unknown_passable},
                radius_m);
  fresh.update(costs.cells());
  return std::ranges::equal(fresh.cells().values(), costs.cells().values()) &&
         std::ranges::equal(fresh.clearance_m().values(), costs.clearance_m().values()) &&
         std::ranges::equal(fresh.cost_per_m().values(), costs.cost_per_m().values());
}

RC_GTEST_PROP(CostMapProperty, ChangesAndGrowthGiveWhatANewMapGives, (std::uint64_t seed)) {
  Rng rng(seed);
  DenseGrid<CellState> map = random_map(rng, 40);
  const CostMapOptions options{.cell_m = rng.uniform() < 0.5 ? 0.1 : 0.2, .unknown_passable = rng.uniform() < 0.5};
  CostMap costs(options, 0.225);
  costs.update(map);
  for (int k = 0; k < 6; ++k) {
    if (rng.uniform() < 0.3) {  // moved, grown or shrunk on its lattice
      const Vec2 shift = 0.1 * Vec2{double(rng.below(5)) - 3.0, double(rng.below(5)) - 3.0};
      DenseGrid<CellState> next({0.1, map.geometry().origin + shift}, std::int32_t(1 + rng.below(40)),
                                std::int32_t(1 + rng.below(40)));
      for (CellState& state : next.values()) state = CellState(rng.below(40) == 0 ? 2 : rng.below(2));
      map = next;
    } else {
      change_at_random(rng, map);
    }
    costs.update(map);
    RC_ASSERT(equals_a_new_one(costs, options, 0.225));
  }
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i)
      if (map.at({i, j}) == CellState::occupied)
        RC_ASSERT(costs.cells().at(costs.geometry().cell_of(map.geometry().centre({i, j}))) == CellState::occupied);
}

}  // namespace
}  // namespace echoarc::nav
