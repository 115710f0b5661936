// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/read_out.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace echoarc::consensus {
namespace {

/// Both hypotheses mixed: W = p_w Q_W + (1 - p_w) Q_P.
std::vector<double> mixture(const Posterior& posterior) {
  const double wall = double(posterior.wall_share);
  std::vector<double> mixed;
  for (std::size_t k = 0; k < posterior.wall.size(); ++k)
    mixed.push_back(wall * double(posterior.wall[k]) + (1.0 - wall) * double(posterior.point[k]));
  return mixed;
}

struct Window {
  int begin = 0;
  int end = 0;
  double mass = 0.0;
};

/// The window of +-`reach` bins with the largest mass, the first of equals.
Window best_window(const std::vector<double>& weights, int reach) {
  const int count = int(weights.size());
  std::vector<double> sums{0.0};
  for (const double w : weights) sums.push_back(sums.back() + w);
  Window best;
  for (int k = 0; k < count; ++k) {
    const int begin = std::max(0, k - reach);
    const int end = std::min(count, k + reach + 1);
    const double mass = sums[std::size_t(end)] - sums[std::size_t(begin)];
    if (mass > best.mass) best = {begin, end, mass};
  }
  return best;
}

/// The least distance from the point at `t` within which 90 % of the mass lies.
double radius_90_m(const Arc& arc, const BeamBins& bins, Angle step, Angle t, const std::vector<double>& weights) {
  std::vector<std::pair<double, double>> by_distance;
  const Vec2 p = touch_point(arc, unit(arc.axis() + t));
  for (int k = 0; k < bins.count(); ++k) {
    const Angle at = (k - bins.half) * step;
    const double chord_m = arc.is_circular() ? 2.0 * arc.range_m() * std::abs(sin(0.5 * (at - t)))
                                             : norm(touch_point(arc, unit(arc.axis() + at)) - p);
    by_distance.emplace_back(chord_m, weights[std::size_t(k)]);
  }
  std::ranges::sort(by_distance);
  double mass = 0.0;
  for (const auto& [distance_m, weight] : by_distance) {
    mass += weight;
    if (mass >= 0.9) return distance_m;
  }
  return by_distance.back().first;
}

}  // namespace

EchoEstimate read_out(const EchoArc& echo, const BeamBins& bins, const ConsensusOptions& options,
                      const Posterior& posterior) {
  const std::vector<double> weights = mixture(posterior);
  const double reach = options.tolerance_m / (echo.arc.range_m() * options.step.rad());
  const Window window = best_window(weights, int(std::min(reach, double(bins.count()))));
  double mean_bins = 0.0;
  for (int k = window.begin; k < window.end; ++k) mean_bins += weights[std::size_t(k)] * (k - bins.half);
  EchoEstimate estimate;
  estimate.t = mean_bins / std::max(window.mass, 1e-300) * options.step;
  estimate.p = std::min(1.0, window.mass);  // of floats that sum to 1 but for their last digits
  estimate.bound_m = std::max(options.bound_least_m, radius_90_m(echo.arc, bins, options.step, estimate.t, weights));
  estimate.wall_share = double(posterior.wall_share);
  estimate.evidence = double(posterior.evidence);
  return estimate;
}

bool is_believed(const EchoArc& echo, const ConsensusOptions& options, const EchoEstimate& estimate) {
  const double least_p = options.mode == ConsensusMode::strict ? options.strict_p : options.accept_p;
  return echo.arc.range_m() < options.map_range_m && estimate.p > least_p && estimate.evidence > options.evidence;
}

Element element_of(const ArcTable& arcs, std::size_t i, Angle t) {
  const Arc& arc = arcs[i].arc;
  const Vec2 normal = unit(arc.axis() + t);
  return {i, touch_point(arc, normal), normal};
}

std::vector<Vec2> positions_of(std::span<const Element> elements) {
  std::vector<Vec2> positions;
  positions.reserve(elements.size());
  for (const Element& element : elements) positions.push_back(element.position);
  return positions;
}

bool same_side(const Element& a, const Element& b) {
  constexpr double cos_60 = 0.5;
  return dot(a.normal, b.normal) > cos_60;
}

}  // namespace echoarc::consensus
