// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/surface_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "mapping/consensus/point_finder.hpp"

namespace echoarc::consensus {
namespace {

/// What one ray says of places.
class Testimony {
 public:
  Testimony(const Arc& arc, const Element& ray, double p, const ConsensusOptions& options)
      : arc_(arc),
        normal_(ray.normal),
        spread_m_(options.spread_m),
        free_to_m_(arc.range_m() - std::max(options.free_margin_m, band_sigmas * options.band_sigma_m)),
        over_two_variance_(0.5 / (options.band_sigma_m * options.band_sigma_m)),
        band_m_(band_sigmas * options.band_sigma_m),
        amplitude_((options.occupied_peak - 0.5) * p),
        free_(log_odds(0.5 - (0.5 - options.free_floor) * p)) {}

  /// The log-odds that it adds.
  [[nodiscard]] double of(Vec2 place) const {
    const Vec2 way = arc_.is_circular() ? place - arc_.centre() : arc_.half_path_m(place) * normal_through(arc_, place);
    // Most places are too far beside it: that is seen without a root.
    const double aside = cross(normal_, way) * arc_.range_m();
    const double squared_m2 = squared_norm(way);
    if (aside * aside > spread_m_ * spread_m_ * squared_m2 || dot(normal_, way) <= 0.0) return 0.0;
    const double distance_m = std::sqrt(squared_m2);
    if (distance_m < free_to_m_) return free_;
    const double e_m = distance_m - arc_.range_m();
    return std::abs(e_m) <= band_m_ ? log_odds(0.5 + amplitude_ * std::exp(-e_m * e_m * over_two_variance_)) : 0.0;
  }

 private:
  const Arc& arc_;
  Vec2 normal_;
  double spread_m_;
  double free_to_m_;
  double over_two_variance_;
  double band_m_;
  double amplitude_;
  double free_;
};

}  // namespace

std::vector<double> surface_evidence(const ArcTable& arcs, const ConsensusOptions& options,
                                     std::span<const EchoEstimate> estimates, std::span<const Element> rays,
                                     std::span<const Vec2> places) {
  std::vector<double> sums(places.size(), 0.0);
  const PointFinder finder(places);
  std::vector<std::uint32_t> met;
  for (const Element& ray : rays) {
    const Arc& arc = arcs[ray.echo].arc;
    const Testimony testimony(arc, ray, estimates[ray.echo].p, options);
    const double reach_m = std::max(options.spread_m, band_sigmas * options.band_sigma_m);
    if (arc.is_circular()) {
      finder.along(arc.centre(), ray.position, reach_m, [&](std::size_t k) { sums[k] += testimony.of(places[k]); });
      continue;
    }
    met.clear();  // a place beside both legs is asked for once
    for (const Vec2 origin : {arc.transmitter(), arc.receiver()})
      finder.along(origin, ray.position, reach_m, [&](std::size_t k) { met.push_back(std::uint32_t(k)); });
    std::ranges::sort(met);
    met.erase(std::ranges::unique(met).begin(), met.end());
    for (const std::uint32_t k : met) sums[k] += testimony.of(places[k]);
  }
  return sums;
}

double least_evidence(const ConsensusOptions& options) {
  return log_odds(options.occupied_threshold);
}

}  // namespace echoarc::consensus
