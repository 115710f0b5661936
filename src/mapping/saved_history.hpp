// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/bytes.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/arc_history.hpp"

namespace echoarc {

/// Whether an arc read from bytes is one that a reading could have given.
[[nodiscard]] bool is_plausible(const Arc& arc);

/// Writes the arcs of a history, oldest first.
void save_history(ByteWriter& out, const ArcHistory& history);
/// Puts them into an empty history of the same scope and capacity, so that slots count from the oldest arc. False when
/// the bytes hold no arcs, or more than the history keeps.
[[nodiscard]] bool restore_history(ByteReader& in, ArcHistory& history);

/// Writes a point map with its support.
void save_points(ByteWriter& out, const PointMap& map);
/// Reads it into an empty map; false when the bytes hold none.
[[nodiscard]] bool restore_points(ByteReader& in, PointMap& map);

}  // namespace echoarc
