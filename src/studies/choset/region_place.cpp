// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/choset/region_place.hpp"

#include <limits>

namespace echoarc::studies::choset {

RegionPlace place_of(const DepthRegion& region, const sim::World& world) {
  if (world.clearance(region.echo_point(), surface_m) < surface_m) return RegionPlace::on_surface;
  const auto hit = world.first_hit(region.position, region.normal(), region.depth_m);
  return hit ? RegionPlace::beyond : RegionPlace::before;
}

std::vector<DepthReturn> depth_returns(std::span<const Reading> readings) {
  std::vector<DepthReturn> returns;
  for (const Reading& reading : readings) {
    DepthReturn heard{reading.T_world_tx.heading, std::numeric_limits<double>::infinity(), reading.ping};
    if (const auto range_m = echo_range_m(reading.outcome)) {
      const Vec2 middle = reading.T_world_tx * Vec2{*range_m, 0.0} - reading.T_world_robot.position;
      heard.bearing = bearing(middle);
      heard.depth_m = norm(middle);
    }
    returns.push_back(heard);
  }
  return returns;
}

}  // namespace echoarc::studies::choset
