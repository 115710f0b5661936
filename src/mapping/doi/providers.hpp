// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/mapping/doi_history.hpp"
#include "mapping/doi/lines.hpp"

/// Where lines of interest come from ([Barshan07] 3.3, 4.2, 5). A provider yields lines of cells, ordered from the
/// robot outward, and knows nothing of the rule that is applied to them.
namespace echoarc::doi {

/// Parallels to the unit vector \p outward, one cell wide. With n = `outward` turned by -90 degrees, a cell with centre
/// c (in cells) lies on line floor((c - origin) . n + 1/2), at (c - origin) . outward along it.
void axis_lines(std::span<const LineCell> cells, Vec2 origin_cells, Vec2 outward, const LineVisitor& visit);

/// The line of sight of every echo, to the sensor's limit.
void sight_lines(RayLines& rays, std::span<const DoiHistory::Sight> sights, const LineVisitor& visit);

/// Perpendicular to the path, one sample per cell of way, to the side of `sides[stop]`; to both where that is unknown
/// and \p both_if_unknown. The tangent is the chord over \p tangent_window_m to either side along the path.
void path_lines(RayLines& rays, const DoiHistory& history, std::span<const WallSide> sides, bool both_if_unknown,
                double spacing_m, double tangent_window_m, const LineVisitor& visit);

/// The side of the tracked wall where the log names it.
[[nodiscard]] std::vector<WallSide> named_sides(std::span<const DoiHistory::Stop> stops);

/// Rays around a vantage point, `step` apart (a whole number of them per turn), to \p length_m.
void polar_lines(RayLines& rays, Vec2 vantage_point, Angle step, double length_m, const LineVisitor& visit);

/// Places on the path, \p spacing_m apart, the first where it begins.
[[nodiscard]] std::vector<Vec2> vantage_points(std::span<const DoiHistory::Waypoint> path, double spacing_m);

/// Main axes of weighted points.
struct Spread {
  double weight = 0.0;
  double smaller = 0.0;  ///< eigenvalues of the covariance (divided by the weight)
  double larger = 0.0;
  Vec2 mean;
  Angle across;  ///< direction of the smaller one, modulo 180 degrees
};
struct WeightedPoint {
  Vec2 position;
  double weight = 1.0;
};
[[nodiscard]] Spread spread_of(std::span<const WeightedPoint> points);

/// Windows over the counts and what they are judged by.
struct WindowRule {
  std::int32_t size_cells = 60;
  std::int32_t stride_cells = 30;
  double max_ratio = 0.5;
  double min_weight = 20.0;
};

/// Window by window, parallels across the main spread of the counts, turned away from where the sensors stood. Returns
/// the cells of the windows that have such a direction; the rest is left to another provider.
[[nodiscard]] CellSet window_lines(std::span<const LineCell> cells, const GridGeometry& geometry,
                                   std::span<const DoiHistory::Sight> sights, const WindowRule& rule,
                                   const LineVisitor& visit);

}  // namespace echoarc::doi
