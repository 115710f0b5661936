// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>

#include "echoarc/mapping/consensus_explanation.hpp"
#include "mapping/consensus/ellipse_pair.hpp"
#include "mapping/consensus/heard_beams.hpp"
#include "mapping/consensus/intake.hpp"
#include "mapping/consensus/read_out.hpp"

namespace echoarc {
namespace consensus {
namespace {

/// Posteriors of arc `i` alone after `sweeps` of them.
SweepBelief belief_after(int sweeps, const ArcTable& arcs, ConsensusOptions options, std::size_t i, Executor& executor,
                         EchoEstimate& estimate) {
  options.sweeps = sweeps;
  SweepBelief belief;
  find_posteriors(arcs, options, i, i + 1, executor, [&](std::size_t, const Posterior& posterior) {
    belief.wall.assign(posterior.wall.begin(), posterior.wall.end());
    belief.point.assign(posterior.point.begin(), posterior.point.end());
    belief.wall_share = double(posterior.wall_share);
    belief.evidence = double(posterior.evidence);
    estimate = read_out(arcs[i], arcs.bins(i), options, posterior);
  });
  return belief;
}

/// Where the arcs from `from` on are weighed in the last sweep: by the beam alone when there is but one.
WeightRows last_rows(const ArcTable& arcs, ConsensusOptions options, std::size_t from, std::size_t to,
                     Executor& executor) {
  if (options.sweeps == 1) return prior_rows(arcs, options);
  --options.sweeps;
  int widest = 0;
  for (const BeamBins& bins : arcs.all_bins()) widest = std::max(widest, bins.padded());
  WeightRows rows(to - from, widest);
  find_posteriors(arcs, options, from, to, executor, [&](std::size_t j, const Posterior& posterior) {
    rows.fill(j - from, posterior, arcs.bins(j).prior_top, PosteriorEstimator::support_scale(options));
  });
  return rows;
}

/// What every neighbour says of bin `k` of arc `i` in the last sweep.
std::vector<NeighbourVoice> voices_of(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i,
                                      const Neighbours& neighbours, std::size_t k, Executor& executor) {
  if (neighbours.arcs.empty()) return {};
  const std::size_t from = neighbours.arcs.front();
  const WeightRows rows = last_rows(arcs, options, from, neighbours.arcs.back() + 1, executor);
  const SweepWeights weights{&rows, from, options.sweeps == 1};
  std::vector<NeighbourVoice> voices;
  const auto bins = std::size_t(arcs.bins(i).padded());
  for (const std::size_t j : neighbours.arcs) {
    std::vector<float> sums(4 * bins, 0.0F);
    const std::size_t row = weights.row(arcs, j);
    add_any_pair(arcs, options, i, j, rows.wall(row), rows.point(row),
                 {sums.data(), sums.data() + bins, sums.data() + 2 * bins, sums.data() + 3 * bins});
    voices.push_back({arcs[j].source.ping, double(sums[k]), double(sums[bins + k]), double(sums[2 * bins + k]),
                      double(sums[3 * bins + k])});
  }
  return voices;
}

EchoExplanation explain(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i, Executor& executor) {
  const BeamBins& bins = arcs.bins(i);
  EchoExplanation explanation;
  explanation.arc = arcs[i].arc;
  explanation.prior.assign(bins.prior.begin(), bins.prior.begin() + bins.count());
  for (int k = -bins.half; k <= bins.half; ++k) explanation.bearings.push_back(k * options.step);
  EchoEstimate estimate;
  for (int sweep = 1; sweep <= options.sweeps; ++sweep)
    explanation.sweeps.push_back(belief_after(sweep, arcs, options, i, executor, estimate));
  explanation.t = estimate.t;
  explanation.position = element_of(arcs, i, estimate.t).position;
  explanation.p = estimate.p;
  explanation.bound_m = estimate.bound_m;
  Neighbours neighbours;
  find_neighbours(arcs, options, i, arcs.size(), neighbours);
  explanation.neighbour_weight = neighbours.weight;
  const auto nearest = std::size_t(std::lround(estimate.t / options.step) + bins.half);
  explanation.voices = voices_of(arcs, options, i, neighbours, nearest, executor);
  return explanation;
}

Error unexplained(PingId ping, std::string why, std::string remedy) {
  return {ErrorCode::bad_value, std::move(why), "ping " + std::to_string(ping), std::move(remedy)};
}

}  // namespace
}  // namespace consensus

Result<EchoExplanation> explain_echo(std::span<const Reading> readings, const ConsensusOptions& options, PingId ping,
                                     Executor& executor) {
  const auto wanted = std::ranges::find(readings, ping, &Reading::ping);
  if (wanted == readings.end())
    return consensus::unexplained(ping, "there is no such ping among those that can be mapped",
                                  "pings are counted from 0; `points.csv` names those behind a point");
  consensus::ArcTable arcs(options);
  std::size_t own = 0;
  for (const Reading& reading : readings) {
    InsertCounters ignored;
    const auto echo = consensus::echo_of(reading, options, ignored);
    const bool is_wanted = &reading == &*wanted;
    if (is_wanted && !echo)
      return consensus::unexplained(ping, "it has no echo that the consensus takes",
                                    "choose a ping with an echo nearer than range_max_m");
    if (!echo) continue;
    if (arcs.repeats(echo->arc, reading.tx, reading.rx)) {
      if (!is_wanted) continue;
      return consensus::unexplained(ping, "it says the same as the one before it of its sensor, and was passed over",
                                    "choose that one; see thin_move_m, thin_turn_deg, thin_range_m");
    }
    if (is_wanted) own = arcs.size();
    arcs.add(*echo);
  }
  arcs.assume(heard_beams(arcs, options));
  return consensus::explain(arcs, options, own, executor);
}

}  // namespace echoarc
