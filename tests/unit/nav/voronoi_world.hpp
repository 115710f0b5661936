// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav::voronoi_world {

struct Wall {
  Vec2 a;
  Vec2 b;
};

inline std::vector<Wall> outline(const std::vector<Vec2>& corners) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < corners.size(); ++i) walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return walls;
}

inline std::vector<Wall> rectangle(Vec2 low, Vec2 high) {
  return outline({low, {high.x, low.y}, high, {low.x, high.y}});
}

/// The T of corridors of scenes/t-world.toml.
inline std::vector<Wall> t_world() {
  return outline(
      {{-5, 4}, {-1, 4}, {-1, 0}, {-.45, 0}, {-.45, -4}, {.45, -4}, {.45, 0}, {1, 0}, {1, 4}, {5, 4}, {5, 6}, {-5, 6}});
}

/// A corridor of 2 m around a block.
inline std::vector<Wall> ring() {
  std::vector<Wall> walls = rectangle({0, 0}, {9, 8});
  for (const Wall& w : rectangle({2, 2}, {7, 6})) walls.push_back(w);
  return walls;
}

inline double distance_m(const Wall& wall, Vec2 p) {
  const Vec2 along = wall.b - wall.a;
  const double t = std::clamp(dot(p - wall.a, along) / squared_norm(along), 0.0, 1.0);
  return norm(wall.a + t * along - p);
}

inline double distance_m(const std::vector<Wall>& walls, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Wall& w : walls) least = std::min(least, distance_m(w, p));
  return least;
}

inline bool crosses(const Wall& wall, Vec2 from, Vec2 to) {
  const auto side = [](Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a); };
  return side(wall.a, wall.b, from) * side(wall.a, wall.b, to) < 0.0 &&
         side(from, to, wall.a) * side(from, to, wall.b) < 0.0;
}

struct Sight {
  double spacing_m = 0.02;
  double reach_m = 4.0;
  double noise_m = 0.0;  ///< standard deviation along both axes
  std::uint64_t seed = 1;
};

/// Walls as points that are seen from within.
class World {
 public:
  explicit World(std::vector<Wall> walls, const Sight& sight = {})
      : walls_(std::move(walls)), sight_(sight), rng_(sight.seed) {
    for (const Wall& wall : walls_) {
      const double length = norm(wall.b - wall.a);
      const int steps = std::max(1, int(std::lround(length / sight.spacing_m)));
      for (int i = 0; i < steps; ++i)
        points_.push_back(wall.a + ((double(i) + 0.5) / double(steps)) * (wall.b - wall.a));
    }
  }
  [[nodiscard]] const std::vector<Wall>& walls() const { return walls_; }

  [[nodiscard]] std::vector<Vec2> visible(Vec2 from) {
    std::vector<Vec2> seen;
    const auto noise = [&] { return rng_.normal(0.0, sight_.noise_m); };
    for (const Vec2 p : points_) {
      if (squared_norm(p - from) > sight_.reach_m * sight_.reach_m) continue;
      const Vec2 just_before = p + 1e-6 * (from - p);
      if (std::any_of(walls_.begin(), walls_.end(), [&](const Wall& w) { return crosses(w, from, just_before); }))
        continue;
      seen.push_back(sight_.noise_m > 0.0 ? p + Vec2{noise(), noise()} : p);
    }
    return seen;
  }

 private:
  std::vector<Wall> walls_;
  Sight sight_;
  std::vector<Vec2> points_;
  Rng rng_;
};

struct Drive {
  Steering last;
  Pose2 T_world_base;
  double time_s = 0.0;
  double least_clearance_m = std::numeric_limits<double>::infinity();
  double length_m = 0.0;
  std::vector<Vec2> path;
};

/// Drives a disc by a strategy until it ends or the time is up; `meddle` may change what it is told.
inline Drive drive(Strategy& strategy, World& world, const Pose2& start, const RobotBody& body, double longest_s,
                   const std::function<void(Surroundings&)>& meddle = {}) {
  constexpr double step_s = 0.1;
  constexpr int look_every = 3;
  Drive run;
  run.T_world_base = start;
  RobotVelocity velocity;
  std::vector<Vec2> points;
  for (int i = 0; run.time_s < longest_s; ++i, run.time_s += step_s) {
    if (i % look_every == 0) points = world.visible(run.T_world_base.position);
    Surroundings now{run.time_s, run.T_world_base, velocity, points};
    if (meddle) meddle(now);
    run.last = strategy.update(now);
    if (run.last.status != Status::running) break;
    const double speed_step = body.limits.acceleration_m_s2 * step_s;
    const Angle turn_step = step_s * body.limits.turn_acceleration_per_s2;
    velocity.forward_m_s += std::clamp(run.last.wanted.forward_m_s - velocity.forward_m_s, -speed_step, speed_step);
    velocity.turn_per_s += std::clamp(run.last.wanted.turn_per_s - velocity.turn_per_s, -turn_step, turn_step);
    run.T_world_base.heading = wrap(run.T_world_base.heading + step_s * velocity.turn_per_s);
    run.T_world_base.position = run.T_world_base * Vec2{step_s * velocity.forward_m_s, 0.0};
    run.length_m += std::abs(step_s * velocity.forward_m_s);
    run.path.push_back(run.T_world_base.position);
    run.least_clearance_m = std::min(run.least_clearance_m, distance_m(world.walls(), run.T_world_base.position));
  }
  return run;
}

}  // namespace echoarc::nav::voronoi_world
