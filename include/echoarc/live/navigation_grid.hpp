// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>

#include "echoarc/core/arc.hpp"
#include "echoarc/mapping/evidence_grid.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::live {

/// The map that plans are made on: one block of cells that grows with the place, brought up to date where something
/// changed, so that a whole building costs no more than the robot's surroundings.
class NavigationGrid {
 public:
  explicit NavigationGrid(double cell_m) : cell_m_(cell_m) {}

  /// Makes room for a box of the world, with some to spare. False where that would be out of all proportion.
  bool cover(const Box& box);
  /// The cells of `box` as the evidence grid has them; occupied and free by its own thresholds. `cover` comes first.
  /// Its cells are those of this grid: same size, whole cells apart.
  void take(const EvidenceGrid& evidence, const Box& box);
  /// The cells of `points` are occupied, those of nothing that was heard unknown.
  void take(std::span<const Vec2> points);

  [[nodiscard]] const DenseGrid<CellState>& cells() const { return cells_; }
  /// Changes whenever a cell does.
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  double cell_m_;
  DenseGrid<CellState> cells_;
  std::uint64_t version_ = 0;
};

}  // namespace echoarc::live
