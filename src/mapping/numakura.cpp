// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/numakura.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/numakura_judge.hpp"
#include "mapping/numakura_scan.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

/// A quarter of the memory is kept for what `finish` shows of an unfinished scan.
std::size_t grid_limit_bytes(const NumakuraOptions& options) {
  const std::size_t limit = memory_limit_bytes(options);
  return limit - limit / 4;
}

std::int32_t units(double value) {
  return static_cast<std::int32_t>(std::lrint(std::clamp(value, 0.0, numakura_clamp) / numakura_unit));
}

/// The reading's range: of silence how far it clears. No value when it says nothing.
std::optional<double> reach_of(const Reading& reading, const NumakuraOptions& options) {
  if (const auto echo_m = echo_range_m(reading.outcome)) return echo_m;
  const double clears_m = std::min(reading.trusted_range_m, reading.range_max_m);
  if (!is_no_echo(reading.outcome) || options.no_echo_weight <= 0.0 || !(clears_m > 0.0)) return std::nullopt;
  return clears_m;
}

/// C_f = I u(d) p and C_o = I u(d) q ([Numakura] eqs. 1 to 3).
Contribution contribution_of(const Reading& reading, double range_m, double certainty, const NumakuraOptions& options) {
  const double weight = certainty * range_weight(range_m, options.reliable_range_m);
  const bool echo = echo_range_m(reading.outcome).has_value();
  return {.T_world_tx = reading.T_world_tx,
          .T_world_rx = reading.T_world_rx,
          .beam_width = reading.beam_width,
          .range_m = range_m,
          .free_step = units(weight * options.free_step * (echo ? 1.0 : options.no_echo_weight)),
          .obstacle_step = echo ? units(weight * options.obstacle_step) : 0,
          .monostatic = reading.monostatic() ? 1U : 0U,
          .echo = echo ? 1U : 0U};
}

bool within_clamp(std::span<const std::int32_t> cells) {
  const std::int32_t clamp = units(numakura_clamp);
  return std::ranges::all_of(cells, [clamp](std::int32_t value) { return value >= -clamp && value <= clamp; });
}

}  // namespace

Numakura::Numakura(Options options)
    : options_(options),
      grid_(geometry_of(options), grid_limit_bytes(options)),
      judge_(std::make_unique<Judge>(options)),
      open_(std::make_unique<OpenScan>(options, grid_)) {}

Numakura::Numakura(Numakura&& other) noexcept
    : options_(other.options_),
      grid_(std::move(other.grid_)),
      counters_(other.counters_),
      judge_(std::move(other.judge_)),
      open_(std::move(other.open_)) {
  if (open_) open_->attach(grid_);
}

Numakura& Numakura::operator=(Numakura&& other) noexcept {
  options_ = other.options_;
  grid_ = std::move(other.grid_);
  counters_ = other.counters_;
  judge_ = std::move(other.judge_);
  open_ = std::move(other.open_);
  if (open_) open_->attach(grid_);
  return *this;
}

Numakura::~Numakura() = default;

const OutlierCounters& Numakura::outliers() const {
  return judge_->outliers();
}

void Numakura::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) insert_one(reading);
}

void Numakura::insert_one(const Reading& reading) {
  if (!judge_->knows_scan(reading.scan)) {
    open_->close();
    judge_->begin_scan(reading.scan);
  }
  const auto range_m = reach_of(reading, options_);
  if (!range_m) {
    ++counters_.no_information;
    return;
  }
  Contribution contribution = contribution_of(reading, *range_m, 1.0, options_);
  const auto arc = contribution.arc();
  if (!arc) {
    ++counters_.no_arc;
    return;
  }
  open_->hide();
  if (contribution.echo != 0 && within_reach(*arc, grid_.geometry(), grid_.memory_limit_bytes())) {
    const OutlierVerdict verdict = judge_->judge(reading, *arc, [&](Cell cell) { return grid_.value(cell); });
    judge_->remember(reading, *arc, verdict);
    if (verdict.outlier()) contribution = contribution_of(reading, *range_m, options_.outlier_weight, options_);
  }
  ++(open_->add(contribution) ? counters_.used : counters_.memory_limit);
}

void Numakura::finish(Executor& /*executor*/) {
  open_->show();
}

Result<MapExport> Numakura::export_map() const {
  const auto state_of = [&](Cell /*cell*/, std::int32_t value) {
    const double v = value * numakura_unit;
    if (v <= -options_.occupied_threshold) return CellState::occupied;
    return v >= options_.free_threshold ? CellState::free : CellState::unknown;
  };
  return export_grid<float>(grid_, name, state_of,
                            [](std::int32_t value) { return static_cast<float>(value * numakura_unit); });
}

Trace Numakura::trace(const Reading& reading) const {
  Trace trace;
  const auto range_m = reach_of(reading, options_);
  if (!range_m) return trace;
  const auto arc = contribution_of(reading, *range_m, 1.0, options_).arc();
  if (!arc || !within_reach(*arc, grid_.geometry(), grid_.memory_limit_bytes())) return trace;
  const bool echo = echo_range_m(reading.outcome).has_value();
  const bool same_scan = judge_->knows_scan(reading.scan);
  const auto before = [&](Cell cell) { return same_scan ? open_->value_before(cell) : grid_.value(cell); };
  const OutlierVerdict verdict = echo ? judge_->judge(reading, *arc, before) : OutlierVerdict{};
  const double certainty = verdict.outlier() ? options_.outlier_weight : 1.0;
  const Contribution contribution = contribution_of(reading, *range_m, certainty, options_);

  const auto describe = [&](Cell cell, std::string_view step, double change) {
    const double value = cell_value(cell);
    trace.cells.push_back({cell,
                           grid_.geometry().centre(cell),
                           value,
                           std::clamp(value + change, -numakura_clamp, numakura_clamp),
                           {{"d", *range_m, "m"},
                            {"u", range_weight(*range_m, options_.reliable_range_m)},
                            {"I", certainty},
                            {"surface_angle", radians(verdict.surface_angle_rad).deg(), "deg"},
                            {step, std::abs(change)}}});
  };
  if (echo) trace.arc = arc;
  if (const auto interior = contribution.interior(*arc, options_.cell_m)) {
    SectorRaster sectors(grid_.geometry());
    for (const RowSpan& span : sectors.spans(*interior))
      for (std::int32_t i = span.i_begin; i < span.i_end; ++i)
        describe({i, span.j}, "C_f", contribution.free_step * numakura_unit);
  }
  ArcRaster arcs(grid_.geometry());
  if (echo)
    for (const Cell cell : arcs.cells(*arc)) describe(cell, "C_o", -contribution.obstacle_step * numakura_unit);
  std::ranges::sort(trace.cells, [](const CellChange& a, const CellChange& b) { return a.cell < b.cell; });
  return trace;
}

bool Numakura::supports(const Reading& reading, Vec2 position) const {
  const auto range_m = echo_range_m(reading.outcome);
  if (!range_m) return false;
  const auto arc = contribution_of(reading, *range_m, 1.0, options_).arc();
  if (!arc || !within_reach(*arc, grid_.geometry(), grid_.memory_limit_bytes())) return false;
  ArcRaster arcs(grid_.geometry());
  const std::span<const Cell> cells = arcs.cells(*arc);
  return std::ranges::find(cells, grid_.geometry().cell_of(position)) != cells.end();
}

std::vector<std::byte> Numakura::save() const {
  ByteWriter out;
  save_head<Numakura>(out, options_, counters_);
  grid_.save(out);
  judge_->save(out);
  open_->save(out);
  return std::move(out).take();
}

Result<Numakura> Numakura::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Numakura>(in, options, counters)) return damaged_state(name);
  Numakura method(options);
  method.counters_ = counters;
  if (!restore_grid(in, method.grid_)) return damaged_state(name);
  bool sane = true;
  method.grid_.for_each_tile([&](Cell, const Map::Tile& tile) { sane = sane && within_clamp(tile); });
  if (!sane || !method.judge_->restore(in) || !method.open_->restore(in) || !in.done()) return damaged_state(name);
  return method;
}

}  // namespace echoarc
