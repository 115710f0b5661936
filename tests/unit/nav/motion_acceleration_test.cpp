// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/acceleration.hpp"

namespace echoarc::nav {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(SpeedCap, V71WorkedNumbers) {
  EXPECT_NEAR(speed_cap_m_s(0.6, 0.1, 0.3), 0.547723, 5e-7);  // 0.5 m remain
  EXPECT_NEAR(stopping_distance_m(0.6, 0.3), 0.6, 1e-12);
}

TEST(SpeedCap, NoWayNoSpeed) {
  EXPECT_EQ(speed_cap_m_s(0.1, 0.1, 0.3), 0.0);
  EXPECT_EQ(speed_cap_m_s(0.0, 0.1, 0.3), 0.0);
  EXPECT_EQ(speed_cap_m_s(-1.0, 0.1, 0.3), 0.0);
  EXPECT_EQ(speed_cap_m_s(nan_value, 0.1, 0.3), 0.0);
}

RC_GTEST_PROP(SpeedCap, FallsWithTheWayAndIsWhatStopsInIt, (std::uint64_t seed)) {
  Rng rng(seed);
  const double stop_m = rng.uniform(0.0, 0.5);
  const double deceleration = rng.uniform(0.05, 2.0);
  const double less_m = rng.uniform(-0.5, 5.0);
  const double more_m = less_m + rng.uniform(0.0, 2.0);
  const double cap_m_s = speed_cap_m_s(more_m, stop_m, deceleration);
  RC_ASSERT(speed_cap_m_s(less_m, stop_m, deceleration) <= cap_m_s);
  if (cap_m_s > 0.0) RC_ASSERT(std::abs(stopping_distance_m(cap_m_s, deceleration) - (more_m - stop_m)) < 1e-9);
}

/// The way of a trapezoid from rest to rest is what its area says.
TEST(Accelerated, MakesTrapezoids) {
  const RobotLimits limits;
  constexpr double step_s = 0.01;
  RobotVelocity now;
  double way_m = 0.0;
  double up_s = 0.0;
  for (int k = 0; k < 1000; ++k) {
    now = accelerated(now, {0.6, Angle{}}, limits, step_s);
    way_m += step_s * now.forward_m_s;
    if (now.forward_m_s < 0.6 - 1e-9) up_s += step_s;
  }
  EXPECT_NEAR(up_s, 2.0, 0.011);
  EXPECT_NEAR(way_m, 0.6 + 8.0 * 0.6, 0.01);
  double braking_m = 0.0;
  while (now.forward_m_s > 0.0) {
    now = accelerated(now, {}, limits, step_s);
    braking_m += step_s * now.forward_m_s;
  }
  EXPECT_NEAR(braking_m, stopping_distance_m(0.6, 0.3), 0.005);
}

RC_GTEST_PROP(Accelerated, KeepsTheLimitsAndDrawsNearer, (std::uint64_t seed)) {
  Rng rng(seed);
  const RobotLimits limits;
  const RobotVelocity now{rng.uniform(-0.6, 0.6), degrees(rng.uniform(-60.0, 60.0))};
  const RobotVelocity wanted{rng.uniform(-2.0, 2.0), degrees(rng.uniform(-200.0, 200.0))};
  const double step_s = rng.uniform(0.0, 0.5);
  const RobotVelocity next = accelerated(now, wanted, limits, step_s);
  RC_ASSERT(std::abs(next.forward_m_s) <= limits.speed_m_s + 1e-12);
  RC_ASSERT(abs(next.turn_per_s) <= limits.turn_rate_per_s + radians(1e-12));
  RC_ASSERT(std::abs(next.forward_m_s - now.forward_m_s) <= limits.acceleration_m_s2 * step_s + 1e-12);
  RC_ASSERT(abs(next.turn_per_s - now.turn_per_s) <= limits.turn_acceleration_per_s2 * step_s + radians(1e-12));
  RC_ASSERT(std::abs(wanted.forward_m_s - next.forward_m_s) <= std::abs(wanted.forward_m_s - now.forward_m_s));
}

TEST(Accelerated, WhatIsNoNumberIsAWishToStand) {
  const RobotLimits limits;
  EXPECT_NEAR(accelerated({0.5, Angle{}}, {nan_value, radians(nan_value)}, limits, 0.1).forward_m_s, 0.47, 1e-12);
  EXPECT_NEAR(accelerated({0.5, Angle{}}, {infinity, Angle{}}, limits, 0.1).forward_m_s, 0.47, 1e-12);
  EXPECT_EQ(accelerated({nan_value, radians(infinity)}, {}, limits, 0.1), RobotVelocity{});
  EXPECT_EQ(accelerated({0.5, Angle{}}, {}, limits, -1.0).forward_m_s, 0.5);
  EXPECT_EQ(accelerated({0.5, Angle{}}, {}, limits, nan_value).forward_m_s, 0.5);
}

}  // namespace
}  // namespace echoarc::nav
