// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoarc/nav/path.hpp"

namespace echoarc::nav {
namespace {

// The robot is looked for so far ahead on the path, beyond the point it heads for.
constexpr double search_ahead_m = 1.0;
// A target is drawn in no further than this part of the distance ahead; then it is up to avoidance.
constexpr double least_look_ahead = 0.25;
// Of the bearing of the target, per second, when turning on the spot.
constexpr double turn_gain_per_s = 2.0;
// So near to the target the robot has met it.
constexpr double met_m = 0.05;
// Nearer than this there is no bearing to speak of.
constexpr double at_target_m = 1e-3;

}  // namespace

void PathFollower::follow(std::vector<Vec2> path) {
  path_ = std::move(path);
  length_m_ = length_m(path_);
  along_m_ = 0.0;
}

Following PathFollower::update(const Pose2& T_world_base, const Sight& in_sight) {
  const Vec2 robot = T_world_base.position;
  const auto place = nearest_place(path_, robot, along_m_, along_m_ + options_.look_ahead_m + search_ahead_m);
  if (!place || !is_finite(T_world_base)) return {robot, length_m_ - along_m_, 0.0, path_.empty()};
  along_m_ = std::max(along_m_, place->along_m);
  double ahead_m = options_.look_ahead_m;
  Vec2 target = point_at(path_, along_m_ + ahead_m);
  while (in_sight && ahead_m > least_look_ahead * options_.look_ahead_m && !in_sight(robot, target)) {
    ahead_m *= 0.7;
    target = point_at(path_, along_m_ + ahead_m);
  }
  // Where the path crosses itself the robot may have come to the target on the wrong leg.
  if (norm(target - robot) < met_m) along_m_ = std::min(along_m_ + ahead_m, length_m_);
  const double to_end_m = norm(path_.back() - robot);
  const double remaining_m = std::max(length_m_ - along_m_, to_end_m);
  const bool arrived = to_end_m <= options_.arrival_m && remaining_m <= 2.0 * options_.arrival_m;
  return {target, remaining_m, place->distance_m, arrived};
}

RobotVelocity steer_to(const Pose2& T_world_base, Vec2 target, double remaining_m, const RobotLimits& limits,
                       const PathFollowerOptions& options) {
  const Vec2 to_target = rotate(target - T_world_base.position, -T_world_base.heading);
  const double distance_m = norm(to_target);
  if (!std::isfinite(distance_m) || distance_m < at_target_m) return {};
  const Angle off = bearing(to_target);
  const double turn_limit = limits.turn_rate_per_s.rad();
  if (abs(off) > options.turn_first)
    return {0.0, radians(std::clamp(turn_gain_per_s * off.rad(), -turn_limit, turn_limit))};
  const double curvature_per_m = 2.0 * to_target.y / (distance_m * distance_m);  // [Coulter92]
  double speed_m_s = std::min(
      {options.speed_m_s, limits.speed_m_s, std::sqrt(2.0 * limits.acceleration_m_s2 * std::max(remaining_m, 0.0))});
  if (std::abs(curvature_per_m) * speed_m_s > turn_limit) speed_m_s = turn_limit / std::abs(curvature_per_m);
  return {speed_m_s, radians(curvature_per_m * speed_m_s)};
}

}  // namespace echoarc::nav
