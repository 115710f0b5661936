// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/free_cells.hpp"

#include <array>
#include <cassert>

namespace echoarc {
namespace {

// From cell to cell over their sides alone, so that a chain of cells that touch by their corners is tight.
void flood(DenseGrid<CellState>& grid, Cell start) {
  std::vector<Cell> open;
  const auto enter = [&](Cell cell) {
    if (!grid.box().contains(cell) || grid.at(cell) != CellState::unknown) return;
    grid.at(cell) = CellState::free;
    open.push_back(cell);
  };
  enter(start);
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (const Cell step : std::array{Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}})
      enter({cell.i + step.i, cell.j + step.j});
  }
}

}  // namespace

DenseGrid<CellState> true_states(std::span<const Vec2> surfaces, const GridGeometry& geometry, std::int32_t width,
                                 std::int32_t height, Vec2 inside) {
  DenseGrid<CellState> truth(geometry, width, height, CellState::unknown);
  for (const Vec2 point : surfaces) {
    const Cell cell = geometry.cell_of(point);
    if (truth.box().contains(cell)) truth.at(cell) = CellState::occupied;
  }
  flood(truth, geometry.cell_of(inside));
  return truth;
}

FreeCells count_free_cells(const DenseGrid<CellState>& map, const DenseGrid<CellState>& truth) {
  assert(map.geometry().cell_m > 0.0 && truth.geometry().cell_m > 0.0);
  FreeCells count;
  count.cell_area_m2 = map.geometry().cell_m * map.geometry().cell_m;
  for (const CellState state : truth.values()) count.reachable += state == CellState::free ? 1 : 0;
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i) {
      if (map.at({i, j}) != CellState::free) continue;
      ++count.free;
      const Cell cell = truth.geometry().cell_of(map.geometry().centre({i, j}));
      const CellState state = truth.box().contains(cell) ? truth.at(cell) : CellState::unknown;
      ++(state == CellState::free ? count.true_free : state == CellState::occupied ? count.on_surface : count.behind);
    }
  return count;
}

}  // namespace echoarc
