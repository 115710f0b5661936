// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace echoarc {
namespace {

Vec2 normalised(Vec2 v) {
  const double length = norm(v);
  return length > 0.0 ? v / length : Vec2{1.0, 0.0};
}

/// Distance of the ellipse |P-F| + |P-G| = 2a from its focus F in a direction; d = |G - F|.
double focal_radius(double range_m, double foci_m, Angle from_focal_axis) {
  const double path = 2.0 * range_m;
  return (path * path - foci_m * foci_m) / (2.0 * (path - foci_m * cos(from_focal_axis)));
}

struct Interval {
  Angle low;
  Angle high;
};

/// The bearings, seen from the midpoint and relative to `axis`, of the part of the ellipse inside one sensor's beam.
Interval beam_about_midpoint(Vec2 own, Vec2 other, Angle own_axis, Angle half_width, double range_m, Angle axis) {
  const Vec2 midpoint = 0.5 * (own + other);
  const Angle focal = bearing(other - own);
  const auto seen_from_midpoint = [&](Angle beam_edge) {
    const Vec2 p = own + focal_radius(range_m, norm(other - own), beam_edge - focal) * unit(beam_edge);
    return wrap(bearing(p - midpoint) - axis);
  };
  return {seen_from_midpoint(own_axis - half_width), seen_from_midpoint(own_axis + half_width)};
}

/// Mean direction of two axes that are less than 180 degrees apart.
Angle mean_direction(Angle a, Angle b) {
  return a + 0.5 * wrap(b - a);
}

std::optional<Interval> beam_interval(const Pose2& tx, const Pose2& rx, double range_m, Angle half_width, Angle axis,
                                      BeamPolicy policy) {
  if (policy == BeamPolicy::bisector) return Interval{-half_width, half_width};
  const Interval a = beam_about_midpoint(tx.position, rx.position, tx.heading, half_width, range_m, axis);
  const Interval b = beam_about_midpoint(rx.position, tx.position, rx.heading, half_width, range_m, axis);
  if (policy == BeamPolicy::either) return Interval{std::min(a.low, b.low), std::max(a.high, b.high)};
  const Interval common{std::max(a.low, b.low), std::min(a.high, b.high)};
  if (common.high - common.low < min_arc) return std::nullopt;
  return common;
}

/// Whether a direction lies between two others that are less than half a turn apart, `eps_angle` beyond them included.
bool between(Vec2 begin, Vec2 direction, Vec2 end) {
  return cross(begin, direction) >= -eps_angle.rad() && cross(direction, end) >= -eps_angle.rad() &&
         dot(begin + end, direction) > 0.0;
}

/// The box of a circular arc between two directions from its centre.
Box circle_bounds(Vec2 centre, double radius_m, Vec2 begin, Vec2 end) {
  Box box{{std::min(begin.x, end.x), std::min(begin.y, end.y)}, {std::max(begin.x, end.x), std::max(begin.y, end.y)}};
  if (between(begin, {-1, 0}, end)) box.low.x = -1.0;
  if (between(begin, {1, 0}, end)) box.high.x = 1.0;
  if (between(begin, {0, -1}, end)) box.low.y = -1.0;
  if (between(begin, {0, 1}, end)) box.high.y = 1.0;
  return {centre + radius_m * box.low, centre + radius_m * box.high};
}

constexpr int gauss_points = 16;
struct GaussNode {
  double x, weight;
};
// Positive half of the 16-point Gauss-Legendre rule on [-1, 1].
constexpr std::array<GaussNode, gauss_points / 2> gauss_rule{{
    {0.0950125098376374402, 0.1894506104550684963},
    {0.2816035507792589132, 0.1826034150449235889},
    {0.4580167776572273863, 0.1691565193950025382},
    {0.6178762444026437484, 0.1495959888165767321},
    {0.7554044083550030339, 0.1246289712555338720},
    {0.8656312023878317439, 0.0951585116824927848},
    {0.9445750230732325761, 0.0622535239386478929},
    {0.9894009349916499326, 0.0271524594117540949},
}};

}  // namespace

Arc Arc::circular(Vec2 sensor, Angle axis, double range_m, Angle beam_width) {
  assert(range_m > 0.0 && beam_width > Angle{} && beam_width < degrees(180.0));
  Arc arc;
  arc.centre_ = sensor;
  arc.range_m_ = arc.semi_minor_m_ = range_m;
  arc.axis_ = axis;
  arc.half_width_ = 0.5 * beam_width;
  arc.set_limits(-arc.half_width_, arc.half_width_);
  return arc;
}

std::optional<Arc> Arc::elliptical(const Pose2& T_world_tx, const Pose2& T_world_rx, double range_m, Angle beam_width,
                                   BeamPolicy policy) {
  const Vec2 foci = T_world_rx.position - T_world_tx.position;
  const double foci_m = norm(foci);
  if (2.0 * range_m <= foci_m + eps_length_m) return std::nullopt;
  if (abs(wrap(T_world_rx.heading - T_world_tx.heading)) > degrees(90.0) + eps_angle) return std::nullopt;

  const Angle mean_axis = mean_direction(T_world_tx.heading, T_world_rx.heading);
  const Vec2 midpoint = 0.5 * (T_world_tx.position + T_world_rx.position);
  if (foci_m < eps_length_m) return circular(midpoint, mean_axis, range_m, beam_width);

  const auto interval = beam_interval(T_world_tx, T_world_rx, range_m, 0.5 * beam_width, mean_axis, policy);
  if (!interval) return std::nullopt;
  Arc arc;
  arc.centre_ = midpoint;
  arc.focal_axis_ = foci / foci_m;
  arc.semi_focal_m_ = 0.5 * foci_m;
  arc.range_m_ = range_m;
  arc.semi_minor_m_ = std::sqrt((range_m - arc.semi_focal_m_) * (range_m + arc.semi_focal_m_));
  arc.axis_ = mean_axis + 0.5 * (interval->low + interval->high);
  arc.half_width_ = 0.5 * (interval->high - interval->low);
  arc.set_limits(-arc.half_width_, arc.half_width_);
  return arc;
}

void Arc::set_limits(Angle begin, Angle end) {
  assert(begin <= end);
  t_begin_ = begin;
  t_end_ = end;
}

Arc Arc::at_range(double range_m) const {
  assert(range_m > semi_focal_m_);
  Arc arc = *this;
  arc.range_m_ = range_m;
  arc.semi_minor_m_ = std::sqrt((range_m - semi_focal_m_) * (range_m + semi_focal_m_));
  return arc;
}

double Arc::radius_at(Angle t) const {
  if (is_circular()) return range_m_;
  const Vec2 u = unit(axis_ + t);
  return range_m_ * semi_minor_m_ / std::hypot(semi_minor_m_ * dot(u, focal_axis_), range_m_ * cross(focal_axis_, u));
}

Vec2 Arc::point_at(Angle t) const {
  return centre_ + radius_at(t) * unit(axis_ + t);
}

Vec2 Arc::normal_at(Angle t) const {
  if (is_circular()) return unit(axis_ + t);
  const Vec2 p = point_at(t);
  return normalised(normalised(p - transmitter()) + normalised(p - receiver()));
}

double Arc::length_m() const {
  const Angle middle = 0.5 * (t_begin_ + t_end_);
  const Angle half = 0.5 * (t_end_ - t_begin_);
  if (is_circular()) return 2.0 * half.rad() * range_m_;
  // ds/dt = rho / (radial component of the normal): the tangent leans away from the radius by the same angle.
  const auto speed = [&](Angle t) { return radius_at(t) / dot(normal_at(t), unit(axis_ + t)); };
  double sum = 0.0;
  for (const auto& [x, weight] : gauss_rule) sum += weight * (speed(middle + x * half) + speed(middle - x * half));
  return sum * half.rad();
}

bool Arc::contains_bearing(Angle bearing) const {
  const Angle t = wrap(bearing - axis_);
  return t >= t_begin_ - eps_angle && t <= t_end_ + eps_angle;
}

double Arc::half_path_m(Vec2 p) const {
  if (is_circular()) return norm(p - centre_);
  return 0.5 * (norm(p - transmitter()) + norm(p - receiver()));
}

Box Arc::bounds() const {
  if (is_circular()) return circle_bounds(centre_, range_m_, unit(axis_ + t_begin_), unit(axis_ + t_end_));
  const Vec2 a = point_at(t_begin_);
  const Vec2 b = point_at(t_end_);
  Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  // The extreme point in direction n has offset (A^2 (n.f), B^2 (n.g)) / sqrt(...) along the axes f, g of the ellipse.
  const auto extend = [&](Vec2 n) {
    const Vec2 f = focal_axis_;
    const Vec2 g = perpendicular(f);
    const double along = range_m_ * range_m_ * dot(n, f);
    const double across = semi_minor_m_ * semi_minor_m_ * dot(n, g);
    const Vec2 offset = (along * f + across * g) / std::hypot(range_m_ * dot(n, f), semi_minor_m_ * dot(n, g));
    if (!contains_bearing(bearing(offset))) return;
    const Vec2 p = centre_ + offset;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  };
  for (const Vec2 n : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) extend(n);
  return box;
}

std::optional<Arc> arc_of(const Reading& reading, BeamPolicy policy) {
  const auto range_m = echo_range_m(reading.outcome);
  if (!range_m) return std::nullopt;
  if (!reading.monostatic())
    return Arc::elliptical(reading.T_world_tx, reading.T_world_rx, *range_m, reading.beam_width, policy);
  return Arc::circular(reading.T_world_tx.position, reading.T_world_tx.heading, *range_m, reading.beam_width);
}

}  // namespace echoarc
