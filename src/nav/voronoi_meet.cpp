// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "echoarc/nav/voronoi_tracer.hpp"

namespace echoarc::nav {
namespace {

/// The obstacle whose closest point is nearest to where it was; none within `radius_m`.
std::optional<NearObstacle> same_obstacle(std::span<const NearObstacle> now, Vec2 was, double radius_m) {
  std::optional<NearObstacle> best;
  for (const NearObstacle& o : now) {
    const double apart_m = norm(o.closest - was);
    if (apart_m <= radius_m && (!best || apart_m < norm(best->closest - was))) best = o;
  }
  return best;
}

Vec2 gradient(Vec2 place, const NearObstacle& o) {
  return (place - o.closest) / o.distance_m;
}

}  // namespace

std::optional<Vec2> refine_meet(std::span<const Vec2> points, Vec2 place, const std::array<NearObstacle, 3>& obstacles,
                                const ObstacleOptions& options) {
  constexpr double furthest_m = 1.0;
  constexpr double step_limit_m = 0.15;
  constexpr double jump_m = 0.8;  // of the closest place on a wall of sparse points
  constexpr double good_m = 0.002;
  constexpr double enough_m = 0.04;  // noise lets the last centimetres jitter
  std::array<NearObstacle, 3> at = obstacles;
  Vec2 x = place;
  Vec2 best = place;
  double best_m = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 16; ++iteration) {
    const double f = at[0].distance_m - at[1].distance_m;
    const double g = at[0].distance_m - at[2].distance_m;
    const double left_m = std::max(std::abs(f), std::abs(g));
    if (left_m < best_m) best = x, best_m = left_m;
    if (best_m < good_m) break;
    const Vec2 df = gradient(x, at[0]) - gradient(x, at[1]);
    const Vec2 dg = gradient(x, at[0]) - gradient(x, at[2]);
    const double determinant = cross(df, dg);
    if (std::abs(determinant) < 0.05) break;  // the three stand in a row: no single place is meant
    Vec2 step = Vec2{-(f * dg.y - g * df.y), -(df.x * g - dg.x * f)} / determinant;
    if (norm(step) > step_limit_m) step = step * (step_limit_m / norm(step));
    x = x + step;
    if (norm(x - place) > furthest_m) break;
    const std::vector<NearObstacle> now = obstacle_distances(points, x, options);
    bool all = true;
    for (NearObstacle& o : at) {
      const std::optional<NearObstacle> same = same_obstacle(now, o.closest, jump_m);
      all = all && same;
      o = same.value_or(o);
    }
    if (!all) break;
  }
  return best_m < enough_m ? std::optional(best) : std::nullopt;
}

NodeSight node_sight(std::span<const Vec2> points, Vec2 place, double gap_m, const TracerOptions& options,
                     const ObstacleOptions& obstacle_options) {
  NodeSight sight{place, VoronoiNodeType::meet, 0.0, {}};
  std::vector<NearObstacle> around = obstacle_distances(points, place, obstacle_options);
  if (around.empty()) return sight;
  const double nearest_m = around.front().distance_m;
  std::erase_if(around, [&](const NearObstacle& o) { return o.distance_m > nearest_m + options.node_band_m; });
  std::stable_sort(around.begin(), around.end(),
                   [](const NearObstacle& a, const NearObstacle& b) { return a.bearing < b.bearing; });
  for (const NearObstacle& o : around) {
    sight.distance_m += o.distance_m / double(around.size());
    sight.closest.push_back(o.closest);
  }
  for (std::size_t i = 0; around.size() > 1 && i < around.size(); ++i) {
    const NearObstacle& a = around[i];
    const NearObstacle& b = around[(i + 1) % around.size()];
    double span = (b.bearing - a.bearing).rad();
    if (span <= 0.0) span += 2.0 * std::numbers::pi;
    // Beyond half a turn the way leads off between them, not through: it widens.
    if (span < std::numbers::pi && norm(a.closest - b.closest) < gap_m) continue;
    sight.ways.push_back(wrap(a.bearing + radians(0.5 * span)));
  }
  return sight;
}

/// Three ways out, and obstacles all round: beyond half a turn without any, one has not been heard yet.
bool VoronoiTracer::is_node(const NodeSight& sight) {
  const std::size_t n = sight.closest.size();
  if (sight.ways.size() < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {  // they come in order of bearing
    const Angle here = bearing(sight.closest[i] - sight.place);
    const Angle gap = wrap(bearing(sight.closest[(i + 1) % n] - sight.place) - here);
    if (gap < Angle{} && gap > degrees(-170.0)) return false;
  }
  return true;
}

std::optional<NodeSight> VoronoiTracer::meet(Vec2 place, std::span<const Vec2> points) const {
  constexpr std::size_t most = 4;  // of the nearest obstacles, any three may be those that meet
  std::vector<NearObstacle> near = obstacle_distances(points, place, obstacle_options_);
  near.resize(std::min(near.size(), most));
  std::optional<NodeSight> best;
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t k = i + 1; k < near.size(); ++k)
      for (std::size_t m = k + 1; m < near.size(); ++m) {
        const auto centre = refine_meet(points, place, {near[i], near[k], near[m]}, obstacle_options_);
        if (!centre || (best && norm(best->place - place) <= norm(*centre - place))) continue;
        if (NodeSight sight = node_at(*centre, points); is_node(sight)) best = std::move(sight);
      }
  return best ? best : node_around(place, points);
}

/// The nearest place round about with three ways out: for a meet point that was noticed late, or whose obstacles
/// jitter.
std::optional<NodeSight> VoronoiTracer::node_around(Vec2 place, std::span<const Vec2> points) const {
  constexpr double ring_step_m = 0.15;
  constexpr int rings = 4;
  for (int ring = 0; ring <= rings; ++ring) {
    const int places = ring == 0 ? 1 : 6 * ring;
    std::optional<NodeSight> best;
    for (int k = 0; k < places; ++k) {
      const Vec2 at = place + (ring_step_m * ring) * unit(360.0 / places * degrees(double(k)));
      NodeSight sight = node_at(at, points);
      if (is_node(sight) && (!best || sight.distance_m > best->distance_m)) best = std::move(sight);
    }
    if (best) return best;
  }
  return {};
}

}  // namespace echoarc::nav
