// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <span>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::nav {

struct CorridorHeadingOptions {
  double line_m = 0.05;
  Angle step = degrees(0.5);
  int least_points = 20;
  double least_strength = 0.35;
  Angle largest_correction = degrees(15.0);
  int max_points = 2000;

  static constexpr auto fields() {
    using O = CorridorHeadingOptions;
    return std::tuple{
        field("line_m", &O::line_m, {.unit = "m", .min = 0.005, .max = 1.0, .doc = "width of a line of points"}),
        field("step_deg", &O::step,
              {.unit = "deg", .min = 0.05, .max = 10.0, .doc = "between directions that are tried"}),
        field("least_points", &O::least_points, {.min = 3, .max = 1e6, .doc = "fewer points have no direction"}),
        field("least_strength", &O::least_strength,
              {.min = 0.0, .max = 1.0, .doc = "how clearly the best direction must stand out; see WallDirection"}),
        field("largest_correction_deg", &O::largest_correction,
              {.unit = "deg", .min = 0.1, .max = 45.0, .doc = "corrections beyond this are not believed"}),
        field("max_points", &O::max_points, {.min = 3, .max = 1e6, .doc = "of more points every so-manyth is taken"})};
  }
};

/// The direction in which most points lie on lines, lines at a right angle to it included: that of a corridor, or of a
/// building.
struct WallDirection {
  Angle direction;        ///< in [0, 90) degrees
  double strength = 0.0;  ///< 1 - (lines as sharp in a middling direction) / (in this one): 0 without walls, up to 1
};

/// By the sharpest projections: for every direction the points are counted in strips of `line_m` along and across it;
/// the sum of the squared counts is greatest along walls (a Hough transform modulo a quarter turn). No value with too
/// few points or when no direction stands out. Points in any frame; those that are not finite are left out.
[[nodiscard]] std::optional<WallDirection> wall_direction(std::span<const Vec2> points,
                                                          const CorridorHeadingOptions& options = {});
/// The same of the occupied cells of a map.
[[nodiscard]] std::optional<WallDirection> wall_direction(const DenseGrid<CellState>& map,
                                                          const CorridorHeadingOptions& options = {});

/// The turn, in [-45, 45] degrees, that brings walls as now seen (by a heading that may be wrong) into the direction
/// that they have on the map. To be added to the heading.
[[nodiscard]] Angle turn_between(Angle seen, Angle on_map);

/// The correction of a heading by the walls around: `seen` are points near the robot, put into the map's frame by the
/// pose as it is believed. No value when no direction is clear or the correction is too large to be believed.
[[nodiscard]] std::optional<Angle> heading_correction(std::span<const Vec2> seen, const WallDirection& on_map,
                                                      const CorridorHeadingOptions& options = {});

}  // namespace echoarc::nav
