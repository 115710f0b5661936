// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <span>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "mapping/consensus/neighbours.hpp"
#include "mapping/consensus/posterior_kernels.hpp"

namespace echoarc::consensus {

/// What an arc knows of the bearing of its echo after a sweep.
struct Posterior {
  std::span<const float> wall;   ///< Q_W by bin, sums to 1
  std::span<const float> point;  ///< Q_P by bin, sums to 1
  float wall_share = 0.5F;       ///< p_w
  float evidence = 0.0F;         ///< ev: log-likelihood of the best bearing against the middle of the beam alone
};

/// Where the bearings of arcs are weighed: rows of u with zeros before and behind, under both hypotheses.
class WeightRows {
 public:
  /// Rows for `count` arcs of at most `bins` bins, read by arcs of at most as many.
  WeightRows(std::size_t count, int bins);
  /// Bins of the widest arc that has room.
  [[nodiscard]] int bins() const { return int(pad_); }
  [[nodiscard]] std::size_t size() const { return wall_.size() / stride_; }
  /// Rows are added, empty, or taken away at the end.
  void resize(std::size_t count);
  /// Takes the first `count` rows away.
  void forget(std::size_t count);
  /// Row `k` becomes row `m` of other rows, with room for no more bins.
  void copy(std::size_t k, const WeightRows& from, std::size_t m);
  /// Fills row `k`: min(1, Q p / top) times `scale`.
  void fill(std::size_t k, const Posterior& posterior, float prior_top, float scale);
  [[nodiscard]] const float* wall(std::size_t k) const { return wall_.data() + k * stride_ + pad_; }
  [[nodiscard]] const float* point(std::size_t k) const { return point_.data() + k * stride_ + pad_; }

 private:
  std::size_t pad_;
  std::size_t stride_;
  std::vector<float> wall_;
  std::vector<float> point_;
};

/// The rows of one sweep: of arcs from `first` on, or of the beams alone before the first sweep.
struct SweepWeights {
  const WeightRows* rows = nullptr;
  std::size_t first = 0;
  bool by_beam = false;
  [[nodiscard]] std::size_t row(const ArcTable& arcs, std::size_t j) const {
    return by_beam ? arcs[j].bins : j - first;
  }
};

/// Step B for one arc after another: its bearings weighed by what its neighbours say.
class PosteriorEstimator {
 public:
  PosteriorEstimator(const ArcTable& arcs, const ConsensusOptions& options);

  /// q kappa: what a neighbour that is certain and fits exactly multiplies the odds by, less one.
  [[nodiscard]] static float support_scale(const ConsensusOptions& options);
  /// The posterior of arc `i` with these neighbours, valid until the next call.
  [[nodiscard]] Posterior estimate(std::size_t i, const Neighbours& neighbours, const SweepWeights& weights);

 private:
  void gather(std::size_t i, const Neighbours& neighbours, const SweepWeights& weights);
  [[nodiscard]] Posterior read(std::size_t i, double weight);

  const ArcTable& arcs_;
  const ConsensusOptions& options_;
  std::vector<kernels::CirclePair> on_walls_;   // neighbours that have directions in common with the arc
  std::vector<kernels::CirclePair> on_points_;  // neighbours that see some of it
  std::vector<float> wall_support_, wall_free_, point_support_, point_free_;
};

/// Bins of the widest arc.
[[nodiscard]] int widest_bins(const ArcTable& arcs);
/// The rows before the first sweep, one a beam.
[[nodiscard]] WeightRows prior_rows(const ArcTable& arcs, const ConsensusOptions& options);

/// What is done with the posterior of an arc; from several threads at once, each arc once.
using FoundPosterior = std::function<void(std::size_t, const Posterior&)>;

/// The neighbours of the arcs first <= i < end.
[[nodiscard]] std::vector<Neighbours> neighbours_of(const ArcTable& arcs, const ConsensusOptions& options,
                                                    std::size_t first, std::size_t end, Executor& executor);
/// One sweep over the arcs from `first` on whose neighbours these are.
void sweep(const ArcTable& arcs, const ConsensusOptions& options, std::size_t first,
           std::span<const Neighbours> neighbours, const SweepWeights& weights, Executor& executor,
           const FoundPosterior& found);

/// What the arcs from `first` on told the last sweep.
struct SweptRows {
  WeightRows rows;
  std::size_t first = 0;
};
/// All sweeps for the arcs first <= i < end.
SweptRows find_posteriors(const ArcTable& arcs, const ConsensusOptions& options, std::size_t first, std::size_t end,
                          Executor& executor, const FoundPosterior& found);

}  // namespace echoarc::consensus
