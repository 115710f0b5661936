// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/calibration.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "echoarc/core/arc.hpp"
#include "echoarc/eval/point_set.hpp"

namespace echoarc {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 9> bound_edges_m{0.0, 0.05, 0.075, 0.10, 0.15, 0.20, 0.30, 0.50, 1e9};

bool within(double distance_m, double limit_m) {
  return distance_m <= limit_m + eps_length_m;  // false for NaN
}

/// Claims and hits of one bin as they come in.
struct Tally {
  std::uint64_t points = 0;
  std::uint64_t hits = 0;
  double claimed = 0.0;

  void add(double claim, bool hit) {
    ++points;
    hits += hit ? 1 : 0;
    claimed += claim;
  }
  [[nodiscard]] double mean_claim() const { return points == 0 ? no_value : claimed / double(points); }
};

std::vector<CalibrationBin> bins_of(std::span<const Tally> tallies, std::span<const double> edges) {
  std::vector<CalibrationBin> bins;
  for (std::size_t b = 0; b < tallies.size(); ++b)
    bins.push_back(
        {edges[b], edges[b + 1], tallies[b].mean_claim(), observed_share(tallies[b].hits, tallies[b].points)});
  return bins;
}

double calibration_error(std::span<const Tally> tallies) {
  double gap = 0.0;
  std::uint64_t points = 0;
  for (const Tally& tally : tallies) {
    gap += std::abs(tally.claimed - double(tally.hits));
    points += tally.points;
  }
  return points == 0 ? no_value : gap / double(points);
}

}  // namespace

Result<std::vector<ClaimedPoint>> claimed_points(const PointMap& map, const NearestPoints& reference,
                                                 double thin_cell_m) {
  if (map.beliefs().empty()) return std::vector<ClaimedPoint>{};
  const Result<PointSet> positions = PointSet::of_points(map);
  if (!positions) return positions.error();
  const PointSet chosen = thin_cell_m > 0.0 ? positions->one_per_cell(thin_cell_m) : *positions;
  std::vector<ClaimedPoint> claims;
  claims.reserve(chosen.size());
  std::size_t k = 0;
  for (const Vec2 p : chosen.points()) {
    // The first of its cell is the first at its place.
    while (map.points()[k].position != p) ++k;
    const MapPoint& point = map.points()[k];
    claims.push_back({point.label, map.beliefs()[k].probability, point.bound_m, reference.distance_m(point.position)});
  }
  return claims;
}

ObservedShare observed_share(std::uint64_t hits, std::uint64_t of) {
  assert(hits <= of);
  if (of == 0) return {hits, of, no_value, no_value, no_value};
  constexpr double z2 = 1.96 * 1.96;
  const double n = double(of);
  const double share = double(hits) / n;
  const double middle = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = std::sqrt(z2 * (share * (1.0 - share) / n + z2 / (4.0 * n * n))) / (1.0 + z2 / n);
  return {hits, of, share, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

Calibration calibrate(std::span<const ClaimedPoint> points, int p_bins) {
  assert(p_bins > 0);
  std::vector<double> p_edges;
  for (int b = 0; b <= p_bins; ++b) p_edges.push_back(double(b) / p_bins);
  std::vector<Tally> by_p(std::size_t(p_bins), Tally{});
  std::array<Tally, bound_edges_m.size() - 1> by_bound;
  Tally right;
  Tally held;
  for (const ClaimedPoint& point : points) {
    const double p = std::isnan(point.probability) ? 0.0 : std::clamp(point.probability, 0.0, 1.0);
    const double bound_m = std::isnan(point.bound_m) ? 0.0 : std::max(point.bound_m, 0.0);
    const bool is_right = within(point.distance_m, right_within_m);
    const bool holds = within(point.distance_m, point.bound_m);
    right.add(p, is_right);
    held.add(bound_m, holds);
    by_p[std::min(std::size_t(p * p_bins), by_p.size() - 1)].add(p, is_right);
    // A bound belongs to the bin that it ends: the least bound of a method is often exactly 5 cm.
    std::size_t b = 0;
    while (b + 1 < by_bound.size() && !within(bound_m, bound_edges_m[b + 1])) ++b;
    by_bound[b].add(bound_m, holds);
  }
  Calibration calibration;
  calibration.points = points.size();
  calibration.claimed = right.mean_claim();
  calibration.right = observed_share(right.hits, right.points);
  calibration.bound_held = observed_share(held.hits, held.points);
  calibration.by_p = bins_of(by_p, p_edges);
  calibration.bound = bins_of(by_bound, bound_edges_m);
  calibration.error = calibration_error(by_p);
  return calibration;
}

}  // namespace echoarc
