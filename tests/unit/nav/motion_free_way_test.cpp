// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/acceleration.hpp"
#include "echoarc/nav/free_way.hpp"

namespace echoarc::nav {
namespace {

constexpr double hull_m = 0.225;
constexpr double look_m = 3.0;
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

std::vector<Vec2> one(Vec2 point) {
  return {point};
}

Pose2 random_pose(Rng& rng) {
  return {{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)}, degrees(rng.uniform(-180.0, 180.0))};
}

RobotVelocity random_velocity(Rng& rng) {
  const double turn_deg = rng.below(4) == 0 ? 0.0 : rng.uniform(-80.0, 80.0);
  return {rng.below(2) == 0 ? rng.uniform(0.05, 0.6) : rng.uniform(-0.6, -0.05), degrees(turn_deg)};
}

/// The slow obvious way: the disc moves on in small steps until it covers one of the points.
std::optional<double> stepped_m(Pose2 T_world_base, const RobotVelocity& velocity, double radius_m,
                                const std::vector<Vec2>& points) {
  constexpr double step_m = 1e-3;
  const double sign = velocity.forward_m_s < 0.0 ? -1.0 : 1.0;
  const double turn_per_m = velocity.turn_per_s.rad() / std::abs(velocity.forward_m_s);
  for (double way_m = 0.0; way_m < look_m; way_m += step_m) {
    for (const Vec2 point : points)
      if (norm(point - T_world_base.position) < radius_m) return way_m;
    const Angle middle = T_world_base.heading + radians(0.5 * turn_per_m * step_m);
    T_world_base.position = T_world_base.position + sign * step_m * unit(middle);
    T_world_base.heading += radians(turn_per_m * step_m);
  }
  return {};
}

RC_GTEST_PROP(FreeWay, IsWhatADiscCanGoStepByStep, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 T_world_base = random_pose(rng);
  const RobotVelocity velocity = random_velocity(rng);
  std::vector<Vec2> points;
  for (int k = 0; k < 6; ++k)
    points.push_back(T_world_base * (rng.uniform(hull_m + 0.02, 2.5) * unit(degrees(rng.uniform(-180.0, 180.0)))));
  const auto free_m = free_way_m(T_world_base, velocity, hull_m, points, look_m);
  // What is just grazed may be met or not: a little less of a disc goes further, a little more less far.
  const double least_m = stepped_m(T_world_base, velocity, hull_m + 2e-3, points).value_or(look_m);
  const double most_m = stepped_m(T_world_base, velocity, hull_m - 2e-3, points).value_or(look_m);
  RC_ASSERT(free_m.value_or(look_m) >= least_m - 2e-3);
  RC_ASSERT(free_m.value_or(look_m) <= most_m + 2e-3);
}

RC_GTEST_PROP(FreeWay, MovesWithTheWorld, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 T_world_base = random_pose(rng);
  const RobotVelocity velocity = random_velocity(rng);
  const Vec2 point = T_world_base * Vec2{rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)};
  const Pose2 T_other_world = random_pose(rng);
  const auto here_m = free_way_m(T_world_base, velocity, hull_m, one(point));
  const auto there_m = free_way_m(T_other_world * T_world_base, velocity, hull_m, one(T_other_world * point));
  RC_ASSERT(std::abs(here_m.value_or(look_m) - there_m.value_or(look_m)) < 1e-5);
}

RC_GTEST_PROP(FreeWay, OneMorePointNeverMakesItLonger, (std::uint64_t seed)) {
  Rng rng(seed);
  const RobotVelocity velocity = random_velocity(rng);
  std::vector<Vec2> points;
  double before_m = look_m;
  for (int k = 0; k < 10; ++k) {
    points.push_back({rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)});
    const double now_m = free_way_m({}, velocity, hull_m, points).value_or(look_m);
    RC_ASSERT(now_m <= before_m);
    before_m = now_m;
  }
}

TEST(FreeWay, WorkedNumbers) {
  const RobotVelocity ahead{0.3, Angle{}};
  EXPECT_NEAR(free_way_m({}, ahead, hull_m, one({1.0, 0.0})).value(), 0.775, 1e-12);
  EXPECT_NEAR(free_way_m({}, ahead, hull_m, one({1.0, 0.135})).value(), 0.82, 1e-12);  // 0.135, 0.18, 0.225: 3 4 5
  EXPECT_FALSE(free_way_m({}, ahead, hull_m, one({1.0, 0.226})));
  EXPECT_FALSE(free_way_m({}, ahead, hull_m, one({3.3, 0.0})));
  EXPECT_FALSE(free_way_m({}, {-0.3, Angle{}}, hull_m, one({1.0, 0.0})));
  // A quarter of a circle of 1 m, less what the disc's radius hides of it.
  const double quarter_m = 0.5 * std::numbers::pi - 2.0 * std::asin(0.5 * hull_m);
  EXPECT_NEAR(free_way_m({}, {0.3, radians(0.3)}, hull_m, one({1.0, 1.0})).value(), quarter_m, 1e-9);
}

TEST(FreeWay, ATurnOnTheSpotIsFreeAndSoIsWhatLeavesAnObstacle) {
  const auto inside = one({0.2, 0.0});
  EXPECT_FALSE(free_way_m({}, {0.0, degrees(30.0)}, hull_m, inside));
  EXPECT_EQ(free_way_m({}, {0.1, Angle{}}, hull_m, inside), 0.0);
  EXPECT_FALSE(free_way_m({}, {-0.1, Angle{}}, hull_m, inside));
}

TEST(FreeWay, WhatIsNoNumberIsNoObstacleAndNoPlaceToDriveFrom) {
  const RobotVelocity ahead{0.3, Angle{}};
  EXPECT_FALSE(free_way_m({}, ahead, hull_m, one({nan_value, 0.0})));
  EXPECT_FALSE(free_way_m({}, {nan_value, Angle{}}, hull_m, one({1.0, 0.0})));
  EXPECT_EQ(free_way_m({{nan_value, 0.0}, Angle{}}, ahead, hull_m, one({1.0, 0.0})), 0.0);
  EXPECT_EQ(free_way_m({{}, radians(nan_value)}, ahead, hull_m, {}), 0.0);
}

TEST(Emergency, IsWhatIsNearAndComesNearer) {
  const RobotVelocity ahead{0.1, Angle{}};
  EXPECT_TRUE(emergency({}, ahead, hull_m, one({0.27, 0.0})));
  EXPECT_FALSE(emergency({}, ahead, hull_m, one({0.28, 0.0})));
  EXPECT_FALSE(emergency({}, ahead, hull_m, one({-0.27, 0.0})));
  EXPECT_TRUE(emergency({}, {-0.1, Angle{}}, hull_m, one({-0.27, 0.0})));
  EXPECT_FALSE(emergency({}, {0.0, degrees(20.0)}, hull_m, one({0.27, 0.0})));
  EXPECT_FALSE(emergency({}, ahead, hull_m, one({nan_value, 0.0})));
}

RC_GTEST_PROP(SafeVelocity, StopsBeforeWhateverStandsThere, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> points;
  for (int k = 0; k < 20; ++k)
    points.push_back(rng.uniform(hull_m + 0.06, 2.5) * unit(degrees(rng.uniform(-180.0, 180.0))));
  const RobotVelocity wanted = random_velocity(rng);
  Pose2 T_world_base;
  RobotVelocity now;
  constexpr double step_s = 0.05;
  for (int k = 0; k < 200; ++k) {
    const RobotVelocity safe = safe_velocity(T_world_base, wanted, hull_m, points);
    RC_ASSERT(std::abs(safe.forward_m_s) <= std::abs(wanted.forward_m_s));
    now = accelerated(now, safe, {.acceleration_m_s2 = 1.5}, step_s);
    T_world_base.heading += step_s * now.turn_per_s;
    T_world_base.position = T_world_base.position + step_s * now.forward_m_s * unit(T_world_base.heading);
    for (const Vec2 point : points) RC_ASSERT(norm(point - T_world_base.position) > hull_m);
  }
}

TEST(SafeVelocity, TurnsOnWhereItCannotGoOn) {
  const RobotVelocity safe = safe_velocity({}, {0.3, degrees(20.0)}, hull_m, one({0.26, 0.0}));
  EXPECT_EQ(safe.forward_m_s, 0.0);
  EXPECT_EQ(safe.turn_per_s, degrees(20.0));
  EXPECT_EQ(safe_velocity({}, {nan_value, degrees(20.0)}, hull_m, {}), RobotVelocity{});
  EXPECT_EQ(safe_velocity({}, {0.3, Angle{}}, hull_m, {}), (RobotVelocity{0.3, Angle{}}));
  EXPECT_TRUE(validate(SafetyOptions{}));
}

}  // namespace
}  // namespace echoarc::nav
