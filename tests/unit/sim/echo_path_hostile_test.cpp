// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Worlds and places that no robot should meet.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/sim/echo_paths.hpp"

namespace echoarc::sim {
namespace {

const Angle all_round = degrees(180.0);

std::size_t count(std::span<const EchoPath> paths, EchoCause cause) {
  return static_cast<std::size_t>(std::ranges::count(paths, cause, &EchoPath::cause));
}

TEST(HostilePing, OnAWallHearsNothingOfThatWall) {
  const World world = World::make({.walls = {{{-1.0, 0.0}, {1.0, 0.0}}, {{-1.0, 2.0}, {1.0, 2.0}}}}).value();
  PathFinder finder(world);
  const auto found = finder.find({{0.2, 0.0}, {}, all_round}, {{0.2, 0.0}, {}, all_round}, {.max_order = 1});
  ASSERT_EQ(count(found, EchoCause::wall), 1);
  EXPECT_DOUBLE_EQ(found.back().departure.deg(), found.back().arrival.deg());
}

TEST(HostilePing, InsideADiscHearsNothing) {
  const World world = World::make({.walls = {{{-1.0, 1.0}, {1.0, 1.0}}}, .discs = {{{0.0, 0.0}, 0.3}}}).value();
  PathFinder finder(world);
  EXPECT_TRUE(finder.find({{}, {}, all_round}, {{}, {}, all_round}, {}).empty());
}

TEST(HostilePing, WithoutAPlaceHearsNothing) {
  const World world = World::make({.walls = {{{-1.0, 1.0}, {1.0, 1.0}}}}).value();
  PathFinder finder(world);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Transducer good{{}, {}, all_round};
  EXPECT_TRUE(finder.find({{nan, 0.0}, {}, all_round}, good, {}).empty());
  EXPECT_TRUE(finder.find(good, {{}, radians(nan), all_round}, {}).empty());
  EXPECT_TRUE(finder.find(good, {{}, {}, radians(nan)}, {}).empty());
  EXPECT_TRUE(finder.find(good, good, {.max_length_m = nan}).empty());
  EXPECT_TRUE(finder.find({{1e300, 0.0}, {}, all_round}, {{1e300, 0.0}, {}, all_round}, {}).empty());
  EXPECT_FALSE(world.first_hit({nan, 0.0}, {1.0, 0.0}, 10.0));
}

TEST(HostilePing, OrdersOutOfRangeCountAsTheNearest) {
  const World world = World::make({.walls = {{{0.0, -9.0}, {0.0, 9.0}}, {{1.5, -9.0}, {1.5, 9.0}}}}).value();
  PathFinder finder(world);
  const Transducer ear{{0.4, 0.0}, {}, all_round};
  EXPECT_EQ(finder.find(ear, ear, {.max_order = 20}).size(), finder.find(ear, ear, {.max_order = 6}).size());
  EXPECT_EQ(finder.find(ear, ear, {.max_order = -3}).size(), finder.find(ear, ear, {.max_order = 1}).size());
}

TEST(HostileWorld, CoincidentWallsEchoOnce) {
  const World world = World::make({.walls = std::vector<Wall>(400, Wall{{-1.0, 1.0}, {1.0, 1.0}})}).value();
  PathFinder finder(world);
  const Transducer ear{{0.1, 0.0}, {}, all_round};
  const auto found = finder.find(ear, ear, {});
  EXPECT_EQ(count(found, EchoCause::wall), 1);
  EXPECT_EQ(count(found, EchoCause::multiple), 0);
  EXPECT_EQ(count(found, EchoCause::edge), 2);
}

TEST(HostileWorld, ABusyPingEndsAtItsBoundAndCounts) {
  Rng rng(5);
  WorldDescription description;
  for (int i = 0; i < 4000; ++i) {  // short walls at random: everything is seen from everywhere
    const Vec2 a{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)};
    description.walls.push_back({a, a + 0.004 * unit(degrees(rng.uniform(0.0, 360.0)))});
  }
  const World world = World::make(description).value();
  PathFinder finder(world);
  const Transducer ear{{}, {}, all_round};
  EXPECT_FALSE(finder.find(ear, ear, {.max_order = 6}).empty());
  EXPECT_EQ(finder.truncated(), 1);
}

TEST(HostileWorld, ManyWallsOverAWideFieldAreFound) {
  Rng rng(6);
  WorldDescription description;
  for (int i = 0; i < 50'000; ++i) {
    const Vec2 a{rng.uniform(-9e4, 9e4), rng.uniform(-9e4, 9e4)};
    description.walls.push_back({a, a + unit(degrees(rng.uniform(0.0, 360.0)))});
  }
  description.walls.push_back({{-1.0, 1.0}, {1.0, 1.0}});
  const World world = World::make(description).value();
  PathFinder finder(world);
  const Transducer ear{{}, degrees(90.0), degrees(25.0)};
  ASSERT_EQ(finder.find(ear, ear, {}).size(), 1);
  EXPECT_DOUBLE_EQ(finder.find(ear, ear, {})[0].length_m, 2.0);
}

TEST(HostileWorld, LongWallsAllThroughOnePlace) {
  WorldDescription description;
  for (int i = 0; i < 500; ++i) {
    const Vec2 end = 100.0 * unit(degrees(0.36 * i));
    description.walls.push_back({end, -end});
  }
  const World world = World::make(description).value();
  EXPECT_FALSE(world.visible({50.0, 0.1}, {50.0, -0.1}));
  EXPECT_NEAR(world.first_hit({0.0, 50.1}, {0.0, -1.0}, 60.0)->distance_m, 50.1, 50.1);
}

}  // namespace
}  // namespace echoarc::sim
