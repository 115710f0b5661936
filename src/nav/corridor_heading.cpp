// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/corridor_heading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace echoarc::nav {
namespace {

constexpr double quarter_deg = 90.0;

std::vector<Vec2> thinned(std::span<const Vec2> points, std::size_t most) {
  std::vector<Vec2> kept;
  const std::size_t stride = points.size() / most + 1;
  for (std::size_t n = 0; n < points.size(); n += stride)
    if (is_finite(points[n])) kept.push_back(points[n]);
  return kept;
}

/// Sum of the squared numbers of points in strips of width `line_m` along `direction`, each point shared by the two
/// strips around it so that it does not matter where they begin.
double sharpness(std::span<const Vec2> points, Angle direction, double line_m, std::vector<double>& across_lines) {
  const Vec2 normal = perpendicular(unit(direction));
  across_lines.clear();
  for (const Vec2 p : points) across_lines.push_back(dot(p, normal) / line_m);
  std::sort(across_lines.begin(), across_lines.end());
  double sum = 0.0;
  // Pairs closer than a line is wide, weighed by how close: the same sum without strips.
  for (std::size_t first = 0, n = 0; n < across_lines.size(); ++n) {
    while (across_lines[n] - across_lines[first] >= 1.0) ++first;
    for (std::size_t k = first; k < n; ++k) sum += 1.0 - (across_lines[n] - across_lines[k]);
  }
  return sum;
}

}  // namespace

Angle turn_between(Angle seen, Angle on_map) {
  return degrees(std::remainder((on_map - seen).deg(), quarter_deg));
}

std::optional<WallDirection> wall_direction(std::span<const Vec2> points, const CorridorHeadingOptions& options) {
  const std::vector<Vec2> kept = thinned(points, static_cast<std::size_t>(options.max_points));
  if (kept.size() < static_cast<std::size_t>(options.least_points)) return std::nullopt;
  const int steps = std::max(8, static_cast<int>(std::lround(quarter_deg / options.step.deg())));
  std::vector<double> scores;
  std::vector<double> scratch;
  for (int n = 0; n < steps; ++n) {
    const Angle direction = degrees(quarter_deg * n / steps);
    scores.push_back(sharpness(kept, direction, options.line_m, scratch) +
                     sharpness(kept, direction + degrees(quarter_deg), options.line_m, scratch));
  }
  const auto best = static_cast<int>(std::max_element(scores.begin(), scores.end()) - scores.begin());
  const auto score = [&](int n) { return scores[static_cast<std::size_t>((n + steps) % steps)]; };
  // The top of the parabola through the best direction and its neighbours.
  const double bend = score(best - 1) - 2.0 * score(best) + score(best + 1);
  const double shift = bend < 0.0 ? 0.5 * (score(best - 1) - score(best + 1)) / bend : 0.0;
  WallDirection found;
  const double deg = quarter_deg * (best + shift) / steps;
  found.direction = degrees(deg - quarter_deg * std::floor(deg / quarter_deg));
  std::vector<double> sorted = scores;
  std::nth_element(sorted.begin(), sorted.begin() + steps / 2, sorted.end());
  if (score(best) > 0.0) found.strength = 1.0 - sorted[static_cast<std::size_t>(steps / 2)] / score(best);
  if (found.strength < options.least_strength) return std::nullopt;
  return found;
}

std::optional<WallDirection> wall_direction(const DenseGrid<CellState>& map, const CorridorHeadingOptions& options) {
  std::vector<Vec2> points;
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i)
      if (map.at({i, j}) == CellState::occupied) points.push_back(map.geometry().centre({i, j}));
  return wall_direction(points, options);
}

std::optional<Angle> heading_correction(std::span<const Vec2> seen, const WallDirection& on_map,
                                        const CorridorHeadingOptions& options) {
  const std::optional<WallDirection> walls = wall_direction(seen, options);
  if (!walls) return std::nullopt;
  const Angle turn = turn_between(walls->direction, on_map.direction);
  if (abs(turn) > options.largest_correction) return std::nullopt;
  return turn;
}

}  // namespace echoarc::nav
