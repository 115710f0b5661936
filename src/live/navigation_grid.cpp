// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/navigation_grid.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::live {
namespace {

/// A square of 1 km at 10 cm.
constexpr double most_cells = 1e8;
/// Room to spare, so that the grid is made anew now and then alone.
constexpr double margin_m = 10.0;

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

bool inside(const Box& inner, const Box& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

Box extent(const DenseGrid<CellState>& cells) {
  const GridGeometry& geometry = cells.geometry();
  return {geometry.corner({0, 0}), geometry.corner({cells.width(), cells.height()})};
}

}  // namespace

bool NavigationGrid::cover(const Box& box) {
  if (!is_finite(box.low) || !is_finite(box.high)) return false;
  if (!cells_.empty() && inside(box, extent(cells_))) return true;
  const Vec2 margin{margin_m, margin_m};
  const Box grown{box.low - margin, box.high + margin};
  const Box all = cells_.empty() ? grown : joined(grown, extent(cells_));
  const GridGeometry world{.cell_m = cell_m_, .origin = {}};
  const CellBox wanted = world.cells_of(all);
  if (double(wanted.width()) * double(wanted.height()) > most_cells) return false;
  const GridGeometry geometry{.cell_m = cell_m_, .origin = world.corner({wanted.i_begin, wanted.j_begin})};
  DenseGrid<CellState> larger(geometry, std::int32_t(wanted.width()), std::int32_t(wanted.height()));
  if (!cells_.empty()) {
    const Cell low = geometry.cell_of(cells_.geometry().centre({0, 0}));
    for (std::int32_t j = 0; j < cells_.height(); ++j) std::ranges::copy(cells_.row(j), &larger.at({low.i, low.j + j}));
  }
  cells_ = std::move(larger);
  ++version_;
  return true;
}

void NavigationGrid::take(const EvidenceGrid& evidence, const Box& box) {
  const auto limit = [](double p) { return std::int16_t(std::lround(std::log(p / (1.0 - p)) / log_odds_unit)); };
  const std::int16_t occupied = limit(evidence.options().occupied_threshold);
  const std::int16_t free = limit(evidence.options().free_threshold);
  const GridGeometry& geometry = cells_.geometry();
  CellBox cells = geometry.cells_of(box);
  cells = {std::max(cells.i_begin, 0), std::max(cells.j_begin, 0), std::min(cells.i_end, cells_.width()),
           std::min(cells.j_end, cells_.height())};
  if (cells.empty()) return;
  const Cell offset = evidence.map().geometry().cell_of(geometry.centre({0, 0}));
  bool changed = false;
  for (std::int32_t j = cells.j_begin; j < cells.j_end; ++j)
    for (std::int32_t i = cells.i_begin; i < cells.i_end; ++i) {
      const std::int16_t odds = evidence.map().value({offset.i + i, offset.j + j});
      const CellState state = odds >= occupied ? CellState::occupied
                              : odds <= free   ? CellState::free
                                               : CellState::unknown;
      CellState& cell = cells_.at({i, j});
      changed = changed || cell != state;
      cell = state;
    }
  if (changed) ++version_;
}

void NavigationGrid::take(std::span<const Vec2> points) {
  for (const Vec2 point : points)
    if (!cover({point, point})) return;
  std::ranges::fill(cells_.values(), CellState::unknown);
  for (const Vec2 point : points) cells_.at(cells_.geometry().cell_of(point)) = CellState::occupied;
  ++version_;
}

}  // namespace echoarc::live
