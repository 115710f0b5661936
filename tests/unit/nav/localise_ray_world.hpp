// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/maps/dense_grid.hpp"

/// A small world for tests of localisation: walls are segments, a sonar hears the nearest point of a fan of rays.
namespace echoarc::nav::testing {

struct Segment {
  Vec2 a;
  Vec2 b;
};
using Walls = std::vector<Segment>;

/// A closed outline.
inline Walls outline(const std::vector<Vec2>& corners) {
  Walls walls;
  for (std::size_t n = 0; n < corners.size(); ++n) walls.push_back({corners[n], corners[(n + 1) % corners.size()]});
  return walls;
}
/// 5 m x 4 m with an alcove, a slanted wall and a pillar: from nowhere does it look as from anywhere else.
inline Walls odd_room() {
  Walls walls = outline({{0, 0}, {5, 0}, {5, 2.5}, {4, 4}, {2.2, 4}, {2.2, 3.2}, {1.2, 3.2}, {1.2, 4}, {0, 4}});
  for (const Segment& side : outline({{3.6, 0}, {3.6, 0.6}, {4.0, 0.6}, {4.0, 0}})) walls.push_back(side);
  return walls;
}
/// Turned by half a turn it is the same.
inline Walls even_room() {
  return outline({{0, 0}, {5, 0}, {5, 4}, {0, 4}});
}

inline double ray_m(const Walls& walls, Vec2 from, Vec2 direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& wall : walls) {
    const double parallel = cross(direction, wall.b - wall.a);
    if (parallel == 0.0) continue;
    const double t = cross(wall.a - from, wall.b - wall.a) / parallel;
    const double along = cross(wall.a - from, direction) / parallel;
    if (t > 0.0 && along >= 0.0 && along <= 1.0) nearest = std::min(nearest, t);
  }
  return nearest;
}

/// Occupied where a wall passes, free within the outline's bounds otherwise.
inline DenseGrid<CellState> grid_of(const Walls& walls, double cell_m = 0.05) {
  Vec2 high;
  for (const Segment& wall : walls) high = {std::max(high.x, wall.a.x), std::max(high.y, wall.a.y)};
  const auto cells = [&](double length_m) { return static_cast<std::int32_t>(std::ceil((length_m + 0.4) / cell_m)); };
  DenseGrid<CellState> grid({cell_m, {-0.2, -0.2}}, cells(high.x), cells(high.y), CellState::free);
  for (std::int32_t j = 0; j < grid.height(); ++j)
    for (std::int32_t i = 0; i < grid.width(); ++i) {
      const Vec2 p = grid.geometry().centre({i, j});
      int crossings = 0;  // of a ray to the right: outside when even
      for (const Segment& wall : walls)
        if ((wall.a.y > p.y) != (wall.b.y > p.y) &&
            p.x < wall.a.x + (p.y - wall.a.y) / (wall.b.y - wall.a.y) * (wall.b.x - wall.a.x))
          ++crossings;
      if (crossings % 2 == 0) grid.at({i, j}) = CellState::unknown;
    }
  for (const Segment& wall : walls)
    for (double t = 0.0; t <= 1.0; t += 0.2 * cell_m / norm(wall.b - wall.a))
      grid.at(grid.geometry().cell_of(wall.a + t * (wall.b - wall.a))) = CellState::occupied;
  return grid;
}

constexpr int beams = 16;

/// The reading of one sonar of a ring of 0.2 m: the nearest of 9 rays over the beam, with noise; silence beyond 5 m.
inline Reading hear(const Walls& walls, const Pose2& T_world_robot, const Pose2& T_odom_robot, int beam, Rng& rng) {
  const Angle mount = degrees(360.0 * beam / beams);
  const Pose2 T_robot_sensor{0.2 * unit(mount), mount};
  const Pose2 T_world_sensor = T_world_robot * T_robot_sensor;
  Reading reading;
  reading.tx = reading.rx = static_cast<SensorId>(beam);
  reading.T_world_robot = T_odom_robot;
  reading.T_world_tx = reading.T_world_rx = T_odom_robot * T_robot_sensor;
  reading.beam_width = degrees(22.5);
  double range_m = std::numeric_limits<double>::infinity();
  for (int ray = -4; ray <= 4; ++ray)
    range_m =
        std::min(range_m, ray_m(walls, T_world_sensor.position, unit(T_world_sensor.heading + degrees(2.8 * ray))));
  range_m += rng.normal(0.0, 0.01);
  if (range_m > 5.0)
    reading.outcome = NoEcho{};
  else
    reading.outcome = Echo{std::max(range_m, 0.05)};
  return reading;
}

/// A robot that is driven in small steps; its odometry drifts.
class Wanderer {
 public:
  Wanderer(Walls walls, const Pose2& T_world_robot, std::uint64_t seed)
      : walls_(std::move(walls)), T_world_robot_(T_world_robot), rng_(seed) {}

  /// Turns on the spot by at most 10 degrees, or goes ahead by at most 0.1 m towards a place; false: it is there.
  bool step_towards(Vec2 place) {
    const Vec2 way = place - T_world_robot_.position;
    if (norm(way) < 1e-6) return false;
    const Angle turn = wrap(bearing(way) - T_world_robot_.heading);
    if (abs(turn) > degrees(1e-6))
      step({{}, std::clamp(turn, degrees(-10.0), degrees(10.0))});
    else
      step({{std::min(0.1, norm(way)), 0.0}, {}});
    return true;
  }
  void step(const Pose2& T_before_now) {
    const double length_m = norm(T_before_now.position);
    const Angle wander = rng_.normal(0.0, 1.0) * std::sqrt(length_m) * degrees(0.5);
    const Angle slip = rng_.normal(0.0, 0.02) * T_before_now.heading;
    const double scale = 1.005 + rng_.normal(0.0, 0.01);
    T_world_robot_ = T_world_robot_ * T_before_now;
    T_odom_robot_ = T_odom_robot_ * Pose2{scale * T_before_now.position, 1.01 * T_before_now.heading + wander + slip};
  }
  /// Puts it elsewhere; odometry does not notice.
  void carry(const Pose2& T_world_robot) { T_world_robot_ = T_world_robot; }
  void jump_odometry(const Pose2& T_odom_robot) { T_odom_robot_ = T_odom_robot; }

  [[nodiscard]] std::vector<Reading> listen() {
    std::vector<Reading> readings;
    for (int beam = 0; beam < beams; ++beam)
      readings.push_back(hear(walls_, T_world_robot_, T_odom_robot_, beam, rng_));
    return readings;
  }
  [[nodiscard]] const Pose2& T_world_robot() const { return T_world_robot_; }
  [[nodiscard]] const Pose2& T_odom_robot() const { return T_odom_robot_; }

 private:
  Walls walls_;
  Pose2 T_world_robot_;
  Pose2 T_odom_robot_;  // starts in its own origin
  Rng rng_;
};

/// Clear of the walls of both rooms, 20 m long when driven twice.
inline std::vector<Vec2> loop() {
  return {{0.7, 0.7}, {3.0, 0.8}, {3.3, 1.2}, {4.3, 1.4}, {4.0, 2.4}, {3.2, 3.0}, {1.7, 2.6}, {0.7, 2.4}};
}

}  // namespace echoarc::nav::testing
