// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::sim {

/// The table `[office]` of a scene: a floor of corridors and rooms, of any size.
struct OfficeFloorOptions {
  double area_m2 = 5200.0;
  double corridor_m = 2.0;
  double door_m = 0.9;
  double wall_m = 0.12;
  double room_depth_m = 6.0;
  double room_width_m = 5.0;
  double block_m = 25.0;
  double rough_share = 0.5;
  double visited_share = 0.2;
  int seed = 1;

  static constexpr auto fields() {
    using O = OfficeFloorOptions;
    return std::tuple{
        field(
            "area_m2", &O::area_m2,
            {.unit = "m^2", .min = 100.0, .max = 1e7, .doc = "of the whole floor, at least", .source = "[Silver04] 5"}),
        field("corridor_m", &O::corridor_m, {.unit = "m", .min = 1.0, .max = 10.0, .doc = "width of the corridors"}),
        field("door_m", &O::door_m, {.unit = "m", .min = 0.6, .max = 5.0, .doc = "width of the doors, which are open"}),
        field("wall_m", &O::wall_m,
              {.unit = "m", .min = 0.02, .max = 1.0, .doc = "thickness of the walls, and so depth of the jambs"}),
        field("room_depth_m", &O::room_depth_m,
              {.unit = "m", .min = 2.0, .max = 50.0, .doc = "of the rooms, from the corridor's side to the back"}),
        field("room_width_m", &O::room_width_m,
              {.unit = "m", .min = 2.0, .max = 50.0, .doc = "of the rooms along the corridor, on average"}),
        field("block_m", &O::block_m,
              {.unit = "m", .min = 5.0, .max = 500.0, .doc = "distance between two cross corridors, about"}),
        field("rough_share", &O::rough_share,
              {.min = 0.0, .max = 1.0, .doc = "of walls that are rough; the others are smooth"}),
        field("visited_share", &O::visited_share,
              {.min = 0.0, .max = 1.0, .doc = "of rooms that the tour enters; it goes through every corridor"}),
        field("seed", &O::seed,
              {.min = 0, .max = 2'000'000'000, .doc = "of widths, doors, surfaces and rooms to enter"})};
  }
};

/// Surfaces, and a drive that sees all of it.
struct OfficeFloor {
  std::vector<Wall> walls;
  Pose2 start;
  std::vector<DriveLeg> tour;
  double area_m2 = 0.0;
  std::size_t rooms = 0;
  std::size_t visited_rooms = 0;
};

/// Parallel corridors with rooms on both sides, joined by cross corridors; every room has a door to a corridor, every
/// wall two faces and its doors jambs. The tour follows the middle of every corridor and of the doors of the chosen
/// rooms. The same options give the same floor.
///
/// Coordinates from 0 up. `smooth` and `rough` are the materials of the walls. Errors: options out of range, doors
/// wider than their rooms allow, corridors narrower than doors, more than World::max_walls walls.
[[nodiscard]] Result<OfficeFloor> make_office_floor(const OfficeFloorOptions& options, MaterialId smooth,
                                                    MaterialId rough);

}  // namespace echoarc::sim
