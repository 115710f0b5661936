// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/point_export.hpp"

#include "mapping/grid_export.hpp"

namespace echoarc {

Result<MapExport> export_points(const PointMap& points, const GridGeometry& geometry, std::string_view method) {
  CellBox box;
  for (const MapPoint& point : points.points()) {
    const Cell cell = geometry.cell_of(point.position);
    box = unite(box, {cell.i, cell.j, cell.i + 1, cell.j + 1});
  }
  if (const Result<void> drawable = check_drawable(box, method); !drawable) return drawable.error();
  GridGeometry part = geometry;
  part.origin = geometry.corner({box.i_begin, box.j_begin});
  MapExport out;
  out.points = points;
  out.states = DenseGrid<CellState>(part, std::int32_t(box.width()), std::int32_t(box.height()));
  for (const MapPoint& point : points.points()) {
    const Cell cell = geometry.cell_of(point.position);
    out.states.at({cell.i - box.i_begin, cell.j - box.j_begin}) = CellState::occupied;
  }
  return out;
}

}  // namespace echoarc
