// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {

/// How much speaks for a surface at each of `places`, as log-odds: the evidence of `ConsensusEvidence`, at places
/// instead of cells, from echoes alone, each with its whole p where it was read out.
///
/// A ray makes likely what lies in the band around its range, within `spread_m` of its end, and unlikely what its sound
/// passed on the way there. The rays are elements of step C; both legs of a bistatic one count.
[[nodiscard]] std::vector<double> surface_evidence(const ArcTable& arcs, const ConsensusOptions& options,
                                                   std::span<const EchoEstimate> estimates,
                                                   std::span<const Element> rays, std::span<const Vec2> places);

/// The least that a place needs to be occupied.
[[nodiscard]] double least_evidence(const ConsensusOptions& options);

}  // namespace echoarc::consensus
