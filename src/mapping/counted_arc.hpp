// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "echoarc/core/arc.hpp"
#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// The arc of a reading, for methods that learn from arcs alone; counts the readings that have none.
[[nodiscard]] inline std::optional<Arc> counted_arc(const Reading& reading, BeamPolicy policy,
                                                    InsertCounters& counters) {
  if (!echo_range_m(reading.outcome)) {
    ++counters.no_information;
    return std::nullopt;
  }
  std::optional<Arc> arc = arc_of(reading, policy);
  if (!arc) ++counters.no_arc;
  return arc;
}

/// Whether an arc and its sector can be drawn at all: inside the index range, with scratch memory inside the limit.
[[nodiscard]] inline bool within_reach(const Arc& arc, const GridGeometry& geometry, std::size_t memory_limit_bytes) {
  constexpr double scratch_bytes_per_cell = 64.0;  // two samples of two doubles and a cell, or a few row spans
  const double cells = arc.range_m() / geometry.cell_m;
  const Vec2 offset = arc.centre() - geometry.origin;
  const double farthest = std::max(std::abs(offset.x), std::abs(offset.y)) / geometry.cell_m + 2.0 * cells;
  return farthest < GridGeometry::max_index && 4.0 * cells * scratch_bytes_per_cell < double(memory_limit_bytes);
}

}  // namespace echoarc
