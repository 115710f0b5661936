// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

/// Free way of a disc straight ahead from its rim, m; infinite if nothing stands in it. What the rim touches already
/// counts when it lies ahead.
[[nodiscard]] double free_ahead_m(std::span<const Vec2> points, const Pose2& T_world_base, double radius_m);

/// The velocity of a disc that turns and then drives into the wanted direction (world, m/s), no faster than it can stop
/// before what stands ahead.
[[nodiscard]] RobotVelocity steer_towards(const Pose2& T_world_base, Vec2 wanted_m_s, const RobotBody& body,
                                          std::span<const Vec2> points);

/// Follows a known line by looking a little ahead on it.
class LineFollower {
 public:
  /// From a place onto a line and along it.
  void begin(Vec2 place, std::span<const Vec2> line);
  /// Where to drive from here; none once the end is reached.
  [[nodiscard]] std::optional<Vec2> target(Vec2 place);
  /// What is left of the line.
  [[nodiscard]] std::span<const Vec2> rest() const { return std::span<const Vec2>(line_).subspan(next_); }

 private:
  std::vector<Vec2> line_;
  std::size_t next_ = 0;
};

}  // namespace echoarc::nav
