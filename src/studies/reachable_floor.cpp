// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/reachable_floor.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "echoarc/nav/distance_field.hpp"
#include "echoarc/studies/scene_reference.hpp"

namespace echoarc::studies {
namespace {

/// All surfaces with some room around; the start is inside.
DenseGrid<CellState> surface_cells(const sim::WorldDescription& world, Vec2 start, double cell_m) {
  const std::vector<Vec2> points = surface_points(world, cell_m / 2.0);
  Box box{start, start};
  for (const Vec2 point : points)
    box = {{std::min(box.low.x, point.x), std::min(box.low.y, point.y)},
           {std::max(box.high.x, point.x), std::max(box.high.y, point.y)}};
  const CellBox cells = GridGeometry{.cell_m = cell_m, .origin = {}}.cells_of(box);
  const GridGeometry geometry{.cell_m = cell_m, .origin = {(cells.i_begin - 1) * cell_m, (cells.j_begin - 1) * cell_m}};
  DenseGrid<CellState> grid(geometry, std::int32_t(cells.width()) + 2, std::int32_t(cells.height()) + 2,
                            CellState::free);
  for (const Vec2 point : points) grid.at(geometry.cell_of(point)) = CellState::occupied;
  return grid;
}

/// Cells where the robot's centre can be, found over the sides of cells.
std::vector<Cell> centres(const DenseGrid<float>& clearance_m, Vec2 start, double radius_m) {
  DenseGrid<std::uint8_t> seen(clearance_m.geometry(), clearance_m.width(), clearance_m.height());
  std::vector<Cell> found;
  const auto visit = [&](Cell c) {
    if (!seen.box().contains(c) || seen.at(c) != 0 || clearance_m.at(c) < radius_m) return;
    seen.at(c) = 1;
    found.push_back(c);
  };
  visit(clearance_m.geometry().cell_of(start));
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Cell c = found[k];
    for (const Cell next : {Cell{c.i + 1, c.j}, Cell{c.i - 1, c.j}, Cell{c.i, c.j + 1}, Cell{c.i, c.j - 1}})
      visit(next);
  }
  return found;
}

}  // namespace

ReachableFloor::ReachableFloor(const sim::WorldDescription& world, Vec2 start, double robot_radius_m, double cell_m) {
  const DenseGrid<CellState> surfaces = surface_cells(world, start, cell_m);
  // The robot's disc over all places of its centre: cells within its radius of one.
  DenseGrid<CellState> places(surfaces.geometry(), surfaces.width(), surfaces.height());
  for (const Cell c : centres(nav::distance_field(surfaces), start, robot_radius_m)) places.at(c) = CellState::occupied;
  const DenseGrid<float> from_places_m = nav::distance_field(places);
  cells_ = DenseGrid<std::uint8_t>(surfaces.geometry(), surfaces.width(), surfaces.height());
  for (std::size_t k = 0; k < cells_.values().size(); ++k) {
    const bool under = from_places_m.values()[k] < robot_radius_m && surfaces.values()[k] != CellState::occupied;
    cells_.values()[k] = under ? 1 : 0;
    count_ += under ? 1 : 0;
  }
}

double ReachableFloor::area_m2() const {
  const double cell_m = cells_.geometry().cell_m;
  return double(count_) * cell_m * cell_m;
}

double ReachableFloor::covered(const DenseGrid<CellState>& map) const {
  if (count_ == 0) return 0.0;
  std::uint64_t known = 0;
  for (std::int32_t j = 0; j < cells_.height(); ++j)
    for (std::int32_t i = 0; i < cells_.width(); ++i) {
      if (cells_.at({i, j}) == 0) continue;
      const Cell there = map.geometry().cell_of(cells_.geometry().centre({i, j}));
      if (map.box().contains(there) && map.at(there) == CellState::free) ++known;
    }
  return double(known) / double(count_);
}

bool ReachableFloor::contains(Vec2 place) const {
  const Cell c = cells_.geometry().cell_of(place);
  return cells_.box().contains(c) && cells_.at(c) != 0;
}

}  // namespace echoarc::studies
