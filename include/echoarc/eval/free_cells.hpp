// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/vec2.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc {

/// The true state of every cell of a box: `occupied` where a surface runs, `free` where one can get from `inside`
/// without crossing one (over the sides of cells), `unknown` for the rest: behind walls, in solid bodies.
///
/// `surfaces` are points on all surfaces, neighbours at most half a cell apart. A start that is itself on a surface
/// or outside the grid leaves no cell free.
[[nodiscard]] DenseGrid<CellState> true_states(std::span<const Vec2> surfaces, const GridGeometry& geometry,
                                               std::int32_t width, std::int32_t height, Vec2 inside);

/// How the free cells of a map stand against the truth. False free cells are what a robot runs into: [Numakura] 6 and
/// [Yamauchi97] compare their maps by them.
struct FreeCells {
  std::uint64_t free = 0;        ///< all free cells of the map
  std::uint64_t true_free = 0;   ///< free in truth
  std::uint64_t on_surface = 0;  ///< a surface runs through them
  std::uint64_t behind = 0;      ///< behind a surface, or outside the truth's grid
  std::uint64_t reachable = 0;   ///< free in truth, whatever the map says
  double cell_area_m2 = 0.0;

  [[nodiscard]] std::uint64_t false_free() const { return on_surface + behind; }
};

/// Cells are compared by their centres; best give both grids the same cells. Both hold cells of a positive size.
[[nodiscard]] FreeCells count_free_cells(const DenseGrid<CellState>& map, const DenseGrid<CellState>& truth);

}  // namespace echoarc
