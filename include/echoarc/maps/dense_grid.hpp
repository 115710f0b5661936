// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

enum class CellState : std::uint8_t { unknown, free, occupied };

/// A rectangle of cells with all values in one block, row-major, row 0 lowest: what is drawn, written and scored.
/// `geometry().origin` is the lower left corner of cell (0, 0).
template <class T>
class DenseGrid {
 public:
  DenseGrid() = default;
  DenseGrid(GridGeometry geometry, std::int32_t width, std::int32_t height, T fill = T{})
      : geometry_(geometry), width_(width), height_(height), values_(std::size_t(width) * std::size_t(height), fill) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  [[nodiscard]] CellBox box() const { return {0, 0, width_, height_}; }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] T& at(Cell c) { return values_[index(c)]; }
  [[nodiscard]] const T& at(Cell c) const { return values_[index(c)]; }
  [[nodiscard]] std::span<const T> row(std::int32_t j) const {
    return std::span<const T>(values_).subspan(index({0, j}), std::size_t(width_));
  }
  [[nodiscard]] std::span<T> values() { return values_; }
  [[nodiscard]] std::span<const T> values() const { return values_; }

 private:
  [[nodiscard]] std::size_t index(Cell c) const {
    assert(box().contains(c));
    return std::size_t(c.j) * std::size_t(width_) + std::size_t(c.i);
  }

  GridGeometry geometry_;
  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  std::vector<T> values_;
};

}  // namespace echoarc
