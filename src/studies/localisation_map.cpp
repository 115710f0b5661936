// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <vector>

#include "echoarc/studies/localisation.hpp"
#include "echoarc/studies/scene_reference.hpp"

namespace echoarc::studies {
namespace {

constexpr double margin_m = 0.3;  // around all surfaces

/// What a robot that starts there may reach without crossing an occupied cell becomes free.
void flood(DenseGrid<CellState>& map, Vec2 start) {
  std::vector<Cell> found;
  const auto visit = [&](Cell c) {
    if (!map.box().contains(c) || map.at(c) != CellState::unknown) return;
    map.at(c) = CellState::free;
    found.push_back(c);
  };
  visit(map.geometry().cell_of(start));
  while (!found.empty()) {
    const Cell c = found.back();
    found.pop_back();
    for (const Cell next : {Cell{c.i + 1, c.j}, Cell{c.i - 1, c.j}, Cell{c.i, c.j + 1}, Cell{c.i, c.j - 1}})
      visit(next);
  }
}

}  // namespace

DenseGrid<CellState> surface_map(const sim::WorldDescription& world, Vec2 start, double cell_m) {
  const std::vector<Vec2> points = surface_points(world, 0.3 * cell_m);
  Box box{start, start};
  for (const Vec2 point : points)
    box = {{std::min(box.low.x, point.x), std::min(box.low.y, point.y)},
           {std::max(box.high.x, point.x), std::max(box.high.y, point.y)}};
  const Vec2 margin{margin_m, margin_m};
  const CellBox cells = GridGeometry{.cell_m = cell_m, .origin = {}}.cells_of({box.low - margin, box.high + margin});
  const GridGeometry geometry{.cell_m = cell_m, .origin = {cells.i_begin * cell_m, cells.j_begin * cell_m}};
  DenseGrid<CellState> map(geometry, std::int32_t(cells.width()), std::int32_t(cells.height()), CellState::unknown);
  for (const Vec2 point : points) map.at(geometry.cell_of(point)) = CellState::occupied;
  flood(map, start);
  return map;
}

}  // namespace echoarc::studies
