// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::consensus {

void find_neighbours(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i, std::size_t end,
                     Neighbours& out) {
  const auto history = std::size_t(options.history);
  const std::size_t begin = i > history ? i - history : 0;
  end = std::min({end, arcs.size(), i + history + 1});
  const double own_m = arcs.half_length_m(i) + 2.0 * options.wall_length_m;
  out.arcs.clear();
  for (std::size_t j = begin; j < end; ++j) {
    const double reach_m = std::min(options.reach_m, own_m + arcs.half_length_m(j));
    if (squared_norm(arcs.middle(j) - arcs.middle(i)) <= reach_m * reach_m && j != i)
      out.arcs.push_back(std::uint32_t(j));
  }
  const std::size_t found = out.arcs.size();
  const auto wanted = std::size_t(options.neighbours);
  out.weight = 1.0;
  if (found <= wanted) return;
  const double step = wanted > 1 ? double(found - 1) / double(wanted - 1) : 0.0;
  for (std::size_t k = 0; k < wanted; ++k) out.arcs[k] = out.arcs[std::size_t(std::nearbyint(double(k) * step))];
  out.arcs.resize(wanted);
  out.weight = double(found) / double(wanted);
}

}  // namespace echoarc::consensus
