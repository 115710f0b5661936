// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {

/// Step F: what surfaces must reach to for their echoes to be heard. Each of `elements` with p above `least_p` reaches
/// as far as the first Fresnel zone asks, to either side, along the tangent of a wall and along the arc of a point.
/// Shown are the ends that are occupied (`surface_evidence`) and farther than `link_step_m` from every place of `shown`
/// and every likelier end, the likeliest first. Each is an element of the echo it grows from.
[[nodiscard]] std::vector<Element> find_zones(const ArcTable& arcs, const ConsensusOptions& options,
                                              std::span<const EchoEstimate> estimates,
                                              std::span<const Element> elements, std::span<const Vec2> shown,
                                              double least_p);

}  // namespace echoarc::consensus
