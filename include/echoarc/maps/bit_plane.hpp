// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

/// A rectangle of cells that are set or not, one bit each: 64 cells of a row in a word. Between rows, below the first
/// and above the last one lie words that stay zero, so that neighbours outside count as not set.
class BitPlane {
 public:
  /// Cells 0 <= i < width, 0 <= j < height, none set.
  BitPlane(std::int32_t width, std::int32_t height);

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  [[nodiscard]] CellBox box() const { return {0, 0, width_, height_}; }
  [[nodiscard]] bool at(Cell c) const { return (words_[word(c)] >> (c.i & 63) & 1U) != 0; }
  void set(Cell c, bool value = true) {
    const std::uint64_t bit = std::uint64_t{1} << (c.i & 63);
    std::uint64_t& here = words_[word(c)];
    here = value ? here | bit : here & ~bit;
  }
  [[nodiscard]] std::int64_t count() const;

  /// Thinning with parameter m ([Barshan07] 3.4): what is left of the set cells when those with fewer than \p m set
  /// cells among their eight neighbours are taken away, all at once. m = 0 changes nothing, 1 prunes single cells, 8
  /// erodes. Requires 0 <= m <= 8.
  [[nodiscard]] BitPlane thinned(int m) const;
  /// The same into a plane of equal size, without allocating.
  void thin_into(int m, BitPlane& out) const;
  /// 3 x 3 box: cells that are set or have a set neighbour.
  [[nodiscard]] BitPlane dilated() const;
  /// 3 x 3 box: set cells all of whose neighbours are set; cells at the border have neighbours outside, which are not.
  [[nodiscard]] BitPlane eroded() const { return thinned(8); }
  /// Eroded, then dilated: drops what is narrower than three cells.
  [[nodiscard]] BitPlane opened() const { return eroded().dilated(); }
  /// Dilated, then eroded: fills what is narrower than three cells, as if the plane had a wider border of unset cells.
  [[nodiscard]] BitPlane closed() const;

  friend bool operator==(const BitPlane&, const BitPlane&) = default;

 private:
  [[nodiscard]] std::size_t word(Cell c) const {
    assert(box().contains(c));
    return (std::size_t(c.j) + 1) * stride_ + 1 + std::size_t(c.i >> 6);
  }
  void clear_outside();

  std::int32_t width_;
  std::int32_t height_;
  std::size_t stride_;  // words of a row and one that stays zero, after it and before the next
  std::vector<std::uint64_t> words_;
};

}  // namespace echoarc
