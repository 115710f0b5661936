// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/maps/point_map.hpp"

namespace echoarc {

/// What scores look at: positions in the world frame, every one finite. Made by the functions below alone, so that no
/// score has to ask again.
class PointSet {
 public:
  /// Points further from the world's origin than this are refused: they come from a broken log, and squares of larger
  /// numbers would cost the scores their digits.
  static constexpr double max_coordinate_m = 1e7;

  PointSet() = default;
  /// Exact points. Errors: a coordinate that is NaN, infinite or beyond `max_coordinate_m`.
  [[nodiscard]] static Result<PointSet> make(std::vector<Vec2> points);
  /// The points of a map, in the map's order. Errors as for `make`.
  [[nodiscard]] static Result<PointSet> of_points(const PointMap& map);
  /// The centres of the occupied cells, row by row from below. Errors: a geometry without a positive cell size, or one
  /// that puts a centre where `make` refuses it.
  [[nodiscard]] static Result<PointSet> of_occupied(const DenseGrid<CellState>& grid);
  /// Centres of cells of `cell_m` metres. Errors as for `make`, and a cell size that is not positive.
  [[nodiscard]] static Result<PointSet> of_cells(std::vector<Vec2> centres, double cell_m);

  [[nodiscard]] std::span<const Vec2> points() const { return points_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool empty() const { return points_.empty(); }
  /// Side of the cells whose centres these are; 0 for exact points.
  [[nodiscard]] double cell_m() const { return cell_m_; }

  /// The first point, in the order of the set, of every cell floor(p / cell_m). Where a method marks one wall a hundred
  /// times, the dense cluster no longer outvotes the rest of the map. Requires cell_m > 0.
  [[nodiscard]] PointSet one_per_cell(double cell_m) const;

 private:
  std::vector<Vec2> points_;
  double cell_m_ = 0.0;
};

}  // namespace echoarc
