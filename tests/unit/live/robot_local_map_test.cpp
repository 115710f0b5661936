// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "echoarc/core/rng.hpp"
#include "robot_fixture.hpp"

namespace echoarc::live {
namespace {

constexpr double hull_m = 0.2;

RobotDescription one_sensor(Angle beam = degrees(1.0)) {
  RobotDescription robot;
  robot.radius_m = hull_m;
  robot.sensors = SensorArray::make({{.id = 0, .model = {.beam_width = beam}}}).value();
  return robot;
}

/// A map of one point, heard from the odd place from where it lies 1 m ahead.
LocalMap point_at(Vec2 place) {
  LocalMap map(one_sensor(degrees(0.01)), {.reach_m = 5.0});
  map.add(Odometry{.T_world_robot = {place - Vec2{1.0, 0.0}, Angle{}}});
  for (int k = 0; k < 3; ++k) map.add(Ping{.time_s = 0.1 * k, .range_m = 1.0});
  return map;
}

/// The slow obvious way: a disc moved on in small steps until it covers the point, coming from outside.
std::optional<double> marched(Vec2 point, const RobotVelocity& velocity) {
  constexpr double step_m = 1e-4;
  const double sign = velocity.forward_m_s < 0.0 ? -1.0 : 1.0;
  const double turn_per_m = velocity.turn_per_s.rad() / velocity.forward_m_s * sign;
  Pose2 disc;
  for (double way_m = 0.0; way_m < LocalMap::look_m; way_m += step_m) {
    if (norm(point - disc.position) < hull_m) return way_m;
    disc.position = disc.position + sign * step_m * unit(disc.heading + radians(0.5 * turn_per_m * step_m));
    disc.heading += radians(turn_per_m * step_m);
  }
  return {};
}

TEST(LocalMap, FreeWayIsWhatADiscCanGo) {
  Rng rng(3);
  int met = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const Vec2 place{rng.uniform(-1.0, 1.0), rng.uniform(-0.6, 0.6)};
    if (norm(place) < hull_m + 0.01) continue;
    const double turn_deg = trial % 4 == 0 ? 0.0 : rng.uniform(-80.0, 80.0);
    const RobotVelocity velocity{trial % 2 == 0 ? 0.4 : -0.3, degrees(turn_deg)};
    const auto free_m = point_at(place).free_along({}, velocity, hull_m);
    const auto expected_m = marched(place, velocity);
    // A point that is just grazed may be met or not.
    if (marched(place * 1.001, velocity).has_value() != expected_m.has_value()) continue;
    ASSERT_EQ(free_m.has_value(), expected_m.has_value()) << place.x << " " << place.y << " " << turn_deg;
    if (free_m) {
      ++met;
      ASSERT_NEAR(*free_m, *expected_m, 5e-3);
    }
  }
  EXPECT_GT(met, 60);
}

TEST(LocalMap, ATurnOnTheSpotIsFreeAndSoIsWhatLeavesAnObstacle) {
  const LocalMap map = point_at({0.19, 0.0});
  EXPECT_FALSE(map.free_along({}, {0.0, degrees(30.0)}, hull_m));
  EXPECT_EQ(map.free_along({}, {0.1, Angle{}}, hull_m), 0.0);
  EXPECT_FALSE(map.free_along({}, {-0.1, Angle{}}, hull_m));
}

TEST(LocalMap, NothingInsideTheBeamIsMissed) {
  LocalMap map(one_sensor(degrees(30.0)));
  map.add(Odometry{});
  map.add(Ping{.range_m = 1.5});
  for (double aside_deg = -15.0; aside_deg <= 15.0; aside_deg += 0.5) {
    double nearest_m = 1e9;
    for (const Vec2 point : map.points()) nearest_m = std::min(nearest_m, norm(point - 1.5 * unit(degrees(aside_deg))));
    EXPECT_LT(nearest_m, 0.05) << aside_deg;
  }
}

TEST(LocalMap, WhatIsHeardThroughIsForgottenButNotForSilenceFarAway) {
  const auto with = [](double then_m, int times) {
    LocalMap map(one_sensor(degrees(30.0)), {.reach_m = 5.0});
    map.add(Odometry{});
    for (int k = 0; k < 3; ++k) map.add(Ping{.time_s = 0.1 * k, .range_m = 1.0});
    for (int k = 0; k < times; ++k) map.add(Ping{.time_s = 1.0 + 0.1 * k, .range_m = then_m});
    const auto free_m = map.free_along({}, {0.3, Angle{}}, hull_m);
    return free_m && *free_m < 0.9;
  };
  constexpr double silence_m = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(with(2.5, 1));  // one may be noise
  EXPECT_FALSE(with(2.5, 2));
  EXPECT_FALSE(with(silence_m, 2));
  EXPECT_TRUE(with(1.05, 5));
  EXPECT_TRUE(with(std::numeric_limits<double>::quiet_NaN(), 5));
  EXPECT_TRUE(with(0.5, 5));  // something before it
}

}  // namespace
}  // namespace echoarc::live
