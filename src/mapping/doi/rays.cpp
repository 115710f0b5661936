// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mapping/doi/path_walk.hpp"
#include "mapping/doi/providers.hpp"

namespace echoarc::doi {

void sight_lines(RayLines& rays, std::span<const DoiHistory::Sight> sights, const LineVisitor& visit) {
  for (std::size_t k = 0; k < sights.size(); ++k)
    visit(k, rays.along(sights[k].origin, sights[k].direction, sights[k].range_max_m));
}

std::vector<WallSide> named_sides(std::span<const DoiHistory::Stop> stops) {
  std::vector<WallSide> sides;
  sides.reserve(stops.size());
  for (const DoiHistory::Stop& stop : stops) sides.push_back(stop.wall);
  return sides;
}

void path_lines(RayLines& rays, const DoiHistory& history, std::span<const WallSide> sides, bool both_if_unknown,
                double spacing_m, double tangent_window_m, const LineVisitor& visit) {
  if (history.path().empty()) return;
  PathWalk here(history.path());
  PathWalk behind(history.path());
  PathWalk ahead(history.path());
  const auto samples = static_cast<std::uint64_t>(here.length_m() / spacing_m) + 1;
  for (std::uint64_t k = 0; k < samples; ++k) {
    const double s = double(k) * spacing_m;
    const Vec2 chord = ahead.at(s + tangent_window_m) - behind.at(s - tangent_window_m);
    if (norm(chord) < eps_length_m) continue;  // the robot came back to where it was: no direction
    const Vec2 position = here.at(s);
    const DoiHistory::Waypoint& passed = here.passed();
    Vec2 left = perpendicular(chord / norm(chord));
    if (dot(left, perpendicular(unit(passed.heading))) < 0.0) left = -left;  // driving backwards
    const WallSide side = sides[passed.stop];
    const bool both = side == WallSide::unknown && both_if_unknown;
    if (side == WallSide::left || both) visit(2 * k, rays.along(position, left, history.range_max_m()));
    if (side == WallSide::right || both) visit(2 * k + 1, rays.along(position, -left, history.range_max_m()));
  }
}

void polar_lines(RayLines& rays, Vec2 vantage_point, Angle step, double length_m, const LineVisitor& visit) {
  const Angle turn = radians(2.0 * std::numbers::pi);
  const auto count = static_cast<std::uint64_t>(std::ceil(turn / step - 1e-9));
  for (std::uint64_t k = 0; k < count; ++k)
    visit(k, rays.along(vantage_point, unit(turn * (double(k) / double(count))), length_m));
}

std::vector<Vec2> vantage_points(std::span<const DoiHistory::Waypoint> path, double spacing_m) {
  std::vector<Vec2> points;
  if (path.empty()) return points;
  PathWalk walk(path);
  const auto count = static_cast<std::uint64_t>(walk.length_m() / spacing_m) + 1;
  for (std::uint64_t k = 0; k < count; ++k) points.push_back(walk.at(double(k) * spacing_m));
  return points;
}

}  // namespace echoarc::doi
