// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/vec2.hpp"

namespace echoarc::nav {

struct ObstacleOptions {
  Angle bin = degrees(2.0);
  Angle separation = degrees(30.0);
  double rise_m = 0.10;
  double link_m = 0.25;
  double near_m = 0.03;
  double reach_m = 6.0;

  static constexpr auto fields() {
    using O = ObstacleOptions;
    return std::tuple{
        field("bin_deg", &O::bin, {.unit = "deg", .min = 0.5, .max = 10.0, .doc = "of the profile over bearing"}),
        field("separation_deg", &O::separation,
              {.unit = "deg", .min = 5.0, .max = 120.0, .doc = "least, between the bearings of two obstacles"}),
        field("rise_m", &O::rise_m,
              {.unit = "m", .min = 0.01, .max = 5.0, .doc = "the profile rises so much between two obstacles"}),
        field("link_m", &O::link_m,
              {.unit = "m", .min = 0.01, .max = 5.0, .doc = "points so near to each other are of one obstacle"}),
        field("near_m", &O::near_m,
              {.unit = "m",
               .min = 0.001,
               .max = 0.5,
               .doc = "the closest place is the mean of points so little further"}),
        field("reach_m", &O::reach_m,
              {.unit = "m", .min = 0.5, .max = 100.0, .doc = "points further away are ignored"})};
  }
};

/// One obstacle C_i as it is seen from a place x: d_i(x) and the point of it that is closest, [Choset03] V.
struct NearObstacle {
  double distance_m = 0.0;  ///< from the place to `closest`, > 0
  Vec2 closest;             ///< c_i, world: mean of the points within `near_m` of the minimum
  Angle bearing;            ///< of `closest` from the place, world, in (-pi, pi]
};

/// The obstacles around a place (world, m), nearest first, from points of any order. Local minima of the distance over
/// bearing; two of them are different obstacles if their bearings differ by `separation` and the profile between them
/// rises by `rise_m`, or no chain of points with steps of `link_m` leads from one to the other. Gaps of the profile
/// shorter than `link_m` are bridged by a straight line. Points that are not finite, beyond the reach, or on the very
/// place are ignored. Deterministic; O(points) and a little.
[[nodiscard]] std::vector<NearObstacle> obstacle_distances(std::span<const Vec2> points, Vec2 place,
                                                           const ObstacleOptions& options = {});

/// Distance from the place to the nearest finite point; infinite without one.
[[nodiscard]] double clearance_m(std::span<const Vec2> points, Vec2 place);

}  // namespace echoarc::nav
