// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::nav {

/// Where what is known to be free ends in the unknown: free cells with an unknown one among their 8 neighbours, joined
/// over their 8 neighbours ([Yamauchi97]). What lies off the map is unknown.
struct Frontier {
  std::vector<Cell> cells;  ///< in the grid's order
  Cell target;              ///< the cell nearest the centroid, the first of several
};

/// Whether `c` is a free cell that borders on the unknown.
[[nodiscard]] bool is_frontier_cell(const DenseGrid<CellState>& map, Cell c);

/// All regions of at least `least_cells`, in the order of their first cells.
[[nodiscard]] std::vector<Frontier> find_frontiers(const DenseGrid<CellState>& map, std::size_t least_cells);

/// The same for a map that changes: looks at what changed and its neighbours, and joins frontier cells alone.
class FrontierFinder {
 public:
  explicit FrontierFinder(std::size_t least_cells = 1) : least_cells_(least_cells) {}

  /// After cells of `changed` changed in the map; a map of another geometry is looked at as a whole.
  void update(const DenseGrid<CellState>& map, const CellBox& changed);
  [[nodiscard]] const std::vector<Frontier>& frontiers() const { return frontiers_; }

 private:
  void join();
  [[nodiscard]] Frontier grow(Cell seed);

  std::size_t least_cells_;
  DenseGrid<std::uint8_t> marks_;                // per cell: 0 none, 1 frontier, 2 frontier that a region has
  std::vector<std::vector<std::int32_t>> rows_;  // columns of the frontier cells of each row, ascending
  std::vector<Frontier> frontiers_;
};

}  // namespace echoarc::nav
