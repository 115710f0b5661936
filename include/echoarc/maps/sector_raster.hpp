// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// Cells i_begin <= i < i_end of row j.
struct RowSpan {
  std::int32_t j = 0;
  std::int32_t i_begin = 0;
  std::int32_t i_end = 0;
  friend constexpr bool operator==(RowSpan, RowSpan) = default;
};

/// Consecutive rows: begin[k] <= i < end[k] of row j_first + k; some may be empty, end[k] <= begin[k].
struct SectorColumns {
  std::int32_t j_first = 0;
  std::span<const std::int32_t> begin;
  std::span<const std::int32_t> end;
};

/// Turns sectors into row spans: each row of cells meets a sector in one interval, found from the two edges of the
/// wedge and the rim, with no test per cell. Keeps scratch memory between calls: use one raster per thread.
class SectorRaster {
 public:
  explicit SectorRaster(GridGeometry geometry) : geometry_(geometry) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  /// The cells whose centre lies in the closed sector under \p rim: half path at most `rim.range_m()`, bearing from
  /// `rim.centre()` within half a beam of the axis. A cell centre on the apex itself is left out. Rows from below, none
  /// empty; the span is valid until the next call. Requires a beam below 180 degrees.
  [[nodiscard]] std::span<const RowSpan> spans(const Arc& rim);
  /// The same cells as arrays over all rows between the lowest and the highest, for code that goes on in vectors.
  [[nodiscard]] SectorColumns columns(const Arc& rim);

 private:
  GridGeometry geometry_;
  std::vector<RowSpan> spans_;
  std::vector<std::int32_t> begin_, end_;
};

}  // namespace echoarc
