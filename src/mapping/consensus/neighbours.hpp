// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "mapping/consensus/arc_table.hpp"

namespace echoarc::consensus {

/// The arcs that speak for or against the bearings of one.
struct Neighbours {
  std::vector<std::uint32_t> arcs;  ///< in the order of time
  double weight = 1.0;              ///< how many each stands for
};

/// Replaces `out` by the neighbours of arc `i`: near in time (`history`), near enough in space that both may have come
/// from one surface, and evenly thinned to `neighbours`. Only arcs before `end` count.
void find_neighbours(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i, std::size_t end,
                     Neighbours& out);

}  // namespace echoarc::consensus
