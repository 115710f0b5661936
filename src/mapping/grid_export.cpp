// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/grid_export.hpp"

#include <limits>
#include <string>

namespace echoarc {

Result<void> check_drawable(const CellBox& box, std::string_view method) {
  if (box.width() <= max_export_cells && box.height() <= max_export_cells &&
      box.width() * box.height() <= max_export_cells)
    return {};
  return Error{ErrorCode::too_large,
               "the map spans " + std::to_string(box.width()) + " x " + std::to_string(box.height()) +
                   " cells, more than the " + std::to_string(max_export_cells) + " of one picture",
               std::string(method), "use a larger cell_m, or check the log for poses far from the rest"};
}

MapPoint cell_point(const GridGeometry& geometry, Cell cell) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  MapPoint point;
  point.position = geometry.centre(cell);
  point.label = PointLabel::cell;
  point.bound_m = nan;
  point.time_s = nan;
  return point;
}

}  // namespace echoarc
