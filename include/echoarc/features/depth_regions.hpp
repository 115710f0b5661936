// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/reading.hpp"

/// Regions of constant depth ([Choset03] II-C, after Leonard): runs of neighbouring returns with nearly the same range
/// out of one rotation in place come from one echo point.
namespace echoarc {

struct DepthRegionOptions {
  double depth_m = 0.03;
  Angle extent_min = degrees(10.0);
  int readings_min = 4;
  Angle gap = degrees(25.0);
  double range_max_m = 5.0;
  double stop_m = 0.02;
  double point_m = 0.15;
  double line_m = 0.05;
  Angle line_turn = degrees(10.0);
  int positions_min = 3;
  double vote_ratio = 2.0;
  Angle edge_extent = degrees(15.0);

  static constexpr auto fields() {
    using O = DepthRegionOptions;
    return std::tuple{
        field("depth_m", &O::depth_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "a return this near the mean of a run belongs to it"}),
        field("extent_min_deg", &O::extent_min,
              {.unit = "deg", .min = 0.0, .max = 360.0, .doc = "narrower runs are no regions"}),
        field("readings_min", &O::readings_min,
              {.unit = "readings", .min = 1, .max = 1000000, .doc = "nor are runs of fewer readings"}),
        field("gap_deg", &O::gap,
              {.unit = "deg", .min = 0.0, .max = 360.0, .doc = "returns farther apart are no neighbours"}),
        field("range_max_m", &O::range_max_m,
              {.unit = "m", .min = 0.0, .max = 1000.0, .doc = "farther echoes are left out"}),
        field("stop_m", &O::stop_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "the robot has turned in place if it moved no farther"}),
        field("point_m", &O::point_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "echo points this close are one landmark"}),
        field("line_m", &O::line_m,
              {.unit = "m", .min = 0.0, .max = 10.0, .doc = "so are regions whose common line fits this well"}),
        field("line_turn_deg", &O::line_turn,
              {.unit = "deg", .min = 0.0, .max = 180.0, .doc = "and whose normals differ by less"}),
        field("positions_min", &O::positions_min,
              {.unit = "positions", .min = 3, .max = 1000, .doc = "a landmark seen from fewer is not told apart"}),
        field("vote_ratio", &O::vote_ratio,
              {.min = 1.0, .max = 1000.0, .doc = "wall or point: the better fit leaves this many times less over"}),
        field("edge_extent_deg", &O::edge_extent,
              {.unit = "deg", .min = 0.0, .max = 360.0, .doc = "without walls: points seen over less are edges"})};
  }
};

/// One return of a sweep, seen from the middle of the robot: bearing and distance of the middle of its arc. Silence has
/// an infinite depth.
struct DepthReturn {
  Angle bearing;
  double depth_m = std::numeric_limits<double>::infinity();
  PingId ping = 0;
};

/// A run of returns with nearly the same depth.
struct DepthRegion {
  Vec2 position;  ///< of the robot, world
  double depth_m = 0.0;
  Angle bearing;  ///< of the middle of the run
  Angle extent;   ///< from its first return to its last
  std::vector<PingId> pings;

  [[nodiscard]] Vec2 normal() const { return unit(bearing); }
  [[nodiscard]] Vec2 echo_point() const { return position + depth_m * normal(); }
};

/// The regions of one sweep from `position`. Returns in any order.
[[nodiscard]] std::vector<DepthRegion> depth_regions(Vec2 position, std::vector<DepthReturn> returns,
                                                     const DepthRegionOptions& options = {});

}  // namespace echoarc
