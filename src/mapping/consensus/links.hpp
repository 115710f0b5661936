// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mapping/consensus/looks.hpp"
#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {

/// Two elements with nothing between them that speaks against a wall.
struct Link {
  std::uint32_t first = 0;  ///< among the elements; first < second
  std::uint32_t second = 0;
  friend bool operator==(const Link&, const Link&) = default;
};

/// Step E: joins every element with its nearest neighbours on both sides of its tangent, at most `gap_m` away, unless
/// rays cross the gap, or looks at a right angle to it find nothing there. Ordered by their elements.
[[nodiscard]] std::vector<Link> find_links(const ArcTable& arcs, const ConsensusOptions& options,
                                           std::span<const Element> elements, std::span<const Look> looks,
                                           double gap_m);

}  // namespace echoarc::consensus
