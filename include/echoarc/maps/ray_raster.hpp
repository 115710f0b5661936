// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/maps/grid_geometry.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

/// Which blocks of 8 x 8 cells matter: one word for every tile of 64 x 64 cells that meets a box.
class BlockMask {
 public:
  static constexpr std::int32_t block_size = 8;

  BlockMask() = default;
  explicit BlockMask(const CellBox& box);

  /// Marks the block of a cell of the box.
  void mark(Cell c) { words_[word(c)] |= bit(c); }
  /// Whether the block of a cell is marked; false outside the box.
  [[nodiscard]] bool holds(Cell c) const {
    return tiles_.contains({c.i >> tile_shift, c.j >> tile_shift}) && (words_[word(c)] & bit(c)) != 0;
  }

 private:
  [[nodiscard]] std::size_t word(Cell c) const {
    return std::size_t((c.j >> tile_shift) - tiles_.j_begin) * std::size_t(tiles_.width()) +
           std::size_t((c.i >> tile_shift) - tiles_.i_begin);
  }
  [[nodiscard]] static std::uint64_t bit(Cell c) {
    return std::uint64_t{1} << ((std::uint32_t(c.j) >> 3 & 7U) * 8 + (std::uint32_t(c.i) >> 3 & 7U));
  }

  CellBox tiles_;
  std::vector<std::uint64_t> words_;  // row-major over tiles_
};

/// Turns rays into cells by stepping from grid line to grid line (Amanatides, Woo 1987), as a supercover: where a ray
/// passes exactly through a corner, both cells beside the corner are visited too, so no ray slips through a diagonal
/// wall. Keeps scratch memory between calls: use one raster per thread.
class RayRaster {
 public:
  explicit RayRaster(GridGeometry geometry) : geometry_(geometry) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  /// The cells of \p within that the segment from \p origin over \p length_m along the unit vector \p direction visits,
  /// in the order in which it visits them. A ray along a cell edge belongs to the cells that own the edge. The span is
  /// valid until the next call. With \p blocks, cells of other blocks may be left out.
  [[nodiscard]] std::span<const Cell> cells(Vec2 origin, Vec2 direction, double length_m, const CellBox& within,
                                            const BlockMask* blocks = nullptr);

 private:
  GridGeometry geometry_;
  std::vector<Cell> cells_;
};

}  // namespace echoarc
