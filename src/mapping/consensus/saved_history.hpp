// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/bytes.hpp"
#include "echoarc/maps/point_map.hpp"
#include "mapping/consensus/on_line_map.hpp"

namespace echoarc::consensus {

/// Arcs, path, and the settled estimates of the first `context` arcs; others are found again.
void save_history(ByteWriter& out, const History& history, std::size_t context);
/// Into an empty history; false when the bytes hold none.
[[nodiscard]] bool restore_history(ByteReader& in, History& history);

/// The first points of a map with their beliefs, and its first segments.
void save_final_map(ByteWriter& out, const PointMap& map, const MapSize& size);
/// Into an empty map; false when the bytes hold none.
[[nodiscard]] bool restore_final_map(ByteReader& in, PointMap& map);

}  // namespace echoarc::consensus
