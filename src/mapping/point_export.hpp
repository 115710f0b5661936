// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/method.hpp"

namespace echoarc {

/// What point methods hand over: the points, and the cells of `geometry` that they lie in or that their segments, drawn
/// in steps of at most 1 cm, go through as occupied. An error when they are spread too far to be drawn.
[[nodiscard]] Result<MapExport> export_points(const PointMap& points, const GridGeometry& geometry,
                                              std::string_view method);

/// The same of a map with `neighbour_fields` among its options: of the points that have company.
template <class Options>
[[nodiscard]] Result<MapExport> export_points(const PointMap& points, const Options& options, std::string_view method) {
  return export_points(with_neighbours(points, neighbour_rule(options)), geometry_of(options), method);
}

}  // namespace echoarc
