// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/doi/lines.hpp"

#include <algorithm>
#include <utility>

#include "echoarc/mapping/directional_maximum.hpp"
#include "mapping/doi/sort_by_key.hpp"

namespace echoarc::doi {
namespace {

/// The cells of all tiles.
CellBox touched_box(const VoteGrid::Counts& counts) {
  CellBox box;
  counts.for_each_tile([&](Cell tile, const VoteGrid::Counts::Tile&) {
    const Cell low{tile.i << tile_shift, tile.j << tile_shift};
    box = unite(box, {low.i, low.j, low.i + tile_size, low.j + tile_size});
  });
  return box;
}

template <std::size_t n>
bool any_reaches(std::span<const std::uint16_t, n> counts, int threshold) {
  const auto below = static_cast<std::uint16_t>(std::clamp(threshold - 1, 0, 65535));
  std::uint16_t above = 0;
  for (const std::uint16_t count : counts) above |= static_cast<std::uint16_t>(count > below ? count - below : 0);
  return above != 0 || threshold <= 0;
}

}  // namespace

std::vector<LineCell> cells_at_threshold(const VoteGrid::Counts& counts, int threshold) {
  std::vector<LineCell> cells;
  constexpr std::size_t chunk = 32;  // tested at once, in vector code: most of a map is below the threshold
  counts.for_each_tile([&](Cell tile, const VoteGrid::Counts::Tile& values) {
    for (std::size_t begin = 0; begin < values.size(); begin += chunk) {
      if (!any_reaches(std::span(values).subspan(begin).first<chunk>(), threshold)) continue;
      for (auto k = std::int32_t(begin); k < std::int32_t(begin + chunk); ++k)
        if (values[std::size_t(k)] >= threshold)
          cells.push_back({{(tile.i << tile_shift) + (k & (tile_size - 1)), (tile.j << tile_shift) + (k >> tile_shift)},
                           values[std::size_t(k)]});
    }
  });
  return cells;
}

RayLines::RayLines(const VoteGrid::Counts& counts, int threshold)
    : RayLines(counts, threshold, cells_at_threshold(counts, threshold)) {}

RayLines::RayLines(const VoteGrid::Counts& counts, int threshold, std::span<const LineCell> wanted)
    : counts_(counts),
      threshold_(threshold),
      within_(touched_box(counts)),
      blocks_(within_),
      raster_(counts.geometry()) {
  for (const LineCell& c : wanted) blocks_.mark(c.cell);
}

std::span<const LineCell> RayLines::along(Vec2 origin, Vec2 direction, double length_m) {
  line_.clear();
  const VoteGrid::Counts::Tile* tile = nullptr;
  Cell tile_index{};
  bool first = true;
  for (const Cell cell : raster_.cells(origin, direction, length_m, within_, &blocks_)) {
    const Cell here = VoteGrid::Counts::tile_of(cell);
    if (first || here != tile_index) {
      tile = counts_.find(here);
      tile_index = here;
      first = false;
    }
    if (tile == nullptr) continue;
    const std::uint16_t count = (*tile)[VoteGrid::Counts::offset_in_tile(cell)];
    if (count >= threshold_) line_.push_back({cell, count});
  }
  return line_;
}

void LineProcessor::process(std::uint64_t line, std::span<const LineCell> cells) {
  counts_.clear();
  for (const LineCell& c : cells) counts_.push_back(c.count);
  const auto survivor =
      directional_maximum(counts_, options_.threshold, options_.tie, std::uint64_t(options_.tie_seed), line);
  if (survivor) survivors_.push_back(cells[*survivor].cell);
  if (options_.unvisited == UnvisitedRule::keep)
    for (const LineCell& c : cells) visited_.insert(c.cell);
}

std::vector<Cell> LineProcessor::take() {
  make_unique(survivors_);
  return std::exchange(survivors_, {});
}

void make_unique(std::vector<Cell>& cells) {
  sort_by_key(cells, [](Cell c) { return std::int64_t(c.j); }, [](Cell a, Cell b) { return a.i < b.i; });
  const auto repeated = std::ranges::unique(cells);
  cells.erase(repeated.begin(), repeated.end());
}

}  // namespace echoarc::doi
