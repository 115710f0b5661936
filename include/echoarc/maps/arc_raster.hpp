// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// How the cells of an arc are found.
enum class ArcSampling {
  sampled,  ///< steps of at most half a cell along the arc: no gaps, may miss a corner clipped by less than half a cell
  exact,    ///< every cell the arc meets in a piece of positive length
};

/// A piece of an arc that rises or falls all the way, so that it crosses each of its rows once, in one run of cells.
struct ArcBranch {
  std::int32_t j_first = 0;  ///< the lowest row
  bool rising = true;        ///< in the direction of growing t
  /// Columns i_begin[k] <= i < i_end[k] of row j_first + k; none where another branch has them all.
  std::span<const std::int32_t> i_begin;
  std::span<const std::int32_t> i_end;
  /// The column in which the branch meets the lower edge of row k; the first and the last one hold its ends.
  std::span<const std::int32_t> crossing;
  /// The row in which the branch turns back in its columns; -1 where it does not. From there to either end its columns
  /// only rise or only fall.
  std::int32_t outermost = -1;
};

/// Turns arcs into cells. Keeps scratch memory between calls: use one raster per thread.
class ArcRaster {
 public:
  explicit ArcRaster(GridGeometry geometry, ArcSampling sampling = ArcSampling::exact)
      : geometry_(geometry), sampling_(sampling) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  /// The cells the arc crosses between its limits, each once, in the order in which the arc first enters them. The span
  /// is valid until the next call.
  [[nodiscard]] std::span<const Cell> cells(const Arc& arc);
  /// The same cells row by row, each in one branch, found without a test per cell: `exact` only, and only for arcs
  /// whose radius of curvature is 8 cells and more. None for other arcs; ask for their `cells`. Valid until the next
  /// call.
  [[nodiscard]] std::span<const ArcBranch> branches(const Arc& arc);

 private:
  [[nodiscard]] std::span<const Cell> cells_of_branches(std::span<const ArcBranch> branches);

  GridGeometry geometry_;
  ArcSampling sampling_;
  std::vector<Cell> cells_;
  std::vector<std::uint64_t> samples_;
  std::vector<double> crossings_;
  std::vector<std::int32_t> columns_;
  std::array<ArcBranch, 2> branches_;
};

}  // namespace echoarc
