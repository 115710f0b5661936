// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/simulated_robot.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace echoarc::sim {
namespace {

constexpr RobotLimits limits{.speed_m_s = 0.6,
                             .turn_rate_per_s = degrees(60.0),
                             .acceleration_m_s2 = 0.3,
                             .turn_acceleration_per_s2 = degrees(90.0)};

TEST(SimulatedRobot, SpeedsUpAndBrakesOnARamp) {
  SimulatedRobot robot({{1.0, 2.0}, degrees(90.0)}, limits);
  robot.command({.forward_m_s = 0.6});
  robot.step(1.0);
  EXPECT_NEAR(robot.velocity().forward_m_s, 0.3, 1e-12);
  EXPECT_NEAR(robot.T_world_robot().position.y, 2.15, 1e-9);
  robot.step(2.0);
  EXPECT_EQ(robot.velocity().forward_m_s, 0.6);
  EXPECT_NEAR(robot.T_world_robot().position.y, 2.0 + 0.6 + 0.6, 1e-9);
  robot.command({});
  robot.step(5.0);
  EXPECT_EQ(robot.velocity(), RobotVelocity{});
  EXPECT_NEAR(robot.T_world_robot().position.y, 3.2 + 0.6, 1e-9) << "from 0.6 m/s it takes 0.6 m to stop";
  EXPECT_NEAR(robot.T_world_robot().position.x, 1.0, 1e-12);
  EXPECT_NEAR(robot.travelled_m(), 1.8, 1e-9);
  EXPECT_NEAR(robot.time_s(), 8.0, 1e-12);
}

TEST(SimulatedRobot, DrivesCircles) {
  SimulatedRobot robot({{0.0, 0.0}, Angle{}},
                       {.acceleration_m_s2 = 100.0, .turn_acceleration_per_s2 = degrees(36'000)});
  robot.command({.forward_m_s = 0.5, .turn_per_s = degrees(36.0)});
  robot.step(0.05);
  const Pose2 T_world_begin = robot.T_world_robot();
  robot.step(10.0);
  EXPECT_NEAR(norm(robot.T_world_robot().position - T_world_begin.position), 0.0, 1e-9);
  robot.step(5.0);
  EXPECT_NEAR(norm(robot.T_world_robot().position - T_world_begin.position), 2.0 * 0.5 / degrees(36.0).rad(), 1e-9);
}

TEST(SimulatedRobot, StepsOfAnySizeEndAlike) {
  SimulatedRobot coarse({{0.0, 0.0}, Angle{}}, limits);
  SimulatedRobot fine({{0.0, 0.0}, Angle{}}, limits);
  for (const double turn_deg : {30.0, -60.0, 0.0}) {
    coarse.command({.forward_m_s = 0.4, .turn_per_s = degrees(turn_deg)});
    fine.command({.forward_m_s = 0.4, .turn_per_s = degrees(turn_deg)});
    coarse.step(1.0);
    for (int k = 0; k < 50; ++k) fine.step(0.02);
  }
  EXPECT_NEAR(norm(coarse.T_world_robot().position - fine.T_world_robot().position), 0.0, 1e-4);
  EXPECT_NEAR(coarse.time_s(), fine.time_s(), 1e-9);
}

TEST(SimulatedRobot, CommandsAreCutToTheLimits) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  SimulatedRobot robot({{0.0, 0.0}, Angle{}}, limits);
  robot.command({.forward_m_s = -99.0, .turn_per_s = degrees(999.0)});
  robot.step(60.0);
  EXPECT_EQ(robot.velocity().forward_m_s, -0.6);
  EXPECT_EQ(robot.velocity().turn_per_s, degrees(60.0));
  robot.command({.forward_m_s = std::nan(""), .turn_per_s = radians(inf)});
  robot.step(60.0);
  EXPECT_EQ(robot.velocity(), RobotVelocity{}) << "what is no number is a halt";
  const double time_s = robot.time_s();
  for (const double bad_s : {0.0, -1.0, std::nan("")}) robot.step(bad_s);
  EXPECT_EQ(robot.time_s(), time_s);
  robot.step(inf);
  EXPECT_EQ(robot.time_s(), time_s + 3600.0);
}

}  // namespace
}  // namespace echoarc::sim
