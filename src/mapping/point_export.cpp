// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/point_export.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/grid_export.hpp"

namespace echoarc {
namespace {

constexpr double segment_step_m = 0.01;

/// Calls `visit(cell)` for what the map occupies; some cells come many times.
template <class Visit>
void visit_cells(const PointMap& points, const GridGeometry& geometry, Visit visit) {
  for (const MapPoint& point : points.points()) visit(geometry.cell_of(point.position));
  const double step_m = std::min(segment_step_m, geometry.cell_m);
  for (const MapSegment& segment : points.segments()) {
    const Vec2 way = segment.end - segment.begin;
    const double pieces = std::max(1.0, std::ceil(norm(way) / step_m));
    for (double k = 0.0; k <= pieces; ++k) visit(geometry.cell_of(segment.begin + (k / pieces) * way));
  }
}

}  // namespace

Result<MapExport> export_points(const PointMap& points, const GridGeometry& geometry, std::string_view method) {
  CellBox box;
  visit_cells(points, geometry, [&](Cell cell) { box = unite(box, {cell.i, cell.j, cell.i + 1, cell.j + 1}); });
  if (const Result<void> drawable = check_drawable(box, method); !drawable) return drawable.error();
  GridGeometry part = geometry;
  part.origin = geometry.corner({box.i_begin, box.j_begin});
  MapExport out;
  out.points = points;
  out.states = DenseGrid<CellState>(part, std::int32_t(box.width()), std::int32_t(box.height()));
  visit_cells(points, geometry,
              [&](Cell cell) { out.states.at({cell.i - box.i_begin, cell.j - box.j_begin}) = CellState::occupied; });
  return out;
}

}  // namespace echoarc
