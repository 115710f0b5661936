// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/executor.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/mapping/consensus_options.hpp"

namespace echoarc {

/// What the sweeps up to one have made of the bearings of an echo (step B of docs/methods/consensus.md).
struct SweepBelief {
  std::vector<double> wall;   ///< Q_W by bearing, sums to 1
  std::vector<double> point;  ///< Q_P by bearing, sums to 1
  double wall_share = 0.5;    ///< p_w
  double evidence = 0.0;      ///< ev
};

/// What one neighbour adds, in the last sweep, to the logarithms of the bearing nearest to the one read out.
struct NeighbourVoice {
  PingId ping = 0;
  double wall = 0.0;        ///< ln(1 + q g u kappa exp(-e^2/2 sigma^2)), wall hypothesis; neither tempered nor weighted
  double wall_free = 0.0;   ///< what it says against a wall: it looked through it
  double point = 0.0;       ///< the same for a point
  double point_free = 0.0;  ///< and against one
};

/// Step B of tangent consensus for one echo, sweep by sweep.
struct EchoExplanation {
  Arc arc;
  std::vector<Angle> bearings;         ///< t, off the axis of the arc
  std::vector<double> prior;           ///< of the beam alone, sums to 1
  std::vector<SweepBelief> sweeps;     ///< after the first, the second, ...
  double neighbour_weight = 1.0;       ///< f: how many arcs each neighbour stands for
  std::vector<NeighbourVoice> voices;  ///< in the order of time
  Angle t;                             ///< read out of the last sweep
  Vec2 position;                       ///< of it, in the world
  double p = 0.0;                      ///< that the echo came from within `tolerance_m` of there
  double bound_m = 0.0;                ///< holds with 90 %
};

/// Why the echo of `ping` is where it is: what its neighbours, before and after it, make of its bearings.
/// `readings` in the order of time, as `Consensus` gets them. An error when the ping is not among them, is no echo, has
/// no arc, or says the same as the one before it (step A).
[[nodiscard]] Result<EchoExplanation> explain_echo(std::span<const Reading> readings, const ConsensusOptions& options,
                                                   PingId ping, Executor& executor);

}  // namespace echoarc
