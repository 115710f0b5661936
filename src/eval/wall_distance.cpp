// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/wall_distance.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/eval/statistics.hpp"

namespace echoarc {
namespace {

std::uint64_t count_within(std::span<const double> distances_m, double limit_m) {
  return std::uint64_t(
      std::count_if(distances_m.begin(), distances_m.end(), [&](double d) { return d <= limit_m + eps_length_m; }));
}

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : double(part) / double(whole);
}

/// `from_path_m` holds the distance of every reference point from the path.
WallDistance measure(const PointSet& map, const Reference& reference, std::span<const double> from_path_m,
                     const WallDistanceOptions& options) {
  const std::vector<double> to_reference_m = nearest_distances_m(map, reference.points);
  WallDistance score;
  score.points = map.size();
  for (std::size_t k = 0; k < accuracy_distances_m.size(); ++k)
    score.accuracy[k] = share(count_within(to_reference_m, accuracy_distances_m[k]), score.points);
  score.mean_m = mean(to_reference_m);
  score.median_m = median(to_reference_m);
  score.p95_m = percentile(to_reference_m, 0.95);

  const NearestPoints nearest_in_map(map);
  for (std::size_t k = 0; k < from_path_m.size(); ++k) {
    if (from_path_m[k] > options.path_distance_m + eps_length_m) continue;
    ++score.reference_points;
    const double to_map_m = nearest_in_map.distance_m(reference.points.points()[k]);
    if (to_map_m <= options.coverage_distance_m + eps_length_m) ++score.covered_points;
  }
  score.coverage = share(score.covered_points, score.reference_points);
  return score;
}

}  // namespace

TwoWayWallDistance wall_distance(const PointSet& map, const Reference& reference, const PointSet& path,
                                 const WallDistanceOptions& options) {
  assert(validate(options));
  const std::vector<double> from_path_m = nearest_distances_m(reference.points, path);
  return {measure(map, reference, from_path_m, options),
          measure(map.one_per_cell(options.thin_cell_m), reference, from_path_m, options)};
}

}  // namespace echoarc
