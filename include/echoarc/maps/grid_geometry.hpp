// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "echoarc/core/arc.hpp"

namespace echoarc {

/// Column i and row j of a grid; row 0 is the lowest. May be negative.
struct Cell {
  std::int32_t i = 0;
  std::int32_t j = 0;
  friend constexpr bool operator==(Cell, Cell) = default;
  /// Row by row from below, each row from the left: the order in which grids are iterated.
  friend constexpr bool operator<(Cell a, Cell b) { return a.j != b.j ? a.j < b.j : a.i < b.i; }
};

/// Cells i_begin <= i < i_end, j_begin <= j < j_end.
struct CellBox {
  std::int32_t i_begin = 0;
  std::int32_t j_begin = 0;
  std::int32_t i_end = 0;
  std::int32_t j_end = 0;

  [[nodiscard]] constexpr bool empty() const { return i_end <= i_begin || j_end <= j_begin; }
  [[nodiscard]] constexpr std::int64_t width() const { return std::int64_t{i_end} - i_begin; }
  [[nodiscard]] constexpr std::int64_t height() const { return std::int64_t{j_end} - j_begin; }
  [[nodiscard]] constexpr bool contains(Cell c) const {
    return c.i >= i_begin && c.i < i_end && c.j >= j_begin && c.j < j_end;
  }
  friend constexpr bool operator==(const CellBox&, const CellBox&) = default;
};

/// The smallest box that holds both.
[[nodiscard]] constexpr CellBox unite(const CellBox& a, const CellBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.i_begin, b.i_begin), std::min(a.j_begin, b.j_begin), std::max(a.i_end, b.i_end),
          std::max(a.j_end, b.j_end)};
}

/// Where the cells of a grid lie, apart from what they hold. Cell (i, j) is the half-open square
///
///     [origin.x + i h, origin.x + (i+1) h)  x  [origin.y + j h, origin.y + (j+1) h),   h = cell_m
///
///      j=1 |----|----|
///      j=0 |    |    |         a point on the left or lower edge belongs to the cell,
///   origin *----|----|         one on the right or upper edge to its neighbour
///           i=0  i=1
struct GridGeometry {
  double cell_m = 0.05;
  Vec2 origin;  ///< lower left corner of cell (0, 0), metres

  /// Cells further from the origin than this are out of reach; 2^29 cells of 1 cm are 5368 km.
  static constexpr std::int32_t max_index = 1 << 29;

  [[nodiscard]] Cell cell_of(Vec2 p) const {
    return {index((p.x - origin.x) / cell_m), index((p.y - origin.y) / cell_m)};
  }
  [[nodiscard]] Vec2 centre(Cell c) const { return {origin.x + (c.i + 0.5) * cell_m, origin.y + (c.j + 0.5) * cell_m}; }
  [[nodiscard]] Vec2 corner(Cell c) const { return {origin.x + c.i * cell_m, origin.y + c.j * cell_m}; }
  /// Cells that meet the box.
  [[nodiscard]] CellBox cells_of(const Box& box) const {
    const Cell low = cell_of(box.low);
    const Cell high = cell_of(box.high);
    return {low.i, low.j, high.i + 1, high.j + 1};
  }
  friend bool operator==(const GridGeometry&, const GridGeometry&) = default;

 private:
  static std::int32_t index(double cells) {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(cells), static_cast<double>(-max_index), static_cast<double>(max_index)));
  }
};

}  // namespace echoarc
