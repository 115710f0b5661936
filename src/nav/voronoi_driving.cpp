// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "nav/voronoi_driving.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc::nav {
namespace {

constexpr double stop_before_m = 0.04;         // of the rim to what stands ahead
constexpr double look_ahead_m = 0.30;          // on a known line
constexpr double step_m = 0.05;                // between its vertices
constexpr double arrived_m = 0.08;             // from the end of a line
constexpr double turn_gain_per_s = 2.0;        // turning rate over error of heading
constexpr Angle drive_within = degrees(40.0);  // beyond this error of heading the disc turns on the spot

}  // namespace

double free_ahead_m(std::span<const Vec2> points, const Pose2& T_world_base, double radius_m) {
  const Pose2 T_base_world = inverse(T_world_base);
  double free_m = std::numeric_limits<double>::infinity();
  for (const Vec2 p : points) {
    const Vec2 q = T_base_world * p;
    if (!(q.x > 0.0) || !(std::abs(q.y) < radius_m)) continue;
    free_m = std::min(free_m, std::max(0.0, q.x - std::sqrt(radius_m * radius_m - q.y * q.y)));
  }
  return free_m;
}

RobotVelocity steer_towards(const Pose2& T_world_base, Vec2 wanted_m_s, const RobotBody& body,
                            std::span<const Vec2> points) {
  const double speed = norm(wanted_m_s);
  if (!(speed > 1e-6)) return {};
  const Angle error = wrap(bearing(wanted_m_s) - T_world_base.heading);
  const Angle limit = body.limits.turn_rate_per_s;
  RobotVelocity velocity;
  velocity.turn_per_s = std::clamp(turn_gain_per_s * error, -limit, limit);
  if (abs(error) > drive_within) return velocity;
  const double free_m = free_ahead_m(points, T_world_base, body.radius_m) - stop_before_m;
  const double stoppable = std::sqrt(2.0 * body.limits.acceleration_m_s2 * std::max(0.0, free_m));
  velocity.forward_m_s = std::min({speed * cos(error), stoppable, body.limits.speed_m_s});
  return velocity;
}

void LineFollower::begin(Vec2 place, std::span<const Vec2> line) {
  line_.assign(1, place);
  next_ = 0;
  for (const Vec2 end : line) {  // in short steps, so that the nearest vertex is about the nearest place
    const Vec2 start = line_.back();
    const int steps = std::clamp(int(std::ceil(norm(end - start) / step_m)), 1, 1000);
    for (int i = 1; i <= steps; ++i) line_.push_back(start + (double(i) / double(steps)) * (end - start));
  }
}

std::optional<Vec2> LineFollower::target(Vec2 place) {
  if (line_.empty() || norm(line_.back() - place) < arrived_m) return {};
  // Only the part just ahead is searched: a line may pass here again later.
  double along_m = 0.0;
  std::size_t nearest = next_;
  for (std::size_t i = next_; i < line_.size() && along_m < 2.0 * look_ahead_m; ++i) {
    if (norm(line_[i] - place) < norm(line_[nearest] - place)) nearest = i;
    if (i + 1 < line_.size()) along_m += norm(line_[i + 1] - line_[i]);
  }
  next_ = nearest;
  std::size_t target = next_;
  while (target + 1 < line_.size() && norm(line_[target] - place) < look_ahead_m) ++target;
  return line_[target];
}

}  // namespace echoarc::nav
