// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "mapping/consensus/posterior.hpp"

namespace echoarc::consensus {

/// Step B for arcs as they come: each is weighed once against the arcs before it, and all sweeps once more when others
/// have followed.
class OnLinePosteriors {
 public:
  explicit OnLinePosteriors(const ConsensusOptions& options) : options_(options), swept_{WeightRows(0, 1), 0} {}

  /// Goes on from sweeps over all arcs.
  void start(const ArcTable& arcs, SweptRows swept);
  /// Weighs the arcs from `from` on, one after the other, each with what those before it say now.
  void weigh_new(const ArcTable& arcs, std::size_t from, const FoundPosterior& found);
  /// Weighs the arcs first <= i < end in all sweeps, with what those around them say now.
  void weigh_again(const ArcTable& arcs, std::size_t first, std::size_t end, Executor& executor,
                   const FoundPosterior& found);
  /// The first `count` arcs are forgotten.
  void forget(std::size_t count);

 private:
  void make_room(const ArcTable& arcs);
  void put(const ArcTable& arcs, std::size_t i, const Posterior& posterior, WeightRows& rows, std::size_t k) const;

  ConsensusOptions options_;
  SweptRows swept_;  // of the arcs that those still to be weighed may look at
};

}  // namespace echoarc::consensus
