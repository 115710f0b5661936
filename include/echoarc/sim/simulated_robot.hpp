// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/core/pose2.hpp"
#include "echoarc/core/robot_motion.hpp"

namespace echoarc::sim {

/// A robot that is driven by velocity commands: the same commands and steps give the same poses. Both speeds go towards
/// the last command as fast as the limits allow; the robot moves on arcs.
class SimulatedRobot {
 public:
  /// Requires limits that `validate` accepts.
  explicit SimulatedRobot(const Pose2& T_world_robot, const RobotLimits& limits = {});

  /// Holds until the next one; cut to the limits, and anything not finite counts as a halt. The forward speed goes
  /// towards zero at the deceleration, where it is given and a positive number, and away from zero at the limit.
  void command(const RobotVelocity& wanted, std::optional<double> deceleration_m_s2 = {});
  /// Something holds the robot where it was, whatever its heading: it has no forward speed any more.
  void hold(Vec2 position);
  /// Lets time pass; at most an hour, anything that is no positive number is ignored.
  void step(double duration_s);

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] const Pose2& T_world_robot() const { return T_world_robot_; }
  [[nodiscard]] const RobotVelocity& velocity() const { return velocity_; }
  /// Way of the robot's centre so far, backwards counted like forwards.
  [[nodiscard]] double travelled_m() const { return travelled_m_; }

 private:
  void move(double duration_s);

  RobotLimits limits_;
  double time_s_ = 0.0;
  double travelled_m_ = 0.0;
  Pose2 T_world_robot_;
  RobotVelocity velocity_;
  RobotVelocity wanted_;
  double deceleration_m_s2_;
};

}  // namespace echoarc::sim
