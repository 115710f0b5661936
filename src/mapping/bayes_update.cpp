// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/bayes_update.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/bayes_density.hpp"
#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

/// The outer rim of the band that a reading calls occupied.
Arc outer_rim(const Arc& arc, const BayesUpdateOptions& options) {
  return arc.at_range(arc.range_m() + options.range_error_m);
}

BayesDensity density_of(const Arc& arc, const BayesUpdateOptions& options) {
  return {arc, options.near_field_m, options.range_error_m};
}

/// Calls `visit(j, i_begin, i_end)` for the parts of a row span that lie in one tile each.
template <class Visit>
void for_each_tile_part(const RowSpan& span, Visit&& visit) {
  for (std::int32_t i = span.i_begin; i < span.i_end;) {
    const std::int32_t end = std::min(span.i_end, (i | (tile_size - 1)) + 1);
    visit(span.j, i, end);
    i = end;
  }
}

bool ensure_tiles(BayesUpdate::Map& cells, std::span<const RowSpan> spans) {
  bool room = true;
  for (const RowSpan& span : spans)
    for_each_tile_part(span, [&](std::int32_t j, std::int32_t i, std::int32_t) {
      room = room && cells.ensure(BayesUpdate::Map::tile_of({i, j}));
    });
  return room;
}

CellChange change_of(const BayesCell& before, Cell cell, Vec2 centre, const BayesTerms& terms,
                     BayesCombination combination) {
  return {cell,
          centre,
          bayes_value(before, combination),
          bayes_value(updated(before, terms), combination),
          {{"sigma", terms.sigma_m, "m"},
           {"theta", std::sqrt(terms.theta_sq), "rad"},
           {"E_r", terms.range_empty},
           {"E_a", terms.angular},
           {"O_r", terms.range_occupied},
           {"O_a", terms.angular},
           {"p_E", terms.empty()},
           {"p_O", terms.occupied()}}};
}

}  // namespace

double bayes_value(const BayesCell& cell, BayesCombination combination) {
  const double empty = cell.empty;
  const double occupied = cell.occupied;
  switch (combination) {
    case BayesCombination::difference: return 0.5 * (1.0 + (occupied - empty));
    case BayesCombination::moravec_elfes: return 0.5 * (1.0 + (occupied >= empty ? occupied : -empty));
    case BayesCombination::ratio: return occupied + empty > 0.0 ? occupied / (occupied + empty) : 0.5;
  }
  return 0.5;
}

BayesUpdate::BayesUpdate(Options options)
    : options_(options), cells_(geometry_of(options), memory_limit_bytes(options)), raster_(geometry_of(options)) {}

void BayesUpdate::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings)
    if (const auto arc = counted_arc(reading, options_.beam_policy, counters_))
      ++(add(*arc) ? counters_.used : counters_.memory_limit);
}

bool BayesUpdate::add(const Arc& arc) {
  const Arc rim = outer_rim(arc, options_);
  if (!within_reach(rim, cells_.geometry(), cells_.memory_limit_bytes())) return false;
  const std::span<const RowSpan> spans = raster_.spans(rim);
  if (!ensure_tiles(cells_, spans)) return false;
  const BayesDensity density = density_of(arc, options_);
  for (const RowSpan& span : spans)
    for_each_tile_part(span, [&](std::int32_t j, std::int32_t i_begin, std::int32_t i_end) {
      BayesCell* cell = &cells_.at({i_begin, j});
      for (std::int32_t i = i_begin; i < i_end; ++i, ++cell)
        *cell = updated(*cell, density.at(cells_.geometry().centre({i, j})));
    });
  return true;
}

CellState BayesUpdate::state(const BayesCell& cell) const {
  const double value = bayes_value(cell, options_.combination);
  if (value > options_.threshold) return CellState::occupied;
  return value < 0.5 ? CellState::free : CellState::unknown;
}

Result<MapExport> BayesUpdate::export_map() const {
  const auto value_of = [&](const BayesCell& cell) {
    return static_cast<float>(bayes_value(cell, options_.combination));
  };
  return export_grid<float>(cells_, name, [&](Cell, const BayesCell& cell) { return state(cell); }, value_of);
}

Trace BayesUpdate::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  if (!trace.arc) return trace;
  const Arc rim = outer_rim(*trace.arc, options_);
  if (!within_reach(rim, cells_.geometry(), cells_.memory_limit_bytes())) return trace;
  const BayesDensity density = density_of(*trace.arc, options_);
  SectorRaster raster(cells_.geometry());
  for (const RowSpan& span : raster.spans(rim))
    for (Cell cell{span.i_begin, span.j}; cell.i < span.i_end; ++cell.i) {
      const Vec2 centre = cells_.geometry().centre(cell);
      const BayesTerms terms = density.at(centre);
      if (terms.empty() > 0.0 || terms.occupied() > 0.0)
        trace.cells.push_back(change_of(cells_.value(cell), cell, centre, terms, options_.combination));
    }
  return trace;
}

bool BayesUpdate::supports(const Reading& reading, Vec2 position) const {
  const auto arc = arc_of(reading, options_.beam_policy);
  if (!arc) return false;
  const Vec2 centre = cells_.geometry().centre(cells_.geometry().cell_of(position));
  if (centre == arc->centre() || abs(wrap(bearing(centre - arc->centre()) - arc->axis())) > arc->half_width())
    return false;
  return density_of(*arc, options_).at(centre).occupied() > 0.0;
}

std::vector<std::byte> BayesUpdate::save() const {
  ByteWriter out;
  save_head<BayesUpdate>(out, options_, counters_);
  cells_.save(out);
  return std::move(out).take();
}

Result<BayesUpdate> BayesUpdate::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<BayesUpdate>(in, options, counters)) return damaged_state(name);
  BayesUpdate method(options);
  method.counters_ = counters;
  if (!restore_grid(in, method.cells_) || !in.done()) return damaged_state(name);
  return method;
}

}  // namespace echoarc
