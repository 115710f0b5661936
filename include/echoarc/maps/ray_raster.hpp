// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// Turns rays into cells by stepping from grid line to grid line (Amanatides, Woo 1987), as a supercover: where a ray
/// passes exactly through a corner, both cells beside the corner are visited too, so no ray slips through a diagonal
/// wall. Keeps scratch memory between calls: use one raster per thread.
class RayRaster {
 public:
  explicit RayRaster(GridGeometry geometry) : geometry_(geometry) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  /// The cells of \p within that the segment from \p origin over \p length_m along the unit vector \p direction visits,
  /// in the order in which it visits them. A ray along a cell edge belongs to the cells that own the edge. The span is
  /// valid until the next call.
  [[nodiscard]] std::span<const Cell> cells(Vec2 origin, Vec2 direction, double length_m, const CellBox& within);

 private:
  GridGeometry geometry_;
  std::vector<Cell> cells_;
};

}  // namespace echoarc
