// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

#include "echoarc/core/angle.hpp"

namespace echoarc {

/// A point or a displacement in the plane, in metres, x right (or forward), y up (or left).
struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(Vec2, Vec2) = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double k) { return {a.x * k, a.y * k}; }
  friend constexpr Vec2 operator*(double k, Vec2 a) { return {a.x * k, a.y * k}; }
  friend constexpr Vec2 operator/(Vec2 a, double k) { return {a.x / k, a.y / k}; }
};

[[nodiscard]] constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
/// z component of the cross product: positive when `b` lies counter-clockwise of `a`.
[[nodiscard]] constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
[[nodiscard]] constexpr double squared_norm(Vec2 a) {
  return dot(a, a);
}
[[nodiscard]] inline double norm(Vec2 a) {
  return std::hypot(a.x, a.y);
}
/// `a` turned by +90 degrees.
[[nodiscard]] constexpr Vec2 perpendicular(Vec2 a) {
  return {-a.y, a.x};
}
/// The bearing of `a`, in (-pi, pi]; 0 for the zero vector.
[[nodiscard]] inline Angle bearing(Vec2 a) {
  return radians(std::atan2(a.y, a.x));
}
[[nodiscard]] inline Vec2 unit(Angle a) {
  return {cos(a), sin(a)};
}
[[nodiscard]] inline bool is_finite(Vec2 a) {
  return std::isfinite(a.x) && std::isfinite(a.y);
}

}  // namespace echoarc
