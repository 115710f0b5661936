// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "sim/world_model.hpp"

namespace echoarc::sim {

namespace {

using Fault = std::optional<Error>;

constexpr double shortest_wall_m = 1e-6;
constexpr double longest_step_m = 0.002 * (1.0 + 1e-9);

Error fault(std::string message, std::uint64_t line, std::string remedy) {
  return {ErrorCode::bad_value, std::move(message), line == 0 ? "" : "line " + std::to_string(line), std::move(remedy)};
}

bool far_or_not_finite(Vec2 p) {
  return !(std::abs(p.x) <= World::max_coordinate_m && std::abs(p.y) <= World::max_coordinate_m);
}

Fault check_point(Vec2 p, std::string_view what, std::uint64_t line) {
  if (!far_or_not_finite(p)) return {};
  return fault(std::string(what) + " has coordinates that are not finite or beyond 100000 m", line,
               "give coordinates in metres, near the origin");
}

Fault check_known(MaterialId id, const WorldDescription& d, std::string_view what, std::uint64_t line) {
  if (id < d.materials.size()) return {};
  return fault(
      std::string(what) + " names material " + std::to_string(id) + " of " + std::to_string(d.materials.size()), line,
      "declare the material or name another");
}

Fault check_material(const Material& m) {
  const std::string what = "material \"" + m.name + "\"";
  if (!(m.loss_db >= 0.0 && m.loss_db <= 200.0))
    return fault(what + " has a loss that is not within 0 to 200 dB", 0, "set loss_db to 0.5 for a plain wall");
  if (!m.rough_db) return {};
  if (!(*m.rough_db < 0.0 && *m.rough_db >= -200.0))
    return fault(what + " has bumps that are not weaker than a mirror", 0, "set rough_db below 0, for instance -18");
  if (!(m.rough_pitch_m >= 0.001 && m.rough_pitch_m <= 1000.0))
    return fault(what + " has bumps closer than 1 mm or further apart than 1 km", 0, "set rough_pitch_m to 0.05");
  return {};
}

Fault check_wall(const Wall& wall, const WorldDescription& d) {
  for (const Vec2 end : {wall.a, wall.b})
    if (Fault f = check_point(end, "a wall", wall.line)) return f;
  if (!(norm(wall.b - wall.a) >= shortest_wall_m))
    return fault("a wall has no length", wall.line, "move its ends at least 1e-6 m apart, or leave it out");
  return check_known(wall.material, d, "a wall", wall.line);
}

Fault check_radius(double radius_m, std::uint64_t line) {
  if (radius_m > 0.0 && radius_m <= World::max_coordinate_m) return {};
  return fault("a disc has a radius that is not within 0 to 100000 m", line, "give a positive radius in metres");
}

Fault check_disc(const Disc& disc, const WorldDescription& d) {
  if (Fault f = check_point(disc.centre, "a disc", disc.line)) return f;
  if (Fault f = check_radius(disc.radius_m, disc.line)) return f;
  return check_known(disc.material, d, "a disc", disc.line);
}

Fault check_moving(const MovingDisc& disc, const WorldDescription& d) {
  if (Fault f = check_radius(disc.radius_m, disc.line)) return f;
  if (disc.path.empty()) return fault("a moving disc has no path", disc.line, "give it at least one station");
  for (std::size_t i = 0; i < disc.path.size(); ++i) {
    if (Fault f = check_point(disc.path[i].centre, "a moving disc", disc.line)) return f;
    const bool grows = i == 0 || disc.path[i].time_s > disc.path[i - 1].time_s;
    if (!std::isfinite(disc.path[i].time_s) || !grows)
      return fault("the times of a moving disc do not grow", disc.line,
                   "order its stations by time, each later than the last");
  }
  return check_known(disc.material, d, "a moving disc", disc.line);
}

bool facets_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

/// Facets are at most 2 mm long: on a grid of 2 mm two that cross have their first points within two cells.
bool crosses_itself(const std::vector<Vec2>& points) {
  constexpr double cell_m = 0.002;
  const auto key = [](std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ static_cast<std::uint32_t>(y);
  };
  std::unordered_map<std::uint64_t, std::uint32_t> head;
  std::vector<std::uint32_t> next(points.size(), ~0U);
  for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
    const auto x = static_cast<std::int64_t>(std::floor(points[i].x / cell_m));
    const auto y = static_cast<std::int64_t>(std::floor(points[i].y / cell_m));
    for (std::int64_t dx = -2; dx <= 2; ++dx)
      for (std::int64_t dy = -2; dy <= 2; ++dy) {
        const auto found = head.find(key(x + dx, y + dy));
        for (std::uint32_t j = found == head.end() ? ~0U : found->second; j != ~0U; j = next[j])
          if (j + 1 < i && facets_cross(points[i], points[i + 1], points[j], points[j + 1])) return true;
      }
    const auto [place, is_new] = head.try_emplace(key(x, y), i);
    if (!is_new) next[i] = std::exchange(place->second, i);
  }
  return false;
}

Fault check_curve(const SmoothCurve& curve, const WorldDescription& d) {
  if (curve.points.size() < 3) return fault("a curve has fewer than 3 points", curve.line, "sample it every 2 mm");
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (Fault f = check_point(curve.points[i], "a curve", curve.line)) return f;
    if (i == 0) continue;
    const double step_m = norm(curve.points[i] - curve.points[i - 1]);
    if (!(step_m >= shortest_wall_m && step_m <= longest_step_m))
      return fault("point " + std::to_string(i + 1) + " of a curve is not within 1e-6 m to 2 mm of the one before",
                   curve.line, "sample the curve every 2 mm");
  }
  if (crosses_itself(curve.points)) return fault("a curve crosses itself", curve.line, "split it where it crosses");
  return check_known(curve.material, d, "a curve", curve.line);
}

template <class Item, class Check>
Fault first_fault(const std::vector<Item>& items, const Check& check) {
  for (const Item& item : items)
    if (Fault f = check(item)) return f;
  return {};
}

Fault check_sizes(const WorldDescription& d) {
  if (d.materials.empty()) return fault("a world without materials", 0, "declare at least one material");
  if (d.walls.size() > World::max_walls || d.discs.size() > World::max_walls)
    return Error{ErrorCode::too_large, "more than 1000000 walls or discs", "", "split the scene"};
  std::size_t points = 0;
  for (const SmoothCurve& curve : d.curves) points += curve.points.size();
  if (points > World::max_curve_points)
    return Error{ErrorCode::too_large, "curves of more than 10000000 points", "", "split the scene"};
  return {};
}

}  // namespace

std::optional<Error> check_description(const WorldDescription& d) {
  if (Fault f = check_sizes(d)) return f;
  if (Fault f = first_fault(d.materials, check_material)) return f;
  if (Fault f = first_fault(d.walls, [&](const Wall& w) { return check_wall(w, d); })) return f;
  if (Fault f = first_fault(d.discs, [&](const Disc& disc) { return check_disc(disc, d); })) return f;
  if (Fault f = first_fault(d.curves, [&](const SmoothCurve& c) { return check_curve(c, d); })) return f;
  return first_fault(d.moving, [&](const MovingDisc& m) { return check_moving(m, d); });
}

}  // namespace echoarc::sim
