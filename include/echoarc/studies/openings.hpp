// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/eval/passability.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::studies {

/// Stretches of the segment a -> b, longer than 1 mm, along which no wall runs: doorways and other openings. Walls
/// count that have both ends within `tolerance_m` of its line.
[[nodiscard]] std::vector<Gap> open_stretches(const sim::WorldDescription& world, Vec2 a, Vec2 b,
                                              double tolerance_m = 0.02);

/// The strip over one of them, `depth_m` to both sides of a -> b.
[[nodiscard]] Strip strip_over(Vec2 a, Vec2 b, const Gap& stretch, double depth_m);

}  // namespace echoarc::studies
