// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "mapping/consensus/read_out.hpp"

namespace echoarc::consensus {

/// Step D: which elements survive the vote of the rays. Elements on the robot's way have no say. By element.
[[nodiscard]] std::vector<bool> validate(const ArcTable& arcs, const ConsensusOptions& options,
                                         std::span<const Element> elements, std::span<const Vec2> path);

}  // namespace echoarc::consensus
