// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/vote_grid.hpp"

#include <algorithm>
#include <limits>

#include "mapping/counted_arc.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

/// Whether all cells lie in the tile of `first`.
bool in_tile_of(Cell first, std::span<const Cell> cells) {
  std::int32_t difference = 0;
  for (const Cell c : cells) difference |= (c.i ^ first.i) | (c.j ^ first.j);
  return (difference & ~(tile_size - 1)) == 0;
}

/// One past the last of the cells from `begin` on that lie in one tile.
std::size_t end_of_run(std::span<const Cell> cells, std::size_t begin) {
  constexpr std::size_t chunk = 16;  // tested at once, in vector code
  const Cell first = cells[begin];
  std::size_t end = begin + 1;
  while (end + chunk <= cells.size() && in_tile_of(first, cells.subspan(end, chunk))) end += chunk;
  while (end < cells.size() && in_tile_of(first, cells.subspan(end, 1))) ++end;
  return end;
}

}  // namespace

/// Splits the cells into runs inside one tile each and makes the tiles exist, so that counting looks no tile up.
bool VoteGrid::find_tiles(std::span<const Cell> cells) {
  runs_.clear();
  for (std::size_t begin = 0; begin < cells.size();) {
    const Cell tile = Counts::tile_of(cells[begin]);
    if (counts_.find(tile) == nullptr && !counts_.ensure(tile)) return false;
    const std::size_t end = end_of_run(cells, begin);
    runs_.push_back({counts_.find(tile), end});
    begin = end;
  }
  return true;
}

bool VoteGrid::add(const Arc& arc) {
  if (!within_reach(arc, counts_.geometry(), counts_.memory_limit_bytes())) return false;
  const std::span<const Cell> cells = raster_.cells(arc);
  if (!find_tiles(cells)) return false;
  std::size_t k = 0;
  for (const Run& run : runs_)
    for (; k < run.end; ++k) {
      std::uint16_t& count = (*run.tile)[Counts::offset_in_tile(cells[k])];
      count = static_cast<std::uint16_t>(count + (count < std::numeric_limits<std::uint16_t>::max() ? 1 : 0));
    }
  return true;
}

std::vector<CellChange> VoteGrid::changes(const Arc& arc) const {
  std::vector<CellChange> changes;
  if (!within_reach(arc, counts_.geometry(), counts_.memory_limit_bytes())) return changes;
  ArcRaster raster = raster_;
  for (const Cell cell : raster.cells(arc)) {
    const double before = counts_.value(cell);
    const double after = std::min(before + 1.0, double(std::numeric_limits<std::uint16_t>::max()));
    changes.push_back({cell, counts_.geometry().centre(cell), before, after, {{"arcs", after, "arcs"}}});
  }
  return changes;
}

bool VoteGrid::crosses(const Arc& arc, Vec2 position) const {
  if (!within_reach(arc, counts_.geometry(), counts_.memory_limit_bytes())) return false;
  ArcRaster raster = raster_;
  const std::span<const Cell> cells = raster.cells(arc);
  return std::ranges::find(cells, counts_.geometry().cell_of(position)) != cells.end();
}

bool VoteGrid::restore(ByteReader& in) {
  return restore_grid(in, counts_);
}

}  // namespace echoarc
