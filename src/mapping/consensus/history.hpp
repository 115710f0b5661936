// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "mapping/consensus/looks.hpp"
#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {

/// What a consensus remembers: its arcs with what is known of them, and where the robot was.
struct History {
  explicit History(const ConsensusOptions& options) : arcs(options) {}

  /// The robot was here; what it did not leave by a millimetre is one place.
  void visit(Vec2 position) {
    constexpr double least_move_m = 0.001;
    if (!path.empty() && norm(position - path.back()) < least_move_m) return;
    path.push_back(position);
    path_arcs.push_back(std::uint32_t(arcs.size()));
  }

  /// Where it was from arc `from` on.
  [[nodiscard]] std::span<const Vec2> path_since(std::size_t from) const {
    const auto found = std::ranges::lower_bound(path_arcs, from);
    return std::span(path).subspan(std::size_t(found - path_arcs.begin()));
  }

  /// Forgets the first `count` arcs, and where the robot was before.
  void forget(std::size_t count) {
    arcs.forget(count);
    looks.forget(count);
    estimates.erase(estimates.begin(), estimates.begin() + std::ptrdiff_t(std::min(count, estimates.size())));
    settled -= std::min(settled, count);
    path.erase(path.begin(), path.end() - std::ptrdiff_t(path_since(count).size()));
    path_arcs.erase(path_arcs.begin(), path_arcs.end() - std::ptrdiff_t(path.size()));
    for (std::uint32_t& before : path_arcs) before -= std::uint32_t(count);
  }

  ArcTable arcs;
  LookTable looks;
  std::vector<EchoEstimate> estimates;   // by arc
  std::size_t settled = 0;               // arcs whose estimates no reading can change any more
  std::vector<Vec2> path;                // of the robot
  std::vector<std::uint32_t> path_arcs;  // arcs before each place
};

}  // namespace echoarc::consensus
