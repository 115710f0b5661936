// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::studies {

/// The floor that a robot can get to in a world that stands still: whatever a disc of its size can lie on that is moved
/// about from where it starts.
class ReachableFloor {
 public:
  /// Cells are `cell_m` wide. Nothing is reachable from a start that touches a wall.
  ReachableFloor(const sim::WorldDescription& world, Vec2 start, double robot_radius_m, double cell_m = 0.1);

  [[nodiscard]] double area_m2() const;
  /// The part of it that `map` shows free, 0 to 1; cells are compared by their centres. 0 where nothing is reachable.
  [[nodiscard]] double covered(const DenseGrid<CellState>& map) const;
  [[nodiscard]] bool contains(Vec2 place) const;

 private:
  DenseGrid<std::uint8_t> cells_;  // 1: reachable
  std::uint64_t count_ = 0;
};

}  // namespace echoarc::studies
