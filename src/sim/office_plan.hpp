// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "echoarc/sim/office_floor.hpp"

namespace echoarc::sim {

/// A way from a corridor into a room.
struct OfficeDoor {
  Vec2 outside;  ///< in the middle of the corridor, before the door
  Vec2 inside;   ///< in the room, behind it
  bool visited = false;
};

/// The corridors of an office floor as a lattice: columns are cross corridors, rows the corridors with doors.
struct OfficePlan {
  std::vector<double> column_x;  ///< middles of the cross corridors, from left to right
  std::vector<double> row_y;     ///< middles of the corridors with doors, from below
  /// Doors of the stretch between columns i and i + 1 of row j, at [j * (columns - 1) + i], from left to right.
  std::vector<std::vector<OfficeDoor>> doors;

  [[nodiscard]] std::vector<OfficeDoor>& doors_of(std::size_t row, std::size_t stretch) {
    return doors[row * (column_x.size() - 1) + stretch];
  }
  [[nodiscard]] const std::vector<OfficeDoor>& doors_of(std::size_t row, std::size_t stretch) const {
    return doors[row * (column_x.size() - 1) + stretch];
  }
};

/// The points of a drive through every corridor and into every room to visit, from the lower left crossing; straight
/// lines between them keep to the middle of corridors and doors.
[[nodiscard]] std::vector<Vec2> office_tour(const OfficePlan& plan);

}  // namespace echoarc::sim
