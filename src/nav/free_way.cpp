// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/free_way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "echoarc/nav/acceleration.hpp"

namespace echoarc::nav {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double straight_m = 1e4;  // a circle so large is a line

/// Way of a disc until its rim meets `point`, both seen from the disc's centre with the motion along +x.
std::optional<double> way_ahead(Vec2 point, double radius_m) {
  if (point.x <= 0.0 || std::abs(point.y) >= radius_m) return {};
  return std::max(0.0, point.x - std::sqrt(radius_m * radius_m - point.y * point.y));
}

/// The same on a circle through the origin, tangent to +x there, with its centre at (0, `turn_m`), at most once round.
std::optional<double> way_around(Vec2 point, double radius_m, double turn_m) {
  const double circle_m = std::abs(turn_m);
  if (turn_m < 0.0) point.y = -point.y;
  const Vec2 from_centre = point - Vec2{0.0, circle_m};
  const double far_m = norm(from_centre);
  if (std::abs(far_m - circle_m) >= radius_m || far_m == 0.0) return {};
  // Half the angle under which the disc, on its circle, hides the point.
  const double hidden = std::acos(
      std::clamp((circle_m * circle_m + far_m * far_m - radius_m * radius_m) / (2.0 * circle_m * far_m), -1.0, 1.0));
  double ahead = std::atan2(from_centre.x, -from_centre.y);  // from (0, -1), where the disc is, counter-clockwise
  if (norm(point) < radius_m) return ahead > 0.0 ? std::optional(0.0) : std::nullopt;
  if (ahead < 0.0) ahead += full_turn;
  return circle_m * std::max(0.0, ahead - hidden);
}

bool moves(const RobotVelocity& velocity) {
  return velocity.forward_m_s != 0.0 && std::isfinite(velocity.forward_m_s) && is_finite(velocity.turn_per_s);
}

/// Where a disc goes, world. Backwards is forwards for who looks back.
Vec2 axis_of(const Pose2& T_world_base, const RobotVelocity& velocity) {
  const Vec2 ahead = unit(T_world_base.heading);
  return velocity.forward_m_s < 0.0 ? -ahead : ahead;
}

}  // namespace

FreeWay::FreeWay(const Pose2& T_world_base, const RobotVelocity& velocity, double hull_radius_m, double look_m)
    : position_(T_world_base.position),
      axis_(axis_of(T_world_base, velocity)),
      hull_radius_m_(hull_radius_m),
      look_m_(look_m),
      nearest_m_(look_m),
      moving_(moves(velocity)) {
  if (!moving_) return;
  if (!is_finite(T_world_base)) nearest_m_ = 0.0;
  const double turn_rad_s = velocity.turn_per_s.rad();
  // Looking back, left and right change places, while the sense of the turn stays.
  turn_m_ = turn_rad_s != 0.0 ? std::abs(velocity.forward_m_s) / turn_rad_s : straight_m;
  straight_ = !(std::abs(turn_m_) < straight_m);
}

void FreeWay::meet(Vec2 point) {
  const Vec2 there = point - position_;
  const double heeded_m = nearest_m_ + hull_radius_m_;
  if (!moving_ || !(squared_norm(there) <= heeded_m * heeded_m)) return;
  const Vec2 seen{dot(axis_, there), cross(axis_, there)};
  const auto way_m = straight_ ? way_ahead(seen, hull_radius_m_) : way_around(seen, hull_radius_m_, turn_m_);
  if (way_m) nearest_m_ = std::min(nearest_m_, *way_m);
}

std::optional<double> FreeWay::free_m() const {
  if (nearest_m_ < look_m_) return nearest_m_;
  return {};
}

std::optional<double> free_way_m(const Pose2& T_world_base, const RobotVelocity& velocity, double hull_radius_m,
                                 std::span<const Vec2> points, double look_m) {
  FreeWay way(T_world_base, velocity, hull_radius_m, look_m);
  for (const Vec2 point : points) way.meet(point);
  return way.free_m();
}

bool emergency(const Pose2& T_world_base, const RobotVelocity& velocity, double hull_radius_m,
               std::span<const Vec2> points, double margin_m) {
  if (!moves(velocity)) return false;
  const Vec2 axis = axis_of(T_world_base, velocity);
  const double near_m = hull_radius_m + margin_m;
  return std::ranges::any_of(points, [&](Vec2 point) {
    const Vec2 there = point - T_world_base.position;
    return squared_norm(there) < near_m * near_m && dot(there, axis) > 0.0;
  });
}

RobotVelocity safe_velocity(const Pose2& T_world_base, const RobotVelocity& wanted, double hull_radius_m,
                            std::span<const Vec2> points, const SafetyOptions& options) {
  if (!std::isfinite(wanted.forward_m_s) || !is_finite(wanted.turn_per_s)) return {};
  RobotVelocity safe = wanted;
  if (emergency(T_world_base, wanted, hull_radius_m, points, options.emergency_m)) safe.forward_m_s = 0.0;
  // Slower at the same turning rate is another arc, a tighter one, which has to be free as well.
  constexpr int rounds = 3;
  for (int round = 0; round < rounds && safe.forward_m_s != 0.0; ++round) {
    const auto free_m = free_way_m(T_world_base, safe, hull_radius_m, points);
    if (!free_m) break;
    const double cap_m_s = speed_cap_m_s(*free_m, options.stop_distance_m, options.deceleration_m_s2);
    if (std::abs(safe.forward_m_s) <= cap_m_s) break;
    safe.forward_m_s = std::copysign(cap_m_s, safe.forward_m_s);
    if (cap_m_s == 0.0) safe.forward_m_s = 0.0;
  }
  return safe;
}

}  // namespace echoarc::nav
