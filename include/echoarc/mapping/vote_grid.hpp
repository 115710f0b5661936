// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/arc_raster.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

/// The ultrasonic arc map: how many arcs cross each cell ([Barshan07] 3.2). An arc counts once per cell however often
/// it enters; counts stay at 65535 once they are there.
class VoteGrid {
 public:
  using Counts = TiledGrid<std::uint16_t>;

  VoteGrid(GridGeometry geometry, std::size_t memory_limit_bytes, ArcSampling sampling)
      : counts_(geometry, memory_limit_bytes), raster_(geometry, sampling) {}

  /// Counts an arc. False when the memory limit forbids it; no count has changed then.
  [[nodiscard]] bool add(const Arc& arc);
  [[nodiscard]] const Counts& counts() const { return counts_; }
  /// What `add` would change.
  [[nodiscard]] std::vector<CellChange> changes(const Arc& arc) const;
  /// Whether the arc crosses the cell at \p position.
  [[nodiscard]] bool crosses(const Arc& arc, Vec2 position) const;

  void save(ByteWriter& out) const { counts_.save(out); }
  /// False when the bytes are no counts of a grid with this geometry and memory limit.
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  /// Consecutive cells of an arc inside one tile.
  struct Run {
    Counts::Tile* tile = nullptr;
    std::size_t end = 0;
  };
  [[nodiscard]] bool find_tiles(std::span<const Cell> cells);

  Counts counts_;
  ArcRaster raster_;
  std::vector<Run> runs_;
};

}  // namespace echoarc
