// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>
#include <utility>

#include "echoarc/mapping/method.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

/// Success when a picture of the box is small enough to be made (`max_export_cells`).
[[nodiscard]] Result<void> check_drawable(const CellBox& box, std::string_view method);

/// The centre of an occupied cell as a map point. Time and bound are NaN: a cell does not know which echoes made it.
[[nodiscard]] MapPoint cell_point(const GridGeometry& geometry, Cell cell);

/// What all grid methods hand over: the box that holds every cell different from T{}, `state_of(Cell, const T&)` as
/// states, `value_of(const T&)` as values (of type Value), centres of occupied cells as points.
template <class Value, class T, class StateOf, class ValueOf>
[[nodiscard]] Result<MapExport> export_grid(const TiledGrid<T>& grid, std::string_view method, StateOf&& state_of,
                                            ValueOf&& value_of) {
  const CellBox box = grid.bounds();
  if (const Result<void> drawable = check_drawable(box, method); !drawable) return drawable.error();
  MapExport out;
  DenseGrid<Value> values = to_dense<Value>(grid, box, value_of);
  out.states = DenseGrid<CellState>(values.geometry(), values.width(), values.height(), CellState::unknown);
  grid.for_each_nonzero([&](Cell cell, const T& value) {
    const CellState state = state_of(cell, value);
    out.states.at({cell.i - box.i_begin, cell.j - box.j_begin}) = state;
    if (state == CellState::occupied) out.points.add(cell_point(grid.geometry(), cell));
  });
  out.values = std::move(values);
  return out;
}

}  // namespace echoarc
