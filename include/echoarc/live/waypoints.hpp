// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "echoarc/core/pose2.hpp"
#include "echoarc/sim/simulated_robot.hpp"

namespace echoarc::live {

/// The stations of a tour, one after another for ever: round if it ends where it began, there and back otherwise.
class Route {
 public:
  Route() = default;
  explicit Route(std::vector<Vec2> stations);

  /// Whether there are two at least.
  [[nodiscard]] bool stations() const { return stations_.size() > 1; }
  /// The next goal is the station that is nearest then.
  void restart();
  [[nodiscard]] Vec2 goal(Vec2 from);
  [[nodiscard]] Vec2 next_goal();
  /// The way on is blocked: back to where the robot came from.
  void turn_back();

 private:
  std::vector<Vec2> stations_;
  bool closed_ = false;
  bool backwards_ = false;
  std::optional<std::size_t> at_;
};

/// Drives to a point: a turn on the spot, then a straight line.
class Homing {
 public:
  [[nodiscard]] bool arrived(const Pose2& T_world_base, Vec2 goal) const;
  [[nodiscard]] RobotVelocity steer(const Pose2& T_world_base, Vec2 goal, double cruise_m_s, double deceleration_m_s2,
                                    const RobotLimits& limits);

 private:
  bool turning_ = true;
};

}  // namespace echoarc::live
