// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/vec2.hpp"

namespace echoarc {

/// A rigid motion of the plane. Variables name both frames: `T_world_sensor * p_sensor == p_world`.
struct Pose2 {
  Vec2 position;  ///< metres
  Angle heading;

  friend constexpr bool operator==(const Pose2&, const Pose2&) = default;
};

[[nodiscard]] inline Vec2 rotate(Vec2 v, Angle a) {
  const Vec2 u = unit(a);
  return {u.x * v.x - u.y * v.y, u.y * v.x + u.x * v.y};
}

[[nodiscard]] inline Vec2 operator*(const Pose2& T_a_b, Vec2 p_b) {
  return T_a_b.position + rotate(p_b, T_a_b.heading);
}

[[nodiscard]] inline Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  return {T_a_b * T_b_c.position, T_a_b.heading + T_b_c.heading};
}

[[nodiscard]] inline Pose2 inverse(const Pose2& T_a_b) {
  return {rotate(-T_a_b.position, -T_a_b.heading), -T_a_b.heading};
}

/// Straight-line position and shortest-turn heading between two poses; `fraction` 0 gives `from`, 1 gives `to`.
[[nodiscard]] inline Pose2 interpolate(const Pose2& from, const Pose2& to, double fraction) {
  return {from.position + fraction * (to.position - from.position),
          from.heading + fraction * wrap(to.heading - from.heading)};
}

[[nodiscard]] inline bool is_finite(const Pose2& T) {
  return is_finite(T.position) && is_finite(T.heading);
}

}  // namespace echoarc
