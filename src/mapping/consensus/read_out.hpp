// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

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

/// Whether the estimate is shown, and votes, if the vote does not remove it: near enough and, for the mode, sure
/// enough.
[[nodiscard]] bool is_believed(const EchoArc& echo, const ConsensusOptions& options, const EchoEstimate& estimate);

/// A point of step C in the world.
struct Element {
  std::size_t echo = 0;  ///< its arc, in the table
  Vec2 position;
  Vec2 normal;  ///< outward, away from the sensor
};

[[nodiscard]] Element element_of(const ArcTable& arcs, std::size_t i, Angle t);
[[nodiscard]] std::vector<Vec2> positions_of(std::span<const Element> elements);
/// Whether two elements may belong to one surface: their normals differ by less than 60 degrees.
[[nodiscard]] bool same_side(const Element& a, const Element& b);

}  // namespace echoarc::consensus
