// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"

namespace echoarc::sim {

/// Forward speed and turning rate, of a command or of the robot itself.
struct RobotVelocity {
  double forward_m_s = 0.0;
  Angle turn_per_s;
  friend constexpr bool operator==(const RobotVelocity&, const RobotVelocity&) = default;
};

/// What a robot's motors can do.
struct RobotLimits {
  double speed_m_s = 0.6;
  Angle turn_rate_per_s = degrees(60.0);
  double acceleration_m_s2 = 0.3;
  Angle turn_acceleration_per_s2 = degrees(90.0);

  static constexpr auto fields() {
    using L = RobotLimits;
    return std::tuple{
        field("speed_m_s", &L::speed_m_s,
              {.unit = "m/s", .min = 1e-3, .max = 10.0, .doc = "forwards and backwards", .source = "[Barshan07] 4.1"}),
        field("turn_rate_deg", &L::turn_rate_per_s,
              {.unit = "deg/s", .min = 0.1, .max = 3600.0, .doc = "to either side", .source = "[Barshan07] 4.1"}),
        field("acceleration_m_s2", &L::acceleration_m_s2,
              {.unit = "m/s^2", .min = 1e-3, .max = 100.0, .doc = "of speeding up and of braking"}),
        field("turn_acceleration_deg", &L::turn_acceleration_per_s2,
              {.unit = "deg/s^2", .min = 0.1, .max = 36'000.0, .doc = "of the turning rate"})};
  }
};

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
