// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/numakura_scan.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/counted_arc.hpp"

namespace echoarc {
namespace {

/// A scan of more readings is cut: a log whose scan never ends must not fill the memory.
constexpr std::size_t max_readings = 1024;
constexpr auto ceiling = static_cast<std::int32_t>(numakura_clamp / numakura_unit);

}  // namespace

std::optional<Arc> Contribution::arc() const {
  const bool drawable = range_m > 0.0 && std::isfinite(range_m) && beam_width > Angle{} &&
                        beam_width < degrees(180.0) && is_finite(T_world_tx) && is_finite(T_world_rx);
  if (!drawable) return std::nullopt;
  if (monostatic == 0) return Arc::elliptical(T_world_tx, T_world_rx, range_m, beam_width);
  return Arc::circular(T_world_tx.position, T_world_tx.heading, range_m, beam_width);
}

std::optional<Arc> Contribution::interior(const Arc& arc, double cell_m) const {
  if (echo == 0) return arc;
  // Cells exactly at range - cell are not inside.
  const double radius_m = range_m - cell_m - eps_length_m;
  const double semi_focal_m = 0.5 * norm(arc.receiver() - arc.transmitter());
  return radius_m > semi_focal_m + eps_length_m ? std::optional(arc.at_range(radius_m)) : std::nullopt;
}

Numakura::OpenScan::OpenScan(const NumakuraOptions& options, Map& grid)
    : options_(options),
      grid_(&grid),
      sectors_(grid.geometry()),
      arcs_(grid.geometry()),
      most_touched_(memory_limit_bytes(options) / 4 / sizeof(Map::Tile)) {}

bool Numakura::OpenScan::add(const Contribution& contribution) {
  hide();
  if (contributions_.size() >= max_readings) close();
  const std::size_t touched = touched_.size();
  const bool planned = plan(contribution);
  const bool too_large = touched_.size() > most_touched_;
  if (planned && !too_large) {
    contributions_.push_back(contribution);
    parts_.push_back({runs_.size(), arc_cells_.size()});
    return true;
  }
  truncate(touched);
  if (!too_large || touched == 0) return false;
  // The scan has grown too large to be kept: it is cut here, and the reading begins the next part.
  close();
  return add(contribution);
}

void Numakura::OpenScan::truncate(std::size_t touched) {
  touched_.resize(touched);
  runs_.resize(parts_.empty() ? 0 : parts_.back().runs_end);
  arc_cells_.resize(parts_.empty() ? 0 : parts_.back().arc_end);
}

bool Numakura::OpenScan::plan(const Contribution& contribution) {
  const auto arc = contribution.arc();
  if (!arc || !within_reach(*arc, grid_->geometry(), grid_->memory_limit_bytes())) return false;
  const auto interior = contribution.interior(*arc, options_.cell_m);
  return (!interior || plan_rows(*interior)) && (contribution.echo == 0 || plan_arc(*arc));
}

Numakura::Map::Tile* Numakura::OpenScan::tile_at(Cell index) {
  touched_.push_back(index);
  return touched_.size() <= most_touched_ + 1 && grid_->ensure(index) ? grid_->find(index) : nullptr;
}

bool Numakura::OpenScan::plan_rows(const Arc& interior) {
  // Along a column of tiles the rows come one after another: each tile is looked up once per row of tiles.
  std::vector<Map::Tile*> tiles;
  std::int32_t tile_row = 0;
  std::int32_t first_column = 0;
  bool any = false;
  for (const RowSpan& span : sectors_.spans(interior)) {
    const std::int32_t first = span.i_begin >> tile_shift;
    const std::int32_t last = (span.i_end - 1) >> tile_shift;
    if (!any || span.j >> tile_shift != tile_row || first < first_column) {
      tiles.clear();
      tile_row = span.j >> tile_shift;
      first_column = first;
      any = true;
    }
    for (std::int32_t column = first; column <= last; ++column) {
      const auto place = static_cast<std::size_t>(column - first_column);
      if (place >= tiles.size()) tiles.resize(place + 1, nullptr);
      if (tiles[place] == nullptr && (tiles[place] = tile_at({column, tile_row})) == nullptr) return false;
      const std::int32_t left = column << tile_shift;
      std::int32_t* const row = tiles[place]->data() + Map::offset_in_tile({left, span.j});
      runs_.push_back({row, std::max(span.i_begin - left, 0), std::min(span.i_end - left, tile_size)});
    }
  }
  return true;
}

bool Numakura::OpenScan::plan_arc(const Arc& arc) {
  Map::Tile* tile = nullptr;
  Cell index;
  for (const Cell cell : arcs_.cells(arc)) {
    if (tile == nullptr || Map::tile_of(cell) != index) {
      index = Map::tile_of(cell);
      if ((tile = tile_at(index)) == nullptr) return false;
    }
    arc_cells_.push_back(tile->data() + Map::offset_in_tile(cell));
  }
  return true;
}

void Numakura::OpenScan::apply() {
  const kernels::AccumulationKernels& kernels = kernels::accumulation_kernels();
  std::size_t run = 0;
  std::size_t cell = 0;
  for (std::size_t k = 0; k < contributions_.size(); ++k) {
    kernels.raise(runs_.data() + run, parts_[k].runs_end - run, contributions_[k].free_step, ceiling);
    run = parts_[k].runs_end;
    for (; cell < parts_[k].arc_end; ++cell)
      *arc_cells_[cell] = std::max(*arc_cells_[cell] - contributions_[k].obstacle_step, -ceiling);
  }
}

void Numakura::OpenScan::close() {
  if (!shown_) apply();
  shown_ = false;
  kept_.clear();
  contributions_.clear();
  parts_.clear();
  runs_.clear();
  arc_cells_.clear();
  touched_.clear();
}

std::vector<Cell> Numakura::OpenScan::touched_once() const {
  std::vector<Cell> once = touched_;
  std::ranges::sort(once, [](Cell a, Cell b) { return a < b; });
  const auto rest = std::ranges::unique(once);
  once.erase(rest.begin(), rest.end());
  return once;
}

void Numakura::OpenScan::show() {
  if (shown_) return;
  for (const Cell index : touched_once()) kept_.push_back({index, std::make_unique<Map::Tile>(*grid_->find(index))});
  apply();
  shown_ = true;
}

void Numakura::OpenScan::hide() {
  if (!shown_) return;
  for (const Kept& kept : kept_) *grid_->find(kept.index) = *kept.tile;
  kept_.clear();
  shown_ = false;
}

std::int32_t Numakura::OpenScan::value_before(Cell cell) const {
  const Cell index = Map::tile_of(cell);
  for (const Kept& kept : kept_)
    if (kept.index == index) return (*kept.tile)[Map::offset_in_tile(cell)];
  return grid_->value(cell);
}

void Numakura::OpenScan::save(ByteWriter& out) const {
  out.put_vector(contributions_);
  out.put<std::uint8_t>(shown_ ? 1 : 0);
  for (const Kept& kept : kept_) out.put_all(std::span<const std::int32_t>(*kept.tile));
}

bool Numakura::OpenScan::restore(ByteReader& in) {
  const auto contributions = in.get_vector<Contribution>();
  if (!in.ok() || contributions.size() > max_readings) return false;
  for (const Contribution& contribution : contributions) {
    const bool legal = contribution.free_step >= 0 && contribution.free_step <= ceiling &&
                       contribution.obstacle_step >= 0 && contribution.obstacle_step <= ceiling;
    if (!legal || !plan(contribution) || touched_.size() > most_touched_) return false;
    contributions_.push_back(contribution);
    parts_.push_back({runs_.size(), arc_cells_.size()});
  }
  shown_ = in.get<std::uint8_t>() != 0;
  if (shown_)
    for (const Cell index : touched_once()) {
      kept_.push_back({index, std::make_unique<Map::Tile>()});
      Map::Tile& tile = *kept_.back().tile;
      if (!in.get_all(std::span<std::int32_t>(tile))) return false;
      if (!std::ranges::all_of(tile, [](std::int32_t value) { return value >= -ceiling && value <= ceiling; }))
        return false;
    }
  return in.ok();
}

}  // namespace echoarc
