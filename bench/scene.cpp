// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoarc::bench {
namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

/// A beam seen from its apex: points are tested by two cross products, no angles.
struct Beam {
  Vec2 low;  // unit vectors along the two edges
  Vec2 high;

  [[nodiscard]] double distance_to(Vec2 p) const {
    return cross(low, p) >= 0.0 && cross(p, high) >= 0.0 ? norm(p) : nothing;
  }
};

double along_ray(Vec2 direction, Vec2 a, Vec2 b) {
  const double turn = cross(direction, b - a);
  if (turn == 0.0) return nothing;
  const double range = cross(a, b - a) / turn;
  const double fraction = cross(a, direction) / turn;
  return range >= 0.0 && fraction >= 0.0 && fraction <= 1.0 ? range : nothing;
}

/// Nearest point of a segment in the beam: the foot of the perpendicular, an end, or where an edge of the beam meets
/// it.
double nearest(const Beam& beam, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double fraction = std::clamp(-dot(a, d) / squared_norm(d), 0.0, 1.0);
  return std::min({beam.distance_to(a + fraction * d), beam.distance_to(a), beam.distance_to(b),
                   along_ray(beam.low, a, b), along_ray(beam.high, a, b)});
}

double along_ray(Vec2 direction, Vec2 centre, double radius_m) {
  const double along = dot(direction, centre);
  const double inside = radius_m * radius_m - (squared_norm(centre) - along * along);
  return along > 0.0 && inside >= 0.0 ? along - std::sqrt(inside) : nothing;
}

double nearest(const Beam& beam, Vec2 centre, double radius_m) {
  return std::min({beam.distance_to(centre) - radius_m, along_ray(beam.low, centre, radius_m),
                   along_ray(beam.high, centre, radius_m)});
}

void add_box(Scene& scene, Vec2 low, Vec2 high) {
  const Vec2 right{high.x, low.y};
  const Vec2 left{low.x, high.y};
  scene.walls.insert(scene.walls.end(), {{low, right}, {right, high}, {high, left}, {left, low}});
}

}  // namespace

Scene hall() {
  Scene scene{{20.0, 15.0}, {}, {{{3.0, 3.0}, 0.25}, {{17.0, 3.0}, 0.25}, {{17.0, 12.0}, 0.25}, {{3.0, 12.0}, 0.25}}};
  add_box(scene, {0.0, 0.0}, scene.size);
  add_box(scene, {5.5, 5.5}, {14.5, 9.5});
  add_box(scene, {0.0, 12.0}, {0.6, 14.0});
  return scene;
}

Scene chamber() {
  Scene scene{{5.25, 5.25}, {}, {}};
  add_box(scene, {0.0, 0.0}, scene.size);
  return scene;
}

Scene corridor() {
  Scene scene{{40.0, 2.5}, {}, {}};
  add_box(scene, {0.0, 0.0}, scene.size);
  for (double x = 2.0; x < 38.0; x += 4.0) add_box(scene, {x, 2.2}, {x + 3.0, 2.5});
  return scene;
}

double nearest_surface_m(const Scene& scene, const Pose2& T_world_sensor, Angle beam_width) {
  const Beam beam{unit(T_world_sensor.heading - beam_width / 2), unit(T_world_sensor.heading + beam_width / 2)};
  const Vec2 apex = T_world_sensor.position;
  double range = nothing;
  for (const Segment& wall : scene.walls) range = std::min(range, nearest(beam, wall.a - apex, wall.b - apex));
  for (const Circle& pillar : scene.pillars)
    range = std::min(range, nearest(beam, pillar.centre - apex, pillar.radius_m));
  return range;
}

}  // namespace echoarc::bench
