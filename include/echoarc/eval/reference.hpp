// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/point_set.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc {

/// What a map is held against: points on the true surfaces, at least one.
struct Reference {
  PointSet points;
  double spacing_m = 0.0;  ///< largest distance of neighbours along a surface: sampling step, or side of a cell
  std::string provenance;  ///< where it came from, for reports
};

/// A surface as a chain of straight segments; one vertex is a pole.
using Polyline = std::vector<Vec2>;

/// Points along the polylines, both ends of every segment included, steps of at most `spacing_m` ([Barshan07] 4.1 has
/// one every 2 mm or less). `spacing_m` in metres, above 0. Errors: no vertex, vertices that are not finite, a spacing
/// out of range, more than `max_reference_points`.
[[nodiscard]] Result<Reference> polyline_reference(std::span<const Polyline> surfaces, std::string provenance,
                                                   double spacing_m = 0.002);
inline constexpr std::size_t max_reference_points = 50'000'000;

/// The centres of the occupied cells of another map. Errors: no occupied cell.
[[nodiscard]] Result<Reference> map_reference(const DenseGrid<CellState>& grid, std::string provenance);

struct LaserReferenceOptions {
  double range_max_m = 6.0;
  double cell_m = 0.05;
  int min_returns = 3;

  static constexpr auto fields() {
    return std::tuple{
        field("range_max_m", &LaserReferenceOptions::range_max_m,
              {.unit = "m", .min = 0.01, .max = 1000.0, .doc = "returns at or beyond this range are left out"}),
        field("cell_m", &LaserReferenceOptions::cell_m,
              {.unit = "m", .min = 0.001, .max = 10.0, .doc = "side of the cells in which returns are counted"}),
        field("min_returns", &LaserReferenceOptions::min_returns,
              {.unit = "returns", .min = 1, .max = 65535, .doc = "fewer returns in a cell are no surface"})};
  }
};

/// The surfaces the log's own lasers saw: every return below `range_max_m` is placed in the world from the pose
/// interpolated at its scan's time and the laser's mount; a cell floor(p / cell_m) with at least `min_returns` of them
/// is part of the reference, by its centre. As good as the poses: odometry drift blurs map and reference alike.
/// Errors: no scan, no odometry, a scan of an undescribed laser, options out of range, no cell with enough returns,
/// cells spread too far for memory.
[[nodiscard]] Result<Reference> laser_reference(const Log& log, const LaserReferenceOptions& options = {});

}  // namespace echoarc
