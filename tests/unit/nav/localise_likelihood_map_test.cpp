// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/likelihood_map.hpp"
#include "localise_ray_world.hpp"

namespace echoarc::nav {
namespace {

using testing::grid_of;
using testing::odd_room;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Every cell asked for every occupied one.
double slow_distance_m(const DenseGrid<CellState>& grid, Vec2 p) {
  const Vec2 here = grid.geometry().centre(grid.geometry().cell_of(p));
  double least = LikelihoodMap::cap_m;
  for (std::int32_t j = 0; j < grid.height(); ++j)
    for (std::int32_t i = 0; i < grid.width(); ++i)
      if (grid.at({i, j}) == CellState::occupied) least = std::min(least, norm(grid.geometry().centre({i, j}) - here));
  return least;
}

Vec2 place_around(const DenseGrid<CellState>& grid, Rng& rng, double beyond_m) {
  const double x = rng.uniform(-beyond_m, grid.width() * grid.geometry().cell_m + beyond_m);
  return grid.geometry().origin + Vec2{x, rng.uniform(-beyond_m, grid.height() * grid.geometry().cell_m + beyond_m)};
}

TEST(LikelihoodMap, KnowsTheDistanceToTheNearestWallOfAnyPlace) {
  for (const double cell_m : {0.05, 0.12}) {
    const auto grid = grid_of(odd_room(), cell_m);
    const LikelihoodMap map(grid);
    Rng rng(7);
    for (int n = 0; n < 1000; ++n) {
      const Vec2 p = place_around(grid, rng, 1.0);
      ASSERT_NEAR(map.wall_distance_m(p), slow_distance_m(grid, p), 0.5 * LikelihoodMap::step_m + 1e-9);
    }
  }
}

TEST(LikelihoodMap, IsAsFarAsCanBeFromNowhereAndFromNoPlaceAtAll) {
  const LikelihoodMap map(grid_of(odd_room()));
  EXPECT_DOUBLE_EQ(map.wall_distance_m({1e9, -1e9}), LikelihoodMap::cap_m);
  EXPECT_DOUBLE_EQ(map.wall_distance_m({nan, 1.0}), LikelihoodMap::cap_m);
  EXPECT_FALSE(map.may_stand({nan, 1.0}));
  EXPECT_FALSE(map.may_stand({100.0, 1.0}));
  EXPECT_FALSE(map.may_stand({0.0, 1.0}));
  EXPECT_TRUE(map.may_stand({1.0, 1.0}));
}

TEST(LikelihoodMap, HoldsNothingOfAnEmptyOrUnknownMap) {
  EXPECT_FALSE(LikelihoodMap().has_walls());
  EXPECT_FALSE(LikelihoodMap(DenseGrid<CellState>()).has_floor());
  const LikelihoodMap unknown(DenseGrid<CellState>({0.05, {}}, 20, 20, CellState::unknown));
  EXPECT_FALSE(unknown.has_walls());
  EXPECT_FALSE(unknown.has_floor());
  EXPECT_DOUBLE_EQ(unknown.wall_distance_m({0.5, 0.5}), LikelihoodMap::cap_m);
  EXPECT_FALSE(unknown.blocked({0.0, 0.0}, {1.0, 1.0}));
}

TEST(LikelihoodMap, RaysAreBlockedWhereTheyGoThroughAWall) {
  const auto grid = grid_of(odd_room());
  const LikelihoodMap map(grid);
  Rng rng(3);
  for (int n = 0; n < 2000; ++n) {
    const Vec2 from = place_around(grid, rng, 0.3);
    const Vec2 to = place_around(grid, rng, 0.3);
    // Cells in which a fine walk takes so many steps: a few are a cut corner.
    constexpr double fine_m = 0.005;
    int steps_in_wall = 0;
    for (double t = 0.0; t < norm(to - from); t += fine_m) {
      const Cell cell = grid.geometry().cell_of(from + t / norm(to - from) * (to - from));
      if (grid.box().contains(cell) && grid.at(cell) == CellState::occupied) ++steps_in_wall;
    }
    if (steps_in_wall == 0) {
      ASSERT_FALSE(map.blocked(from, to));
    } else if (steps_in_wall * fine_m > 0.15) {
      ASSERT_TRUE(map.blocked(from, to));
    }
  }
}

TEST(LikelihoodMap, PlacesAreAllOverTheFloorAndNowhereElse) {
  const auto grid = grid_of(odd_room());
  const LikelihoodMap map(grid);
  Rng rng(1);
  Vec2 sum;
  constexpr int count = 4000;
  for (int n = 0; n < count; ++n) {
    const Vec2 p = map.any_place(rng);
    ASSERT_EQ(grid.at(grid.geometry().cell_of(p)), CellState::free);
    sum = sum + p;
  }
  Vec2 mean;
  int free = 0;
  for (std::int32_t j = 0; j < grid.height(); ++j)
    for (std::int32_t i = 0; i < grid.width(); ++i)
      if (grid.at({i, j}) == CellState::free) {
        mean = mean + grid.geometry().centre({i, j});
        ++free;
      }
  EXPECT_NEAR(map.floor_m2(), free * 0.0025, 1e-9);
  EXPECT_LT(norm(sum / count - mean / free), 0.1);  // four standard errors
}

/// One reading by the formula, without any short cut.
double slow_weight(const DenseGrid<CellState>& grid, const Pose2& T_map_sensor, double range_m, Angle beam,
                   const ReadingModelOptions& o) {
  double delta = LikelihoodMap::cap_m;
  const int pieces = static_cast<int>(std::ceil(range_m * beam.rad() / o.spacing_m));
  for (int k = 0; k <= pieces; ++k)
    delta = std::min(delta,
                     slow_distance_m(grid, T_map_sensor * (range_m * unit(-0.5 * beam + (double(k) / pieces) * beam))));
  return o.hit_share * std::exp(-0.5 * std::pow(delta / o.sigma_m, 2)) + o.random_share;
}

TEST(ReadingProbes, WeighAsTheFormulaDoes) {
  const auto grid = grid_of(odd_room(), 0.1);
  const LikelihoodMap map(grid);
  const ReadingModelOptions options;
  Rng rng(11);
  double largest = 0.0;
  for (int n = 0; n < 200; ++n) {
    const Pose2 T_odom_robot{{rng.uniform(-3, 3), rng.uniform(-3, 3)}, degrees(rng.uniform(-180, 180))};
    const Pose2 T_robot_sensor{{0.1, -0.2}, degrees(rng.uniform(-180, 180))};
    const Pose2 T_map_robot{place_around(grid, rng, 0.0), degrees(rng.uniform(-180, 180))};
    Reading reading;
    reading.T_world_tx = reading.T_world_rx = T_odom_robot * T_robot_sensor;
    const double range_m = rng.uniform(0.2, 3.0);
    reading.outcome = Echo{range_m};
    ReadingProbes probes(map, options);
    ASSERT_TRUE(probes.add(reading, T_odom_robot));
    const Pose2 T_map_sensor = T_map_robot * T_robot_sensor;
    double weight = slow_weight(grid, T_map_sensor, range_m, reading.beam_width, options);
    const Vec2 before = T_map_sensor * Vec2{range_m - options.through_wall_margin_m, 0.0};
    if (range_m > options.through_wall_margin_m && map.blocked(T_map_sensor.position, before)) weight *= 0.2;
    const ReadingFit fit = probes.fit(T_map_robot);
    // Beyond four sigma a hit counts for nothing; distances are kept in steps of 2 mm.
    ASSERT_NEAR(fit.mean_echo, weight, 0.015);
    ASSERT_NEAR(fit.log_likelihood, std::log(fit.mean_echo), 1e-9);
    largest = std::max(largest, weight);
  }
  EXPECT_GT(largest, 0.99);
}

Reading ahead(Outcome outcome) {
  Reading reading;
  reading.outcome = outcome;
  return reading;
}

/// A wall across the x axis in the column of cells from 2.00 m to 2.05 m.
LikelihoodMap wall_ahead() {
  DenseGrid<CellState> grid({0.05, {0.0, -2.0}}, 80, 80, CellState::free);
  for (std::int32_t j = 0; j < 80; ++j) grid.at({40, j}) = CellState::occupied;
  return LikelihoodMap(grid);
}

double weight(const Outcome& outcome, const Pose2& T_map_robot) {
  const LikelihoodMap map = wall_ahead();
  ReadingProbes probes(map, {});
  EXPECT_TRUE(probes.add(ahead(outcome), {}));
  return std::exp(probes.fit(T_map_robot).log_likelihood);
}

TEST(ReadingProbes, WorkedNumbers) {
  const Pose2 T_map_robot{{1.0, 0.0}, {}};
  EXPECT_NEAR(weight(Echo{1.02}, T_map_robot), 1.0, 1e-9);  // 0.9 + 0.1
  // Two cells short of the wall at its best: delta = 0.10 m, 0.9 exp(-0.78125) + 0.1 = 0.512050.
  EXPECT_NEAR(weight(Echo{0.92}, T_map_robot), 0.512050, 1e-6);
  // What is farther than four sigma counts as four: 0.9 exp(-8) + 0.1 = 0.100302.
  EXPECT_NEAR(weight(Echo{0.5}, T_map_robot), 0.100302, 1e-6);
  // The arc of 2.5 m lies 1.44 m behind the wall at least: chance, and through the wall.
  EXPECT_NEAR(weight(Echo{2.5}, T_map_robot), 0.100302 * 0.2, 1e-6);
  EXPECT_NEAR(weight(NoEcho{}, T_map_robot), 0.5, 1e-9);
  EXPECT_NEAR(weight(NoEcho{}, {{1.0, 0.0}, degrees(180.0)}), 1.0, 1e-9);
}

TEST(ReadingProbes, TakeOnlyWhatTellsSomething) {
  const LikelihoodMap map = wall_ahead();
  ReadingProbes probes(map, {});
  EXPECT_FALSE(probes.add(ahead(TooClose{}), {}));
  EXPECT_FALSE(probes.add(ahead(Invalid{}), {}));
  EXPECT_FALSE(probes.add(ahead(Echo{7.0}), {}));
  EXPECT_FALSE(probes.add(ahead(Echo{0.0}), {}));
  EXPECT_FALSE(probes.add(ahead(Echo{nan}), {}));
  EXPECT_FALSE(probes.add(ahead(Echo{1.0}), {{nan, 0.0}, {}}));
  Reading lost = ahead(Echo{1.0});
  lost.T_world_tx.position.x = nan;
  EXPECT_FALSE(probes.add(lost, {}));
  Reading wide = ahead(Echo{1.0});
  wide.beam_width = degrees(200.0);
  EXPECT_FALSE(probes.add(wide, {}));
  EXPECT_EQ(probes.size(), 0U);
  EXPECT_EQ(probes.fit({}).log_likelihood, 0.0);
  EXPECT_EQ(probes.fit({}).mean_echo, 0.0);
  EXPECT_TRUE(probes.add(ahead(NoEcho{}), {}));
  EXPECT_EQ(probes.echoes(), 0U);
  EXPECT_TRUE(probes.add(ahead(Echo{1.0}), {}));
  EXPECT_EQ(probes.echoes(), 1U);
}

TEST(ReadingProbes, ReadingsOfOtherTransmittersLieOnTheirEllipse) {
  const LikelihoodMap map = wall_ahead();
  Reading reading = ahead(Echo{1.02});
  reading.rx = 1;
  reading.T_world_tx.position = {0.0, 0.2};
  reading.T_world_rx.position = {0.0, -0.2};
  ReadingProbes probes(map, {});
  ASSERT_TRUE(probes.add(reading, {}));
  // |P - tx| + |P - rx| = 2.04 m on the axis: x = sqrt(1.02^2 - 0.2^2) = 1.000200 m from the foci.
  EXPECT_NEAR(probes.fit({{1.02, 0.0}, {}}).mean_echo, 1.0, 1e-9);
  EXPECT_LT(probes.fit({{0.8, 0.0}, {}}).mean_echo, 0.3);
}

}  // namespace
}  // namespace echoarc::nav
