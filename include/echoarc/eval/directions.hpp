// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/eval/point_set.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// Adjacent parallel lines along which a person, or a robot, asks "is something there?": directions of interest
/// ([Barshan07] 3.3). Line k is the strip
///
///     k width <= (p - corner) . across < (k+1) width,   (p - corner) . along >= 0
///
///       along ^   |   |   |   |
///             |   | 0 | 1 | 2 |
///      corner *---+---+---+---+--> across
struct LineFamily {
  Vec2 corner;
  Vec2 along{0.0, 1.0};   ///< unit vector, away from the robot
  Vec2 across{1.0, 0.0};  ///< unit vector at right angles to `along`
  double width_m = 0.01;
  std::int32_t count = 0;
};

/// Adjacent rays that fan out from a point. Ray k is the wedge
///
///     k step <= bearing(p - centre) - first < (k+1) step,   0 < |p - centre|
///
/// with the difference of bearings taken in [0, 2 pi).
struct RayFamily {
  Vec2 centre;
  Angle first;  ///< lower edge of ray 0
  Angle step = degrees(0.25);
  std::int32_t count = 0;  ///< count times step is at most a full turn
};

/// All directions in which a map is judged. Families may cross: a point counts on every line and ray it lies on.
struct DirectionSet {
  /// Only points inside count, its upper edges left out: the border of the grid.
  Box region{{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()},
             {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
  std::vector<LineFamily> families;
  std::vector<RayFamily> fans;

  /// Lines and rays.
  [[nodiscard]] std::int64_t line_count() const;
};

inline constexpr std::int64_t max_direction_lines = 10'000'000;
/// Errors: vectors that are not finite, not of unit length or not at right angles, a width or step that is not
/// positive, a negative count, rays that go round more than once, more than `max_direction_lines` in all.
[[nodiscard]] Result<void> validate(const DirectionSet& directions);

/// One line per column of the cells (0, 0) to (columns - 1, rows - 1), looking along +y. Points fall on the lines
/// exactly as they fall into cells.
[[nodiscard]] DirectionSet column_directions(const GridGeometry& geometry, std::int32_t columns, std::int32_t rows);
/// One line per row of the same cells, looking along +x.
[[nodiscard]] DirectionSet row_directions(const GridGeometry& geometry, std::int32_t columns, std::int32_t rows);
/// Lines parallel to `along` that cover `region`; the middle of one of them passes through `origin`. Requires a finite
/// region and width_m > 0.
[[nodiscard]] DirectionSet axis_directions(const Box& region, Vec2 origin, Angle along, double width_m);

/// Rays all around `centre`, or as many as there are between two bearings, counter-clockwise from `first` to `last`;
/// the step is made a little smaller where the angle is no multiple of it. Requires step > 0.
[[nodiscard]] DirectionSet polar_directions(const Box& region, Vec2 centre, Angle step, Angle first = degrees(0.0),
                                            Angle last = degrees(360.0));

/// The side of a wall that a robot has in front of it, walls of a room going counter-clockwise: the inside is on the
/// left of begin -> end. A doorway is part of the span; its lines ought to be empty.
struct WallSpan {
  Vec2 begin;
  Vec2 end;
  double depth_m =
      0.0;  ///< distance from the wall to the interior reference line (the robot's path), where lines start
};

/// Lines of `width_m` at right angles to each wall span, from the interior reference line outward to the border of
/// `region`; a span shorter than half a line gives none.
[[nodiscard]] DirectionSet wall_directions(std::span<const WallSpan> walls, const Box& region, double width_m = 0.01);

}  // namespace echoarc
