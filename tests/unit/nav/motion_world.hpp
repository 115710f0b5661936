// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "echoarc/nav/acceleration.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

/// A wall from `from` to `to`, m.
struct Segment {
  Vec2 from;
  Vec2 to;
};

inline double distance_m(const Segment& wall, Vec2 point) {
  const Vec2 along = wall.to - wall.from;
  const double s = std::clamp(dot(point - wall.from, along) / squared_norm(along), 0.0, 1.0);
  return norm(point - wall.from - s * along);
}

/// How far along a ray a wall is hit.
inline double hit_m(const Segment& wall, Vec2 from, Vec2 way) {
  const Vec2 along = wall.to - wall.from;
  const double across = cross(way, along);
  if (across == 0.0) return std::numeric_limits<double>::infinity();
  const double way_m = cross(wall.from - from, along) / across;
  const double s = cross(wall.from - from, way) / across;
  return way_m >= 0.0 && s >= 0.0 && s <= 1.0 ? way_m : std::numeric_limits<double>::infinity();
}

inline std::vector<Segment> rectangle(Vec2 low, Vec2 high) {
  const Vec2 right{high.x, low.y};
  const Vec2 left{low.x, high.y};
  return {{low, right}, {right, high}, {high, left}, {left, low}};
}

inline std::vector<Segment> operator+(std::vector<Segment> a, const std::vector<Segment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A disc among walls that hears, ten times a second, the nearest wall in each of 16 directions, within 3 m, and
/// remembers it for a while. Its motors obey their limits.
class MotionWorld {
 public:
  static constexpr double step_s = 0.1;
  static constexpr int directions = 16;
  static constexpr double range_m = 3.0;

  MotionWorld(std::vector<Segment> walls, const Pose2& T_world_base, const RobotBody& body = {})
      : walls_(std::move(walls)), body_(body) {
    now_.T_world_base = T_world_base;
  }

  std::size_t remembered_scans = 50;
  int echo_every = 1;  // of so many rays of a scan one is heard
  bool deaf = false;

  [[nodiscard]] Surroundings surroundings() {
    listen();
    now_.points = points_;
    return now_;
  }

  /// One step of a tenth of a second.
  void drive(const RobotVelocity& wanted) {
    now_.velocity = accelerated(now_.velocity, wanted, body_.limits, step_s);
    constexpr int parts = 10;
    for (int k = 0; k < parts; ++k) {
      Pose2& T_world_base = now_.T_world_base;
      const double time_s = step_s / parts;
      T_world_base.heading += time_s * now_.velocity.turn_per_s;
      const Vec2 step = time_s * now_.velocity.forward_m_s * unit(T_world_base.heading);
      T_world_base.position = T_world_base.position + step;
      driven_m_ += norm(step);
      for (const Segment& wall : walls_) clearance_m_ = std::min(clearance_m_, distance_m(wall, T_world_base.position));
    }
    now_.time_s += step_s;
    track_.push_back(now_.T_world_base);
  }

  /// Drives by what `strategy` wants until it ends, at most so long; the last it said.
  Steering run(Strategy& strategy, double longest_s) {
    Steering steering;
    while (now_.time_s < longest_s) {
      steering = strategy.update(surroundings());
      if (steering.status != Status::running) break;
      drive(steering.wanted);
      if (watch) watch(steering);
    }
    return steering;
  }

  std::function<void(const Steering&)> watch;

  void jump(Vec2 by) { now_.T_world_base.position = now_.T_world_base.position + by; }
  [[nodiscard]] const Pose2& T_world_base() const { return now_.T_world_base; }
  [[nodiscard]] double time_s() const { return now_.time_s; }
  [[nodiscard]] double driven_m() const { return driven_m_; }
  /// The least ever left between hull and wall; negative: it hit one.
  [[nodiscard]] double clearance_m() const { return clearance_m_ - body_.radius_m; }
  [[nodiscard]] const std::vector<Pose2>& track() const { return track_; }

 private:
  void listen() {
    std::vector<Vec2> heard;
    for (int k = 0; k < directions && !deaf; ++k) {
      if ((k + scan_) % echo_every != 0) continue;
      const Vec2 way = unit(now_.T_world_base.heading + degrees(360.0 * k / directions));
      double nearest_m = range_m;
      for (const Segment& wall : walls_) nearest_m = std::min(nearest_m, hit_m(wall, now_.T_world_base.position, way));
      if (nearest_m < range_m) heard.push_back(now_.T_world_base.position + nearest_m * way);
    }
    ++scan_;
    scans_.push_back(std::move(heard));
    if (scans_.size() > remembered_scans) scans_.pop_front();
    points_.clear();
    for (const auto& scan : scans_) points_.insert(points_.end(), scan.begin(), scan.end());
  }

  std::vector<Segment> walls_;
  RobotBody body_;
  Surroundings now_;
  std::deque<std::vector<Vec2>> scans_;
  std::vector<Vec2> points_;
  std::vector<Pose2> track_;
  double driven_m_ = 0.0;
  double clearance_m_ = std::numeric_limits<double>::infinity();
  int scan_ = 0;
};

}  // namespace echoarc::nav
