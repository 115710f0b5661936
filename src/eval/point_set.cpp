// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/point_set.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {
namespace {

bool within_reach(double coordinate_m) {
  return std::abs(coordinate_m) <= PointSet::max_coordinate_m;  // false for NaN
}

Error bad_point(std::size_t index, Vec2 p) {
  return {ErrorCode::bad_value,
          "point " + std::to_string(index) + " at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
              ") m is no place a map can have",
          "", "leave out points that are not finite or further than 10000 km from the origin"};
}

}  // namespace

Result<PointSet> PointSet::make(std::vector<Vec2> points) {
  const auto bad =
      std::find_if(points.begin(), points.end(), [](Vec2 p) { return !within_reach(p.x) || !within_reach(p.y); });
  if (bad != points.end()) return bad_point(std::size_t(bad - points.begin()), *bad);
  PointSet set;
  set.points_ = std::move(points);
  return set;
}

Result<PointSet> PointSet::of_points(const PointMap& map) {
  std::vector<Vec2> points;
  points.reserve(map.size());
  for (const MapPoint& point : map.points()) points.push_back(point.position);
  return make(std::move(points));
}

Result<PointSet> PointSet::of_occupied(const DenseGrid<CellState>& grid) {
  std::vector<Vec2> centres;
  for (std::int32_t j = 0; j < grid.height(); ++j)
    for (std::int32_t i = 0; i < grid.width(); ++i)
      if (grid.at({i, j}) == CellState::occupied) centres.push_back(grid.geometry().centre({i, j}));
  return of_cells(std::move(centres), grid.geometry().cell_m);
}

Result<PointSet> PointSet::of_cells(std::vector<Vec2> centres, double cell_m) {
  if (!(cell_m > 0.0) || !within_reach(cell_m))
    return Error{ErrorCode::bad_value, "cells of " + std::to_string(cell_m) + " m", "", "give a cell size above 0 m"};
  Result<PointSet> set = make(std::move(centres));
  if (set) set->cell_m_ = cell_m;
  return set;
}

PointSet PointSet::one_per_cell(double cell_m) const {
  assert(cell_m > 0.0);
  const GridGeometry geometry{cell_m, {0.0, 0.0}};
  struct Entry {
    Cell cell;
    std::size_t index;
  };
  std::vector<Entry> entries;
  entries.reserve(size());
  for (const Vec2 p : points_) entries.push_back({geometry.cell_of(p), entries.size()});
  // Sorted rather than hashed: the first of each cell is the one with the smallest index, on every platform.
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.cell == b.cell ? a.index < b.index : a.cell < b.cell; });
  const auto same_cell = [](const Entry& a, const Entry& b) { return a.cell == b.cell; };
  entries.erase(std::unique(entries.begin(), entries.end(), same_cell), entries.end());
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.index < b.index; });
  PointSet thinned;
  thinned.cell_m_ = cell_m_;
  for (const Entry& entry : entries) thinned.points_.push_back(points_[entry.index]);
  return thinned;
}

}  // namespace echoarc
