// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "sim/spatial_index.hpp"

namespace echoarc::sim {

namespace {

constexpr double overhang_m = 1e-9;
constexpr double parallel = 1e-12;  // sine of the angle below which ray and segment count as parallel

double crossing_along(const Ray& ray, const Segment& segment, Vec2 to_a) {
  if (segment.one_sided) return never;
  const double beside_m = cross(ray.direction, to_a);
  if (std::abs(beside_m) > overhang_m) return never;
  const double a = dot(to_a, ray.direction);
  const double b = a + dot(segment.along, ray.direction);
  const double enter = std::max(std::min(a, b), ray.from_m);
  return enter <= std::min(std::max(a, b), ray.to_m) ? enter : never;
}

}  // namespace

double crossing(const Ray& ray, const Segment& segment) {
  const Vec2 to_a = segment.a - ray.origin;
  const double turn = cross(ray.direction, segment.along);
  // Both sides of the wall's inequality are multiplied by |turn|, which is at most the wall's length: no division for
  // the many segments that the ray misses.
  const double sign = turn < 0.0 ? -1.0 : 1.0;
  const double scale = std::abs(turn);
  const double s = sign * cross(to_a, ray.direction);
  if (s < -overhang_m || s > scale + overhang_m) return never;
  const double t = sign * cross(to_a, segment.along);
  if (scale <= parallel * norm(segment.along)) return crossing_along(ray, segment, to_a);
  if (segment.one_sided && sign < 0.0) return never;
  if (t < ray.from_m * scale || t > ray.to_m * scale) return never;
  return t / scale;
}

double crossing(const Ray& ray, const Disc& disc) {
  const Vec2 to_centre = disc.centre - ray.origin;
  const double along = dot(to_centre, ray.direction);
  const double beside = cross(ray.direction, to_centre);
  const double half_chord2 = disc.radius_m * disc.radius_m - beside * beside;
  if (half_chord2 <= 0.0) return never;
  const double half_chord = std::sqrt(half_chord2);
  const double enter = along - half_chord;
  const double leave = along + half_chord;
  if (enter >= ray.from_m && enter <= ray.to_m) return enter;
  return leave >= ray.from_m && leave <= ray.to_m ? leave : never;
}

double distance_to_segment(Vec2 point, Vec2 a, Vec2 along) {
  const double s = std::clamp(dot(point - a, along) / squared_norm(along), 0.0, 1.0);
  return norm(point - a - s * along);
}

}  // namespace echoarc::sim
