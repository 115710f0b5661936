// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/recovery.hpp"
#include "unit/nav/motion_world.hpp"

namespace echoarc::nav {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr RobotVelocity ahead{0.25, Angle{}};

Surroundings at(double time_s, const Pose2& T_world_base) {
  return {.time_s = time_s, .T_world_base = T_world_base};
}

TEST(PoseWatch, TellsFaultsFromDriving) {
  PoseWatch watch({});
  EXPECT_EQ(watch.fault(at(0.0, {})), "");
  EXPECT_EQ(watch.fault(at(0.1, {{0.06, 0.0}, degrees(6.0)})), "");
  EXPECT_EQ(watch.fault(at(0.1, {{0.06, 0.0}, degrees(366.0)})), "");  // the same heading
  EXPECT_EQ(watch.fault(at(0.2, {{1.56, 0.0}, degrees(6.0)})), "the pose jumped by 1.5 m");
  EXPECT_EQ(watch.fault(at(0.3, {{1.56, 0.0}, degrees(96.0)})), "the heading jumped");
  EXPECT_EQ(watch.fault(at(0.2, {{1.56, 0.0}, degrees(96.0)})), "time runs backwards");
  EXPECT_EQ(watch.fault(at(0.4, {{nan_value, 0.0}, Angle{}})), "the pose is no number");
  EXPECT_EQ(watch.fault(at(nan_value, {})), "the time is no number");
  watch.reset();
  EXPECT_EQ(watch.fault(at(0.0, {{50.0, 0.0}, Angle{}})), "");
}

RC_GTEST_PROP(PoseWatch, WhatTheMotorsCanDoIsNoFault, (std::uint64_t seed)) {
  Rng rng(seed);
  MotionWorld world({}, {{rng.uniform(-5.0, 5.0), 0.0}, degrees(rng.uniform(-180.0, 180.0))});
  PoseWatch watch({});
  for (int k = 0; k < 50; ++k) {
    RC_ASSERT(watch.fault(world.surroundings()).empty());
    world.drive({rng.uniform(-1.0, 1.0), degrees(rng.uniform(-90.0, 90.0))});
  }
}

TEST(Recovery, LeavesAloneWhoGetsOnOrStandsAtWill) {
  Recovery recovery({});
  Pose2 T_world_base;
  for (int k = 0; k < 300; ++k) {
    T_world_base.position.x += 0.02;
    EXPECT_FALSE(recovery.update(at(0.1 * k, T_world_base), ahead));
  }
  for (int k = 300; k < 900; ++k) EXPECT_FALSE(recovery.update(at(0.1 * k, T_world_base), {}));
}

TEST(Recovery, BacksOffAndTurnsWhereItIsStuckThenLetsTryAgain) {
  MotionWorld world(rectangle({-3.0, -1.0}, {0.3, 1.0}), {});  // before a wall that the driver drives at
  Recovery recovery({});
  double stuck_s = -1.0;
  double least_x = 0.0;
  while (world.time_s() < 60.0) {
    const Surroundings seen = world.surroundings();
    const auto way_out = recovery.update(seen, ahead);
    if (way_out && stuck_s < 0.0) stuck_s = seen.time_s;
    if (!way_out && stuck_s >= 0.0) break;
    EXPECT_TRUE(!way_out || way_out->status == Status::running);
    world.drive(way_out ? way_out->wanted : safe_velocity(seen.T_world_base, ahead, 0.225, seen.points));
    least_x = std::min(least_x, seen.T_world_base.position.x);
  }
  EXPECT_NEAR(stuck_s, RecoveryOptions{}.stuck_s, 0.3);
  EXPECT_NEAR(least_x, -0.3, 0.05);
  EXPECT_GT(abs(world.T_world_base().heading).deg(), 50.0);
  EXPECT_LT(world.time_s(), 15.0);
  EXPECT_GT(world.clearance_m(), 0.0);
}

/// Whoever cannot be helped is given up, whatever is wanted, in bounded time and for good.
TEST(Recovery, GivesUpAfterSomeTriesWithAReason) {
  for (const RobotVelocity& wanted : {ahead, RobotVelocity{-0.2, Angle{}}, RobotVelocity{0.0, degrees(30.0)}}) {
    Recovery recovery({});
    double time_s = 0.0;
    std::optional<Steering> way_out;
    for (; time_s < 300.0; time_s += 0.1) {
      way_out = recovery.update(at(time_s, {}), wanted);
      if (way_out && way_out->status != Status::running) break;
    }
    ASSERT_TRUE(way_out);
    EXPECT_EQ(way_out->status, Status::failed);
    EXPECT_EQ(way_out->reason, "stuck: no way on after 3 tries to back off and turn");
    EXPECT_EQ(way_out->wanted, RobotVelocity{});
    EXPECT_LT(time_s, 120.0);
    EXPECT_EQ(recovery.update(at(time_s + 1.0, {{9.0, 0.0}, Angle{}}), wanted)->status, Status::failed);
    recovery.reset();
    EXPECT_FALSE(recovery.update(at(time_s + 2.0, {}), wanted));
  }
}

TEST(Recovery, OptionsAreLegal) {
  EXPECT_TRUE(validate(RecoveryOptions{}));
  EXPECT_FALSE(validate(RecoveryOptions{.tries = -1}));
}

}  // namespace
}  // namespace echoarc::nav
