// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "echoarc/core/reading.hpp"

namespace echoarc::bench {

/// A drive down a corridor without end, 2 m wide with a door recess every 3 m, in echoes alone: eight sonars with beams
/// of 20 degrees and ranges in steps of 1 cm, 90 echoes per metre of way, as in run 1 of the recorded corridor
/// (docs/corridor.md). However long the drive, an arc has as many neighbours.
[[nodiscard]] std::vector<Reading> corridor_echoes(std::size_t count, std::uint64_t seed = 1);

}  // namespace echoarc::bench
