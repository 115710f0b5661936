// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/maps/point_map.hpp"
#include "mapping/consensus/links.hpp"

namespace echoarc::consensus {

/// The finished layers of a map.
struct Layers {
  std::vector<Element> accepted;  ///< walls and points
  std::vector<Link> links;        ///< between accepted elements
  std::vector<Element> zones;     ///< of the echo they grow from, moved there
  std::vector<Element> weak;
};

/// Steps C to F from the estimates on, one an arc.
[[nodiscard]] Layers build_layers(const ArcTable& arcs, const ConsensusOptions& options,
                                  std::span<const EchoEstimate> estimates, std::span<const Vec2> path,
                                  std::span<const Look> looks);

/// The layers as map points, with the pings that speak for each: an element's own first, then those beside it.
[[nodiscard]] PointMap point_map_of(const ArcTable& arcs, const ConsensusOptions& options,
                                    std::span<const EchoEstimate> estimates, const Layers& layers);

}  // namespace echoarc::consensus
