// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/heard_beams.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {
namespace {

constexpr double pilot_reach = 1.875;  // bearings searched, in sigma: all but 6 % of a bell
constexpr double clear_p = 0.9;        // of the echoes that count
constexpr std::size_t pilot_arcs = 128;
constexpr std::size_t least_clear = 20;  // fewer say nothing
constexpr double widest_factor = 4.0;

/// Root mean square of the bearings of clear echoes, in beam widths, after one sweep with such a beam; 0 where too few
/// are clear.
double scatter_beams(ArcTable& arcs, const ConsensusOptions& options, double sigma_beams) {
  arcs.assume({sigma_beams, pilot_reach * sigma_beams});
  const WeightRows rows = prior_rows(arcs, options);
  PosteriorEstimator estimator(arcs, options);
  Neighbours neighbours;
  double sum = 0.0;
  std::size_t clear = 0;
  const std::size_t stride = std::max<std::size_t>(1, arcs.size() / pilot_arcs);
  for (std::size_t i = 0; i < arcs.size(); i += stride) {
    if (arcs[i].arc.range_m() >= options.map_range_m) continue;
    find_neighbours(arcs, options, i, arcs.size(), neighbours);
    const EchoEstimate estimate =
        read_out(arcs[i], arcs.bins(i), options, estimator.estimate(i, neighbours, {&rows, 0, true}));
    if (estimate.p <= clear_p) continue;
    const double off_axis_beams = estimate.t / arcs[i].beam_width;
    sum += off_axis_beams * off_axis_beams;
    ++clear;
  }
  return clear < least_clear ? 0.0 : std::sqrt(sum / double(clear));
}

}  // namespace

BeamPrior heard_beams(const ArcTable& arcs, const ConsensusOptions& options) {
  ArcTable pilot = arcs.first(std::min(arcs.size(), std::size_t(options.sweeps) * std::size_t(options.history)));
  double factor = 1.0;
  double scatter = scatter_beams(pilot, options, options.sigma_beams);
  while (scatter > 0.0 && factor < widest_factor) {
    const double wider = scatter_beams(pilot, options, 2.0 * factor * options.sigma_beams);
    if (wider <= options.wider_growth * scatter) break;
    scatter = wider;
    factor *= 2.0;
  }
  return {factor * options.sigma_beams, factor * options.search_beams};
}

}  // namespace echoarc::consensus
