// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/side_wall.hpp"

#include <cmath>
#include <vector>

namespace echoarc::nav {
namespace {

constexpr double line_length_m = 0.5;
constexpr double other_wall_m = 0.3;
constexpr double same_point_m = 0.02;
constexpr double track_spread_m = 0.12;
constexpr double track_off_m = 0.03;  // a step in the wall has no direction

}  // namespace

SectorMinima sector_minima(const Pose2& T_world_base, WallSide side, std::span<const Vec2> points) {
  const Vec2 ahead = unit(T_world_base.heading);
  const double cos30 = std::cos(degrees(30.0).rad());
  constexpr double cos60 = 0.5;
  SectorMinima minima;
  for (const Vec2 point : points) {
    const Vec2 there = point - T_world_base.position;
    const double distance_m = norm(there);
    if (!(distance_m > 0.0) || !std::isfinite(distance_m)) continue;
    const double along = dot(ahead, there) / distance_m;
    const bool wallwards = sign_of(side) * cross(ahead, there) > 0.0;
    if (along >= cos30) {
      minima.front_m = std::min(minima.front_m, distance_m);
    } else if (along >= cos60) {
      if (!wallwards || distance_m >= minima.front_side_m) continue;
      minima.front_side_m = distance_m;
      minima.front_side_point = point;
    } else if (along >= -cos60) {
      if (!wallwards) minima.other_side_m = std::min(minima.other_side_m, distance_m);
      if (!wallwards || distance_m >= minima.side_m) continue;
      minima.side_m = distance_m;
      minima.side_point = point;
    }
  }
  return minima;
}

std::optional<Vec2> nearest_of(Vec2 position, std::span<const Vec2> points) {
  std::optional<Vec2> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 point : points) {
    const double squared = squared_norm(point - position);
    if (!(squared < least)) continue;
    least = squared;
    nearest = point;
  }
  return nearest;
}

std::optional<Angle> line_along(std::span<const Vec2> points, Angle along, double least_spread_m, double most_off_m) {
  if (points.size() < 3) return {};
  Vec2 mean;
  for (const Vec2 point : points) mean = mean + point;
  mean = mean / double(points.size());
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Vec2 point : points) {
    const Vec2 off = point - mean;
    xx += off.x * off.x;
    xy += off.x * off.y;
    yy += off.y * off.y;
  }
  const Angle direction = radians(0.5 * std::atan2(2.0 * xy, xx - yy));
  const Vec2 axis = unit(direction);
  double least = 0.0;
  double most = 0.0;
  double off = 0.0;
  for (const Vec2 point : points) {
    const double s = dot(axis, point - mean);
    off += squared_norm(point - mean) - s * s;
    least = std::min(least, s);
    most = std::max(most, s);
  }
  if (!(most - least >= least_spread_m)) return {};
  if (off > most_off_m * most_off_m * double(points.size())) return {};
  return dot(axis, unit(along)) >= 0.0 ? direction : wrap(direction + degrees(180.0));
}

void SideWall::add(Vec2 point) {
  if (!points_.empty()) {
    const double step_m = norm(point - points_.back());
    if (step_m < same_point_m) return;
    if (step_m > other_wall_m) points_.clear();
  }
  points_.push_back(point);
  while (norm(points_.front() - point) > line_length_m) points_.pop_front();
}

std::optional<Angle> SideWall::direction(Angle heading) const {
  return line_along(std::vector<Vec2>(points_.begin(), points_.end()), heading, track_spread_m, track_off_m);
}

}  // namespace echoarc::nav
