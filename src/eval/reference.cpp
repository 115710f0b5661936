// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoarc {
namespace {

Error refused(std::string message, const std::string& provenance, std::string remedy) {
  return {ErrorCode::bad_value, std::move(message), provenance, std::move(remedy)};
}

double segment_steps(Vec2 from, Vec2 to, double spacing_m) {
  return std::max(1.0, std::ceil(norm(to - from) / spacing_m));
}

/// Samples of all segments; how many is known to be bounded.
std::vector<Vec2> sample(std::span<const Polyline> surfaces, double spacing_m) {
  std::vector<Vec2> points;
  for (const Polyline& surface : surfaces) {
    if (surface.empty()) continue;
    points.push_back(surface.front());
    for (std::size_t k = 1; k < surface.size(); ++k) {
      const Vec2 from = surface[k - 1];
      const Vec2 to = surface[k];
      const auto steps = static_cast<std::int64_t>(segment_steps(from, to, spacing_m));
      for (std::int64_t step = 1; step < steps; ++step)
        points.push_back(from + (double(step) / double(steps)) * (to - from));
      points.push_back(to);
    }
  }
  return points;
}

/// Upper bound on the number of samples; infinite or NaN for coordinates that are not finite.
double sample_count(std::span<const Polyline> surfaces, double spacing_m) {
  double count = 0.0;
  for (const Polyline& surface : surfaces) {
    count += surface.empty() ? 0.0 : 1.0;
    for (std::size_t k = 1; k < surface.size(); ++k) count += segment_steps(surface[k - 1], surface[k], spacing_m);
  }
  return count;
}

}  // namespace

Result<Reference> polyline_reference(std::span<const Polyline> surfaces, std::string provenance, double spacing_m) {
  if (!(spacing_m > 0.0) || !std::isfinite(spacing_m))
    return refused("the spacing of reference points is " + std::to_string(spacing_m) + " m", provenance,
                   "give a spacing above 0 m");
  // Vertices first: a segment that is not finite has no number of samples.
  for (const Polyline& surface : surfaces)
    if (const Result<PointSet> vertices = PointSet::make(surface); !vertices) return vertices.error();
  const double count = sample_count(surfaces, spacing_m);
  if (count == 0.0) return refused("the reference has no vertex", provenance, "give at least one surface");
  if (count > double(max_reference_points))
    return refused("the reference would have more than " + std::to_string(max_reference_points) + " points", provenance,
                   "check its unit (metres), or sample it more coarsely");
  Result<PointSet> points = PointSet::make(sample(surfaces, spacing_m));
  if (!points) return points.error();
  return Reference{std::move(*points), spacing_m, std::move(provenance)};
}

Result<Reference> map_reference(const DenseGrid<CellState>& grid, std::string provenance) {
  Result<PointSet> points = PointSet::of_occupied(grid);
  if (!points) return points.error();
  if (points->empty())
    return refused("the reference map has no occupied cell", provenance,
                   "check occupied_thresh and negate of its map.yaml");
  return Reference{std::move(*points), grid.geometry().cell_m, std::move(provenance)};
}

}  // namespace echoarc
