// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "echoarc/maps/grid_geometry.hpp"
#include "echoarc/maps/tiled_grid.hpp"

namespace echoarc {

/// Cells that are set or not, over the tiles of a `TiledGrid`: a row of a tile is one word of 64 bits. Cells of other
/// tiles are not set.
class TiledBits {
 public:
  /// Word j holds row j of the tile, cell i in bit i.
  using Words = std::array<std::uint64_t, tile_size>;

  TiledBits() = default;
  /// Sets the cells for which `holds(value)` is true. `holds(T{})` has to be false.
  template <class T, class Holds>
  TiledBits(const TiledGrid<T>& grid, Holds&& holds) {
    grid.for_each_tile([&](Cell tile, const typename TiledGrid<T>::Tile& values) {
      tiles_.push_back(tile);
      words_.push_back(bits_of(values, holds));
    });
  }

  [[nodiscard]] bool at(Cell c) const {
    const Words* words = find(TiledGrid<char>::tile_of(c));
    return words != nullptr && ((*words)[std::size_t(c.j & (tile_size - 1))] >> (c.i & (tile_size - 1)) & 1U) != 0;
  }
  [[nodiscard]] std::int64_t count() const;
  [[nodiscard]] std::size_t tile_count() const { return tiles_.size(); }
  /// As `BitPlane::thinned`, over all tiles. Never sets a cell.
  [[nodiscard]] TiledBits thinned(int m) const;

  friend bool operator==(const TiledBits&, const TiledBits&) = default;

 private:
  template <class Tile, class Holds>
  [[nodiscard]] static Words bits_of(const Tile& values, Holds&& holds) {
    Words words{};
    for (std::size_t j = 0; j < tile_size; ++j)
      for (std::size_t i = 0; i < tile_size; ++i)
        words[j] |= (holds(values[j * tile_size + i]) ? std::uint64_t{1} : std::uint64_t{0}) << i;
    return words;
  }
  [[nodiscard]] const Words* find(Cell tile) const;

  std::vector<Cell> tiles_;  // row by row, each from the left
  std::vector<Words> words_;
};

}  // namespace echoarc
