// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "echoarc/core/bytes.hpp"
#include "echoarc/mapping/numakura.hpp"
#include "echoarc/maps/arc_raster.hpp"
#include "echoarc/maps/sector_raster.hpp"
#include "mapping/numakura_kernels.hpp"

namespace echoarc {

/// The part of a reading that changes cells, with its judgement: everything that is kept of it until its scan ends.
struct Contribution {
  Pose2 T_world_tx;
  Pose2 T_world_rx;
  Angle beam_width;
  double range_m = 0.0;            ///< of silence: how far it clears
  std::int32_t free_step = 0;      ///< in `numakura_unit`, >= 0
  std::int32_t obstacle_step = 0;  ///< in `numakura_unit`, >= 0
  std::uint32_t monostatic = 1;
  std::uint32_t echo = 1;

  /// The arc; of silence the rim of the sector. No value without legal geometry.
  [[nodiscard]] std::optional<Arc> arc() const;
  /// The sector inside which cells are free: half path below range - cell, or all of the sector of silence. No value
  /// where there is no room for one.
  [[nodiscard]] std::optional<Arc> interior(const Arc& arc, double cell_m) const;
};

/// The readings of the present scan: judged, their cells found and their tiles made, but not yet in the map.
class Numakura::OpenScan {
 public:
  OpenScan(const NumakuraOptions& options, Map& grid);
  void attach(Map& grid) { grid_ = &grid; }

  /// False when the grid cannot hold its cells, and nothing has changed then.
  [[nodiscard]] bool add(const Contribution& contribution);
  /// Puts the scan into the map and starts an empty one.
  void close();
  /// Puts the scan into the map so that `hide` can take it out again.
  void show();
  void hide();
  /// The value without what `show` put in.
  [[nodiscard]] std::int32_t value_before(Cell cell) const;

  void save(ByteWriter& out) const;
  /// False when the bytes are no scan; the grid must be as it was when the scan was saved.
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  struct Part {  // one reading's share of the lists below
    std::size_t runs_end = 0;
    std::size_t arc_end = 0;
  };
  struct Kept {
    Cell index;
    std::unique_ptr<Map::Tile> tile;
  };

  [[nodiscard]] bool plan(const Contribution& contribution);
  [[nodiscard]] bool plan_rows(const Arc& interior);
  [[nodiscard]] bool plan_arc(const Arc& arc);
  [[nodiscard]] Map::Tile* tile_at(Cell index);
  void truncate(std::size_t touched);
  void apply();
  [[nodiscard]] std::vector<Cell> touched_once() const;

  NumakuraOptions options_;
  Map* grid_;
  SectorRaster sectors_;
  ArcRaster arcs_;
  std::size_t most_touched_;
  std::vector<Contribution> contributions_;
  std::vector<Part> parts_;
  std::vector<kernels::TileRun> runs_;
  std::vector<std::int32_t*> arc_cells_;
  std::vector<Cell> touched_;  // tiles, some of them more than once
  std::vector<Kept> kept_;     // while shown: the touched tiles as they were, in order
  bool shown_ = false;
};

}  // namespace echoarc
