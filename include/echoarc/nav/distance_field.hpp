// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::nav {

/// From the centre of each cell to the centre of the nearest occupied cell, m; infinity where nothing is occupied.
/// Exact: lower envelopes of parabolas, row by row, over the distances along columns ([Felzenszwalb12] section 2).
[[nodiscard]] DenseGrid<float> distance_field(const DenseGrid<CellState>& map);

/// The same up to a distance beyond which it does not matter, kept current where the map changes: a change reaches no
/// further than that distance, so the rest need not be looked at.
class CappedDistanceField {
 public:
  explicit CappedDistanceField(double cap_m = 1.0) : cap_m_(cap_m) {}

  [[nodiscard]] double cap_m() const { return cap_m_; }
  /// Anew, of a map of any geometry.
  void reset(const DenseGrid<CellState>& map);
  /// After cells of `changed` changed in a map of the same geometry. Gives the box of cells whose distance may differ.
  CellBox update(const DenseGrid<CellState>& map, const CellBox& changed);
  /// m, at the most `cap_m()`.
  [[nodiscard]] const DenseGrid<float>& distances_m() const { return distances_m_; }

 private:
  void compute(const DenseGrid<CellState>& map, const CellBox& box);
  [[nodiscard]] std::int32_t reach_cells() const;

  double cap_m_;
  DenseGrid<float> distances_m_;
  std::vector<std::int32_t> columns_;  // scratch: distance along the column, cells, of the window under work
  std::vector<std::int64_t> row_;      // scratch: squared distance, cells, of one row
};

}  // namespace echoarc::nav
