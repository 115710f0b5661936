// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
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
      : counts_(geometry, memory_limit_bytes), plans_{Plan(geometry, sampling), Plan(geometry, sampling)} {}

  /// Takes an arc, to be counted while the next one is prepared. False when the memory limit forbids it; no count will
  /// change then.
  [[nodiscard]] bool add(const Arc& arc);
  /// Counts what has been taken; to be called before the counts are read.
  void settle();
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
  /// The rows of a branch inside one row of tiles: `rows` of them from row `first` of the branch on. The tiles are
  /// those from tiles[tile] on, the first of them at tile column `tile_i`.
  struct Band {
    std::size_t branch = 0;
    std::size_t first = 0;
    std::size_t rows = 0;
    std::size_t tile = 0;
    std::int32_t tile_i = 0;
  };
  /// An arc whose tiles exist and whose counts are on their way from memory.
  struct Plan {
    Plan(GridGeometry geometry, ArcSampling sampling) : raster(geometry, sampling) {}
    ArcRaster raster;
    std::span<const ArcBranch> branches;
    std::vector<Band> bands;
    std::vector<std::uint16_t*> tiles;
    std::vector<std::uint16_t*> blocks;  // where the runs of all bands begin
  };
  [[nodiscard]] bool find_bands(Plan& plan);
  [[nodiscard]] bool find_band_tiles(Plan& plan, Band& band);
  static void visit_bands(Plan& plan, bool count);
  [[nodiscard]] bool add_cells(std::span<const Cell> cells);
  [[nodiscard]] bool find_tiles(std::span<const Cell> cells);

  Counts counts_;
  std::array<Plan, 2> plans_;
  std::size_t taken_ = 0;  // the plan that `settle` counts
  std::vector<Run> runs_;
};

}  // namespace echoarc
