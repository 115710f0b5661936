// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <span>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose2.hpp"

namespace echoarc::nav {

/// +1 for a wall on the left, -1 for one on the right.
[[nodiscard]] constexpr double sign_of(WallSide side) {
  return side == WallSide::right ? -1.0 : 1.0;
}

/// The nearest of the points around a robot, by sectors of bearing as seen along its heading. Infinity: none.
struct SectorMinima {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double front_m = none;       ///< within 30 degrees of the heading
  double front_side_m = none;  ///< 30 to 60 degrees towards the wall
  double side_m = none;        ///< 60 to 120 degrees towards the wall
  double other_side_m = none;  ///< 60 to 120 degrees away from it
  Vec2 front_side_point;       ///< the one `front_side_m` tells of, world, m
  Vec2 side_point;             ///< the one `side_m` tells of, world, m
};
[[nodiscard]] SectorMinima sector_minima(const Pose2& T_world_base, WallSide side, std::span<const Vec2> points);

/// The point nearest to `position`; points that are no numbers are passed over.
[[nodiscard]] std::optional<Vec2> nearest_of(Vec2 position, std::span<const Vec2> points);

/// The direction along a line through `points` (total least squares), the one of both that is nearer to `along`; none:
/// fewer than three points, or they spread over less than `least_spread_m`, or lie off it by more than `most_off_m`
/// (root mean square).
[[nodiscard]] std::optional<Angle> line_along(std::span<const Vec2> points, Angle along, double least_spread_m,
                                              double most_off_m);

/// The last points of a wall that were abreast of a robot, and the line through them.
class SideWall {
 public:
  /// Takes the newest point; one far from the last begins another wall.
  void add(Vec2 point);
  void clear() { points_.clear(); }
  /// The wall's direction, the one of both that is nearer to `heading`; none: too few points yet, or no line.
  [[nodiscard]] std::optional<Angle> direction(Angle heading) const;

 private:
  std::deque<Vec2> points_;  // over half a metre at the most
};

}  // namespace echoarc::nav
