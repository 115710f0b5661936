// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "mapping/consensus/posterior.hpp"

namespace echoarc::consensus {

/// What is left of an arc's posterior.
struct EchoEstimate {
  Angle t;                  ///< bearing of the echo, off the arc's axis; of its normal, for a bistatic reading
  double p = 0.0;           ///< mass within `tolerance_m` of it
  double bound_m = 0.0;     ///< radius that holds 90 %
  double wall_share = 0.5;  ///< p_w
  double evidence = 0.0;    ///< ev
};

/// Step C: the bearing whose surroundings hold most of the posterior.
[[nodiscard]] EchoEstimate read_out(const EchoArc& echo, const BeamBins& bins, const ConsensusOptions& options,
                                    const Posterior& posterior);

/// A point of step C in the world.
struct Element {
  std::size_t echo = 0;  ///< its arc, in the table
  Vec2 position;
  Vec2 normal;  ///< outward, away from the sensor
};

[[nodiscard]] Element element_of(const ArcTable& arcs, std::size_t i, Angle t);

}  // namespace echoarc::consensus
