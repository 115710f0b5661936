// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/on_line_posteriors.hpp"

#include <algorithm>
#include <utility>

namespace echoarc::consensus {

void OnLinePosteriors::start(const ArcTable& arcs, SweptRows swept) {
  swept_ = std::move(swept);
  if (options_.sweeps == 1) swept_ = {WeightRows(0, widest_bins(arcs)), arcs.size()};  // arcs tell what their beams do
}

/// A row for every arc from `swept_.first` on, each with room for the widest beam.
void OnLinePosteriors::make_room(const ArcTable& arcs) {
  const int widest = widest_bins(arcs);
  if (swept_.rows.bins() < widest) {
    WeightRows wider(swept_.rows.size(), widest);
    for (std::size_t k = 0; k < wider.size(); ++k) wider.copy(k, swept_.rows, k);
    swept_.rows = std::move(wider);
  }
  swept_.rows.resize(arcs.size() - swept_.first);
}

void OnLinePosteriors::put(const ArcTable& arcs, std::size_t i, const Posterior& posterior, WeightRows& rows,
                           std::size_t k) const {
  rows.fill(k, posterior, arcs.bins(i).prior_top, PosteriorEstimator::support_scale(options_));
}

void OnLinePosteriors::weigh_new(const ArcTable& arcs, std::size_t from, const FoundPosterior& found) {
  make_room(arcs);
  const bool by_beam = options_.sweeps == 1;
  const WeightRows priors = prior_rows(arcs, options_);
  PosteriorEstimator estimator(arcs, options_);
  Neighbours neighbours;
  for (std::size_t i = from; i < arcs.size(); ++i) {
    find_neighbours(arcs, options_, i, i, neighbours);
    const SweepWeights weights = by_beam ? SweepWeights{&priors, 0, true} : SweepWeights{&swept_.rows, swept_.first};
    const Posterior posterior = estimator.estimate(i, neighbours, weights);
    if (!by_beam) put(arcs, i, posterior, swept_.rows, i - swept_.first);
    found(i, posterior);
  }
}

void OnLinePosteriors::weigh_again(const ArcTable& arcs, std::size_t first, std::size_t end, Executor& executor,
                                   const FoundPosterior& found) {
  make_room(arcs);
  const std::vector<Neighbours> neighbours = neighbours_of(arcs, options_, first, end, executor);
  const WeightRows priors = prior_rows(arcs, options_);
  SweepWeights weights{&priors, 0, true};
  for (int k = 1; k < options_.sweeps; ++k) {
    WeightRows next(end - first, widest_bins(arcs));
    sweep(arcs, options_, first, neighbours, weights, executor,
          [&](std::size_t i, const Posterior& posterior) { put(arcs, i, posterior, next, i - first); });
    for (std::size_t i = first; i < end; ++i) swept_.rows.copy(i - swept_.first, next, i - first);
    weights = {&swept_.rows, swept_.first, false};
  }
  sweep(arcs, options_, first, neighbours, weights, executor, found);
  // Nothing that is weighed from now on looks farther back; moving rows up in halves costs one copy of each.
  const std::size_t needed = end - std::min(end, std::size_t(options_.history));
  if (needed <= swept_.first || needed - swept_.first < swept_.rows.size() / 2) return;
  swept_.rows.forget(needed - swept_.first);
  swept_.first = needed;
}

void OnLinePosteriors::forget(std::size_t count) {
  if (count > swept_.first) swept_.rows.forget(std::min(count - swept_.first, swept_.rows.size()));
  swept_.first -= std::min(swept_.first, count);
}

}  // namespace echoarc::consensus
