// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>

#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// A wall that mirrors a source: its image, and where on the wall a listener sees it.
struct Mirror {
  static constexpr double touch_m = 1e-9;

  Vec2 a;
  Vec2 direction;  ///< from a to b, unit
  double length_m = 0.0;
  bool one_sided = false;

  explicit Mirror(const Wall& wall) : a(wall.a), direction(wall.b - wall.a), one_sided(wall.one_sided) {
    length_m = norm(direction);
    direction = direction / length_m;
  }
  /// Distance from the wall's line, positive on the left.
  [[nodiscard]] double side(Vec2 p) const { return cross(direction, p - a); }
  /// Whether a source stands where the wall mirrors it. A source on the wall's line makes no echo.
  [[nodiscard]] bool reflects(Vec2 source) const {
    const double s = side(source);
    return one_sided ? s > touch_m : std::abs(s) > touch_m;
  }
  /// Whether a part of another wall stands on the side of the line where `image`, an image in this wall, does not: only
  /// there sound goes on. False for a wall that lies on this one.
  [[nodiscard]] bool lights(const Mirror& other, Vec2 image) const {
    const double start = side(other.a);
    const double end = side(other.a + other.length_m * other.direction);
    return side(image) < 0.0 ? std::max(start, end) > touch_m : std::min(start, end) < -touch_m;
  }
  [[nodiscard]] Vec2 image(Vec2 source) const { return source - 2.0 * side(source) * perpendicular(direction); }
  /// Where a straight line from `target` to the image `image` meets the wall; false: beside it, or from behind.
  [[nodiscard]] bool bounce(Vec2 target, Vec2 image, Vec2& point) const {
    const double behind = side(image);
    const double before = side(target);
    // In an apex the target lies on the wall itself, give or take the rounding.
    if ((behind < 0.0 ? before : -before) < -touch_m) return false;
    point = target + before / (before - behind) * (image - target);
    const double along = dot(point - a, direction);
    return along >= -touch_m && along <= length_m + touch_m;
  }
};

}  // namespace echoarc::sim
