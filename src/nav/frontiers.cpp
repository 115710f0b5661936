// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/frontiers.hpp"

#include <algorithm>

#include "nav/grid_steps.hpp"

namespace echoarc::nav {
namespace {

enum Mark : std::uint8_t { none, frontier, joined };

/// The cell nearest the centroid, in whole numbers: distances are compared times the number of cells.
Cell nearest_to_centroid(const std::vector<Cell>& cells) {
  std::int64_t sum_i = 0;
  std::int64_t sum_j = 0;
  for (const Cell c : cells) {
    sum_i += c.i;
    sum_j += c.j;
  }
  const auto n = std::int64_t(cells.size());
  return *std::ranges::min_element(cells, {}, [&](Cell c) {
    const auto di = double(c.i * n - sum_i);
    const auto dj = double(c.j * n - sum_j);
    return di * di + dj * dj;
  });
}

}  // namespace

bool is_frontier_cell(const DenseGrid<CellState>& map, Cell c) {
  if (!map.box().contains(c) || map.at(c) != CellState::free) return false;
  return std::ranges::any_of(grid_steps, [&](const GridStep& step) {
    return !map.box().contains(c + step) || map.at(c + step) == CellState::unknown;
  });
}

std::vector<Frontier> find_frontiers(const DenseGrid<CellState>& map, std::size_t least_cells) {
  FrontierFinder finder(least_cells);
  finder.update(map, map.box());
  return finder.frontiers();
}

void FrontierFinder::update(const DenseGrid<CellState>& map, const CellBox& changed) {
  CellBox box = changed;
  if (map.geometry() != marks_.geometry() || map.box() != marks_.box()) {
    marks_ = DenseGrid<std::uint8_t>(map.geometry(), map.width(), map.height(), none);
    rows_.assign(std::size_t(map.height()), {});
    box = map.box();
  }
  if (box.empty()) return;
  box = {std::max(box.i_begin - 1, 0), std::max(box.j_begin - 1, 0), std::min(box.i_end + 1, map.width()),
         std::min(box.j_end + 1, map.height())};
  std::vector<std::int32_t> found;
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j) {
    found.clear();
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const bool is_frontier = is_frontier_cell(map, {i, j});
      marks_.at({i, j}) = is_frontier ? frontier : none;
      if (is_frontier) found.push_back(i);
    }
    auto& row = rows_[std::size_t(j)];
    const auto first = std::ranges::lower_bound(row, box.i_begin);
    const auto last = std::ranges::lower_bound(row, box.i_end);
    row.insert(row.erase(first, last), found.begin(), found.end());
  }
  join();
}

void FrontierFinder::join() {
  frontiers_.clear();
  for (std::int32_t j = 0; j < marks_.height(); ++j)
    for (const std::int32_t i : rows_[std::size_t(j)]) {
      if (marks_.at({i, j}) == joined) continue;
      Frontier region = grow({i, j});
      if (region.cells.size() >= least_cells_) frontiers_.push_back(std::move(region));
    }
  for (std::int32_t j = 0; j < marks_.height(); ++j)
    for (const std::int32_t i : rows_[std::size_t(j)]) marks_.at({i, j}) = frontier;
}

Frontier FrontierFinder::grow(Cell seed) {
  Frontier region;
  region.cells.push_back(seed);
  marks_.at(seed) = joined;
  for (std::size_t k = 0; k < region.cells.size(); ++k)
    for (const GridStep& step : grid_steps)
      if (const Cell next = region.cells[k] + step; marks_.box().contains(next) && marks_.at(next) == frontier) {
        marks_.at(next) = joined;
        region.cells.push_back(next);
      }
  std::sort(region.cells.begin(), region.cells.end());
  region.target = nearest_to_centroid(region.cells);
  return region;
}

}  // namespace echoarc::nav
