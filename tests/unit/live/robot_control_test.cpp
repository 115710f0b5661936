// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/robot_control.hpp"

#include <cmath>
#include <limits>

#include "echoarc/core/rng.hpp"
#include "robot_fixture.hpp"

namespace echoarc::live {
namespace {

/// A robot in the origin that does as it is told at once.
class Puppet final : public Drivable {
 public:
  void command(const MotorCommand& command) override { velocity_ = command.wanted; }
  [[nodiscard]] Pose2 T_world_base() const override { return {}; }
  [[nodiscard]] RobotVelocity velocity() const override { return velocity_; }
  [[nodiscard]] RobotLimits limits() const override { return {}; }
  RobotVelocity velocity_;
};

/// What a robot of 0.2 m radius at the origin hears ahead, with one sensor in its centre of a beam of 1 degree.
LocalMap wall_ahead(double range_m) {
  RobotDescription robot;
  robot.radius_m = 0.2;
  robot.sensors = SensorArray::make({{.id = 0, .model = {.beam_width = degrees(1.0)}}}).value();
  LocalMap map(robot);
  map.add(Odometry{});
  for (int k = 0; k < 3; ++k) map.add(Ping{.time_s = 0.1 * k, .range_m = range_m});
  return map;
}

TEST(SpeedCap, IsWhatTheFreeWayAllows) {
  // a = 0.3 m/s^2, d_free - d_stop = 0.5 m: v <= 0.547723 m/s; from 0.6 m/s the stopping distance is 0.6 m.
  const Puppet robot;
  RobotControl control({}, 0.2, {});
  control.drive({0.6, Angle{}}, 0.0);
  const MotorCommand capped = control.update(robot, wall_ahead(0.2 + 0.1 + 0.5), 0.0);
  EXPECT_NEAR(capped.wanted.forward_m_s, 0.547723, 1e-4);
  EXPECT_NEAR(control.state().limit_m_s, 0.547723, 1e-4);
  EXPECT_NEAR(control.state().free_ahead_m.value_or(0.0), 0.6, 1e-4);
  EXPECT_TRUE(control.state().limited_by_obstacle);
  EXPECT_EQ(control.update(robot, wall_ahead(0.2 + 0.1 + 0.601), 0.0).wanted.forward_m_s, 0.6);
  EXPECT_LT(control.update(robot, wall_ahead(0.2 + 0.1 + 0.599), 0.0).wanted.forward_m_s, 0.6);
  EXPECT_EQ(control.update(robot, wall_ahead(0.29), 0.0).wanted.forward_m_s, 0.0);
  EXPECT_EQ(control.state().reason, Reason::obstacle);
}

TEST(SpeedCap, WhatAppearsSuddenlyIsBrakedForHard) {
  Puppet robot;
  robot.velocity_.forward_m_s = 0.5;
  RobotControl control({}, 0.2, {});
  control.drive({0.5, Angle{}}, 0.0);
  EXPECT_EQ(control.update(robot, LocalMap(), 0.0).deceleration_m_s2, 0.3);
  EXPECT_EQ(control.update(robot, wall_ahead(0.5), 0.0).deceleration_m_s2, 1.5);
  // Also for who already wants to go back.
  control.drive({-0.5, Angle{}}, 0.0);
  EXPECT_EQ(control.update(robot, wall_ahead(0.5), 0.0).deceleration_m_s2, 1.5);
  EXPECT_EQ(control.update(robot, LocalMap(), 0.0).deceleration_m_s2, 0.3);
}

TEST(Drive, HostileCommandsAreCutAndWhatIsNoNumberIsZero) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Puppet robot;
  RobotControl control({}, 0.2, {});
  const auto command_of = [&](double forward_m_s, double turn) {
    control.drive({forward_m_s, radians(turn)}, 0.0);
    return control.update(robot, LocalMap(), 0.0).wanted;
  };
  EXPECT_EQ(command_of(1e300, 0.0), (RobotVelocity{0.6, Angle{}}));
  EXPECT_EQ(command_of(-7.0, -1e9), (RobotVelocity{-0.6, -degrees(60.0)}));
  EXPECT_EQ(command_of(nan, 0.1), (RobotVelocity{0.0, radians(0.1)}));
  EXPECT_EQ(command_of(0.2, nan), (RobotVelocity{0.2, Angle{}}));
  EXPECT_EQ(command_of(infinite, -infinite), RobotVelocity{});
}

TEST(Stop, StaysInForceWhenTheStickIsLetGo) {
  const Puppet robot;
  RobotControl control({}, 0.2, {});
  control.drive({0.3, Angle{}}, 0.0);
  control.stop();
  control.drive({}, 0.1);
  EXPECT_EQ(control.state().reason, Reason::stopped);
  EXPECT_EQ(control.update(robot, LocalMap(), 0.1).wanted, RobotVelocity{});
  control.drive({0.1, Angle{}}, 0.2);  // a wish to go is one
  EXPECT_EQ(control.update(robot, LocalMap(), 0.2).wanted.forward_m_s, 0.1);
}

TEST(DeadMan, BrakesWithinHalfASecondOfTheLastCommand) {
  constexpr double step_s = 0.02;
  for (std::uint64_t trial = 1; trial <= 200; ++trial) {
    Rng rng(trial);
    Driven driven(plain_room(), trial);
    const double speed_m_s = rng.uniform(0.05, 0.6);
    const double turn_deg = rng.uniform(-60.0, 60.0);
    driven.drive(step_s * std::floor(rng.uniform(20.0, 120.0)), speed_m_s, degrees(turn_deg));
    const double last_s = driven.host_s() - step_s;  // the last command was given before the last step
    while (driven.control().state().mode == Mode::drive) driven.run(step_s);
    ASSERT_EQ(driven.control().state().reason, Reason::dead_man);
    ASSERT_LE(driven.host_s() - last_s, 0.5 + step_s + 1e-9);
    ASSERT_GE(driven.host_s() - last_s, 0.5 - 1e-9);
    const double braking_s = driven.speed_m_s() / 1.5;
    driven.run(braking_s + step_s);
    ASSERT_EQ(driven.speed_m_s(), 0.0);
  }
}

TEST(DeadMan, ALaterCommandStartsAnew) {
  Driven driven(plain_room());
  driven.drive(1.0, 0.2, Angle{});
  driven.run(2.0);
  EXPECT_EQ(driven.control().state().mode, Mode::stand);
  EXPECT_EQ(driven.control().state().reason, Reason::dead_man);
  driven.drive(1.0, 0.2, Angle{});
  EXPECT_EQ(driven.control().state().mode, Mode::drive);
  EXPECT_GT(driven.speed_m_s(), 0.15);
  driven.control().driver_gone();
  driven.run(0.02);
  EXPECT_EQ(driven.control().state().reason, Reason::dead_man);
  driven.control().tour();  // without stations
  driven.run(1.0);
  EXPECT_EQ(driven.control().state().mode, Mode::stand);
}

TEST(Stop, BrakesHardAndStandsUntilSomethingStarts) {
  Driven driven(plain_room());
  driven.drive(3.0, 0.6, Angle{});
  const double speed_m_s = driven.speed_m_s();
  ASSERT_GT(speed_m_s, 0.4);
  driven.control().stop();
  driven.run(0.02);
  EXPECT_NEAR(driven.speed_m_s(), speed_m_s - 0.02 * 1.5, 0.01);
  driven.run(2.0);
  EXPECT_EQ(driven.speed_m_s(), 0.0);
  EXPECT_EQ(driven.control().state().reason, Reason::stopped);
  driven.drive(1.0, 0.2, Angle{});
  EXPECT_GT(driven.speed_m_s(), 0.15);
  driven.control().stand();
  driven.run(0.1);
  EXPECT_GT(driven.speed_m_s(), 0.12);  // gently
}

TEST(LiveRobot, NotesCommandsWhenTheyChange) {
  Driven driven(plain_room());
  driven.drive(0.5, 0.2, Angle{});
  driven.drive(0.5, 0.3, Angle{});
  driven.control().stop();
  driven.run(0.5);
  std::vector<CommandNote> notes;
  for (const Record& record : driven.records)
    if (const auto* note = std::get_if<CommandNote>(&record)) notes.push_back(*note);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0].mode, "drive");
  EXPECT_EQ(notes[0].wanted.forward_m_s, 0.2);
  EXPECT_NEAR(notes[1].time_s, 0.5, 0.011);
  EXPECT_EQ(notes[1].wanted.forward_m_s, 0.3);
  EXPECT_EQ(notes[2].mode, "stop");
  EXPECT_EQ(notes[2].wanted, RobotVelocity{});
}

}  // namespace
}  // namespace echoarc::live
