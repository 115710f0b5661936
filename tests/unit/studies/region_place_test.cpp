// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/choset/region_place.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "unit/sim/small_scene.hpp"

namespace echoarc::studies::choset {
namespace {

DepthRegion ahead(double depth_m) {
  return {.position = {1.0, 1.5}, .depth_m = depth_m, .bearing = Angle{}};
}

TEST(RegionPlace, OnBeforeAndBeyondAWall) {
  const auto world = sim::World::make(sim::box_world(4.0, 3.0));
  ASSERT_TRUE(world);
  EXPECT_EQ(place_of(ahead(2.95), *world), RegionPlace::on_surface);
  EXPECT_EQ(place_of(ahead(3.05), *world), RegionPlace::on_surface);
  EXPECT_EQ(place_of(ahead(2.0), *world), RegionPlace::before);
  EXPECT_EQ(place_of(ahead(4.0), *world), RegionPlace::beyond);
}

TEST(RegionPlace, ReturnsAreSeenFromTheMiddleOfTheRobot) {
  Reading reading;
  reading.T_world_robot = {{1.0, 1.0}, Angle{}};
  reading.T_world_tx = reading.T_world_rx = {{1.2, 1.0}, Angle{}};
  reading.outcome = Echo{1.5};
  Reading silent = reading;
  silent.outcome = NoEcho{};
  const auto returns = depth_returns(std::vector{reading, silent});
  ASSERT_EQ(returns.size(), 2U);
  EXPECT_NEAR(returns[0].depth_m, 1.7, 1e-12);
  EXPECT_EQ(returns[0].bearing, Angle{});
  EXPECT_TRUE(std::isinf(returns[1].depth_m));
}

}  // namespace
}  // namespace echoarc::studies::choset
