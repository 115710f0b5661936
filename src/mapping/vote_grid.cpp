// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/vote_grid.hpp"

#include <algorithm>
#include <limits>

#include "mapping/counted_arc.hpp"
#include "mapping/saved_state.hpp"
#include "mapping/vote_kernels.hpp"

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

bool VoteGrid::add_cells(std::span<const Cell> cells) {
  if (!find_tiles(cells)) return false;
  std::size_t k = 0;
  for (const Run& run : runs_)
    for (; k < run.end; ++k) {
      std::uint16_t& count = (*run.tile)[Counts::offset_in_tile(cells[k])];
      count = static_cast<std::uint16_t>(count + (count < std::numeric_limits<std::uint16_t>::max() ? 1 : 0));
    }
  return true;
}

/// Makes the tiles of a band exist; a branch is connected, so it meets all tiles between its outermost columns.
bool VoteGrid::find_band_tiles(Plan& plan, Band& band) {
  const ArcBranch& branch = plan.branches[band.branch];
  const std::size_t end = band.first + band.rows;
  std::int32_t low = std::min(branch.crossing[band.first], branch.crossing[end]);
  std::int32_t high = std::max(branch.crossing[band.first], branch.crossing[end]);
  if (const auto k = std::size_t(branch.outermost); branch.outermost >= 0 && k >= band.first && k < end) {
    low = std::min(low, branch.i_begin[k]);
    high = std::max(high, branch.i_end[k] - 1);
  }
  band.tile = plan.tiles.size();
  band.tile_i = low >> tile_shift;
  const std::int32_t j = (branch.j_first + std::int32_t(band.first)) >> tile_shift;
  for (std::int32_t i = band.tile_i; i <= high >> tile_shift; ++i) {
    Counts::Tile* tile = counts_.find({i, j});
    if (tile == nullptr && counts_.ensure({i, j})) tile = counts_.find({i, j});
    if (tile == nullptr) return false;
    plan.tiles.push_back(tile->data());
  }
  return true;
}

bool VoteGrid::find_bands(Plan& plan) {
  plan.bands.clear();
  plan.tiles.clear();
  std::size_t rows = 0;
  for (std::size_t b = 0; b < plan.branches.size(); ++b) {
    const ArcBranch& branch = plan.branches[b];
    rows += branch.i_begin.size();
    for (std::size_t k = 0; k < branch.i_begin.size(); k += plan.bands.back().rows) {
      const std::int32_t row = (branch.j_first + std::int32_t(k)) & (tile_size - 1);
      plan.bands.push_back({b, k, std::min(std::size_t(tile_size - row), branch.i_begin.size() - k)});
      if (!find_band_tiles(plan, plan.bands.back())) return false;
    }
  }
  if (plan.blocks.size() < rows) plan.blocks.resize(rows);
  return true;
}

/// Finds the cells of a planned arc and asks the memory for them, or counts them.
void VoteGrid::visit_bands(Plan& plan, bool count) {
  const kernels::VoteKernels& kernels = kernels::vote_kernels();
  std::uint16_t** blocks = plan.blocks.data();
  for (const Band& band : plan.bands) {
    const ArcBranch& branch = plan.branches[band.branch];
    const kernels::CountRows rows{.tiles = plan.tiles.data() + band.tile,
                                  .tiles_begin = std::uint32_t(band.tile_i * tile_size),
                                  .row = std::uint32_t(branch.j_first + std::int32_t(band.first)) % tile_size,
                                  .count = std::uint32_t(band.rows),
                                  .i_begin = branch.i_begin.data() + band.first,
                                  .i_end = branch.i_end.data() + band.first};
    if (count)
      kernels.count(rows, blocks);
    else
      kernels.find_blocks(rows, blocks);
    blocks += band.rows;
  }
}

bool VoteGrid::add(const Arc& arc) {
  if (!within_reach(arc, counts_.geometry(), counts_.memory_limit_bytes())) return false;
  Plan& plan = plans_[1 - taken_];
  plan.branches = plan.raster.branches(arc);
  if (plan.branches.empty()) return add_cells(plan.raster.cells(arc));
  if (!find_bands(plan)) return false;
  visit_bands(plan, false);
  settle();
  taken_ = 1 - taken_;
  return true;
}

void VoteGrid::settle() {
  visit_bands(plans_[taken_], true);
  plans_[taken_].bands.clear();
}

std::vector<CellChange> VoteGrid::changes(const Arc& arc) const {
  std::vector<CellChange> changes;
  if (!within_reach(arc, counts_.geometry(), counts_.memory_limit_bytes())) return changes;
  ArcRaster raster = plans_[0].raster;
  for (const Cell cell : raster.cells(arc)) {
    const double before = counts_.value(cell);
    const double after = std::min(before + 1.0, double(std::numeric_limits<std::uint16_t>::max()));
    changes.push_back({cell, counts_.geometry().centre(cell), before, after, {{"arcs", after, "arcs"}}});
  }
  return changes;
}

bool VoteGrid::crosses(const Arc& arc, Vec2 position) const {
  if (!within_reach(arc, counts_.geometry(), counts_.memory_limit_bytes())) return false;
  ArcRaster raster = plans_[0].raster;
  const std::span<const Cell> cells = raster.cells(arc);
  return std::ranges::find(cells, counts_.geometry().cell_of(position)) != cells.end();
}

bool VoteGrid::restore(ByteReader& in) {
  return restore_grid(in, counts_);
}

}  // namespace echoarc
