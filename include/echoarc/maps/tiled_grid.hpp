// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "echoarc/core/bytes.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc {

inline constexpr std::int32_t tile_shift = 6;
inline constexpr std::int32_t tile_size = 1 << tile_shift;  ///< cells along one side of a tile

/// A grid that grows where it is written, in tiles of 64 x 64 cells, up to a stated amount of memory.
///
/// Tiles and their directory are counted against the limit; memory grows with the area touched. Iteration goes over the
/// tiles row by row, whatever the order in which they came to be. References to tiles stay valid while the grid grows.
/// Concurrent writes to different tiles are allowed; `ensure` is not concurrent with anything.
template <class T>
class TiledGrid {
 public:
  static constexpr std::size_t tile_cells = std::size_t{tile_size} * tile_size;
  /// Row-major; aligned so that a row starts a cache line.
  struct alignas(64) Tile : std::array<T, tile_cells> {};
  /// Column and row of a tile: cell index >> tile_shift.
  using TileIndex = Cell;

  TiledGrid(GridGeometry geometry, std::size_t memory_limit_bytes)
      : geometry_(geometry), memory_limit_bytes_(memory_limit_bytes) {}

  [[nodiscard]] const GridGeometry& geometry() const { return geometry_; }
  [[nodiscard]] std::size_t memory_limit_bytes() const { return memory_limit_bytes_; }
  [[nodiscard]] std::size_t memory_bytes() const {
    return tiles_.size() * sizeof(Tile) + directory_.size() * sizeof(std::int32_t);
  }
  [[nodiscard]] std::size_t tile_count() const { return tiles_.size(); }
  [[nodiscard]] std::int64_t touched_cells() const { return std::int64_t(tiles_.size()) * std::int64_t(tile_cells); }

  [[nodiscard]] static constexpr TileIndex tile_of(Cell c) { return {c.i >> tile_shift, c.j >> tile_shift}; }
  [[nodiscard]] static constexpr std::size_t offset_in_tile(Cell c) {
    return std::size_t(c.j & (tile_size - 1)) * tile_size + std::size_t(c.i & (tile_size - 1));
  }

  /// Makes one tile exist. False when the memory limit forbids it; the grid is then unchanged.
  [[nodiscard]] bool ensure(TileIndex t) {
    if (find(t) != nullptr) return true;
    const CellBox wanted = unite(tile_box_, {t.i, t.j, t.i + 1, t.j + 1});
    if (wanted != tile_box_ && !grow_directory(wanted)) return false;
    if (memory_bytes() + sizeof(Tile) > memory_limit_bytes_) return false;
    directory_[slot(t)] = static_cast<std::int32_t>(tiles_.size());
    tiles_.emplace_back();
    tiles_.back().fill(T{});
    return true;
  }
  /// Makes all tiles exist that meet the cells of `box`. False when the limit forbids it: all of them, or none is made.
  [[nodiscard]] bool ensure_cells(const CellBox& box);

  [[nodiscard]] Tile* find(TileIndex t) {
    if (!tile_box_.contains(t)) return nullptr;
    const std::int32_t k = directory_[slot(t)];
    return k < 0 ? nullptr : &tiles_[std::size_t(k)];
  }
  [[nodiscard]] const Tile* find(TileIndex t) const { return const_cast<TiledGrid*>(this)->find(t); }

  /// The value of a cell; T{} where nothing was written.
  [[nodiscard]] T value(Cell c) const {
    const Tile* tile = find(tile_of(c));
    return tile != nullptr ? (*tile)[offset_in_tile(c)] : T{};
  }
  /// A cell of an existing tile.
  [[nodiscard]] T& at(Cell c) {
    Tile* tile = find(tile_of(c));
    assert(tile != nullptr);
    return (*tile)[offset_in_tile(c)];
  }

  /// Calls `visit(TileIndex, const Tile&)` for every tile, row by row from below.
  template <class Visit>
  void for_each_tile(Visit&& visit) const {
    for (std::int32_t tj = tile_box_.j_begin; tj < tile_box_.j_end; ++tj)
      for (std::int32_t ti = tile_box_.i_begin; ti < tile_box_.i_end; ++ti)
        if (const Tile* tile = find({ti, tj})) visit(TileIndex{ti, tj}, *tile);
  }
  /// Calls `visit(Cell, const T&)` for every cell that differs from T{}, tile by tile.
  template <class Visit>
  void for_each_nonzero(Visit&& visit) const {
    for_each_tile([&](TileIndex t, const Tile& tile) {
      for (std::int32_t k = 0; k < std::int32_t(tile_cells); ++k)
        if (!(tile[std::size_t(k)] == T{}))
          visit(Cell{(t.i << tile_shift) + (k & (tile_size - 1)), (t.j << tile_shift) + (k >> tile_shift)},
                tile[std::size_t(k)]);
    });
  }

  /// Smallest box of cells that holds every value different from T{}.
  [[nodiscard]] CellBox bounds() const {
    CellBox box;
    for_each_nonzero([&](Cell c, const T&) { box = unite(box, {c.i, c.j, c.i + 1, c.j + 1}); });
    return box;
  }

  void save(ByteWriter& out) const;
  /// Replaces tiles and directory by what `save` wrote; false when the bytes are not such or exceed the memory limit.
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  [[nodiscard]] std::size_t slot(TileIndex t) const {
    return std::size_t(t.j - tile_box_.j_begin) * std::size_t(tile_box_.width()) + std::size_t(t.i - tile_box_.i_begin);
  }
  [[nodiscard]] bool grow_directory(const CellBox& wanted);

  GridGeometry geometry_;
  std::size_t memory_limit_bytes_;
  CellBox tile_box_;                     // in tiles
  std::vector<std::int32_t> directory_;  // row-major over tile_box_; -1: no tile
  std::deque<Tile> tiles_;
};

template <class T>
bool TiledGrid<T>::ensure_cells(const CellBox& box) {
  if (box.empty()) return true;
  const TileIndex low = tile_of({box.i_begin, box.j_begin});
  const TileIndex high = tile_of({box.i_end - 1, box.j_end - 1});
  const CellBox tiles{low.i, low.j, high.i + 1, high.j + 1};
  if (double(tiles.width()) * double(tiles.height()) > double(memory_limit_bytes_) / sizeof(Tile)) return false;
  const CellBox wanted = unite(tile_box_, tiles);
  if (wanted != tile_box_ && !grow_directory(wanted)) return false;
  std::size_t missing = 0;
  for (std::int32_t tj = tiles.j_begin; tj < tiles.j_end; ++tj)
    for (std::int32_t ti = tiles.i_begin; ti < tiles.i_end; ++ti) missing += find({ti, tj}) == nullptr ? 1 : 0;
  if (memory_bytes() + missing * sizeof(Tile) > memory_limit_bytes_) return false;
  for (std::int32_t tj = tiles.j_begin; tj < tiles.j_end; ++tj)
    for (std::int32_t ti = tiles.i_begin; ti < tiles.i_end; ++ti)
      if (!ensure({ti, tj})) return false;
  return true;
}

template <class T>
bool TiledGrid<T>::grow_directory(const CellBox& wanted) {
  // A lone reading far away costs a directory over all the space between; the limit counts it.
  const double slots = double(wanted.width()) * double(wanted.height());
  if (slots * sizeof(std::int32_t) + double(tiles_.size() * sizeof(Tile)) > double(memory_limit_bytes_)) return false;
  std::vector<std::int32_t> grown(std::size_t(wanted.width()) * std::size_t(wanted.height()), -1);
  for (std::int32_t tj = tile_box_.j_begin; tj < tile_box_.j_end; ++tj)
    for (std::int32_t ti = tile_box_.i_begin; ti < tile_box_.i_end; ++ti)
      grown[std::size_t(tj - wanted.j_begin) * std::size_t(wanted.width()) + std::size_t(ti - wanted.i_begin)] =
          directory_[slot({ti, tj})];
  directory_ = std::move(grown);
  tile_box_ = wanted;
  return true;
}

template <class T>
void TiledGrid<T>::save(ByteWriter& out) const {
  out.put(geometry_);
  out.put<std::uint64_t>(memory_limit_bytes_);
  out.put<std::uint64_t>(tiles_.size());
  for_each_tile([&](TileIndex t, const Tile& tile) {
    out.put(t);
    out.put_all(std::span<const T>(tile));
  });
}

template <class T>
bool TiledGrid<T>::restore(ByteReader& in) {
  const auto geometry = in.get<GridGeometry>();
  const auto memory_limit_bytes = in.get<std::uint64_t>();
  TiledGrid grid(geometry, memory_limit_bytes);
  const auto count = in.get<std::uint64_t>();
  constexpr std::int32_t farthest = GridGeometry::max_index >> tile_shift;
  constexpr CellBox reach{-farthest, -farthest, farthest, farthest};
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    const auto t = in.get<TileIndex>();
    if (!in.ok() || !reach.contains(t) || !grid.ensure(t) || !in.get_all(std::span<T>(*grid.find(t)))) return false;
  }
  if (!in.ok()) return false;
  *this = std::move(grid);
  return true;
}

/// The cells of `box` as a dense grid, each through `convert`.
template <class Out, class T, class Convert>
[[nodiscard]] DenseGrid<Out> to_dense(const TiledGrid<T>& grid, const CellBox& box, Convert&& convert) {
  GridGeometry geometry = grid.geometry();
  geometry.origin = geometry.corner({box.i_begin, box.j_begin});
  DenseGrid<Out> dense(geometry, std::int32_t(box.width()), std::int32_t(box.height()), convert(T{}));
  grid.for_each_nonzero([&](Cell c, const T& value) {
    if (box.contains(c)) dense.at({c.i - box.i_begin, c.j - box.j_begin}) = convert(value);
  });
  return dense;
}

}  // namespace echoarc
