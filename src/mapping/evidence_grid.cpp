// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/evidence_grid.hpp"

#include <algorithm>
#include <utility>

#include "mapping/evidence_planner.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

/// Changes are made when this many rows are planned: enough to share between threads, few enough to stay in cache.
constexpr std::size_t plan_capacity = 8192;

}  // namespace

EvidenceGrid::EvidenceGrid(Options options)
    : options_(options),
      grid_(geometry_of(options), memory_limit_bytes(options)),
      planner_(std::make_unique<Planner>(options)) {}

EvidenceGrid::EvidenceGrid(EvidenceGrid&&) noexcept = default;
EvidenceGrid& EvidenceGrid::operator=(EvidenceGrid&&) noexcept = default;
EvidenceGrid::~EvidenceGrid() = default;

void EvidenceGrid::insert(std::span<const Reading> readings, Executor& executor) {
  for (const Reading& reading : readings) {
    const auto reach = planner_->reach_of(reading);
    if (!reach) {
      const bool echo = echo_range_m(reading.outcome).has_value();
      ++(echo ? counters_.no_arc : counters_.no_information);
      continue;
    }
    ++(planner_->add(reading, *reach, grid_) ? counters_.used : counters_.memory_limit);
    if (planner_->plan().size() >= plan_capacity) apply_plan(executor);
  }
  apply_plan(executor);
}

void EvidenceGrid::apply_plan(Executor& executor) {
  UpdatePlan& plan = planner_->plan();
  const std::size_t stripes = std::max<std::size_t>(1, executor.concurrency());
  executor.run(stripes, [&](std::size_t stripe) { apply_stripe(plan, grid_, stripe, stripes); });
  plan.clear();
}

Result<MapExport> EvidenceGrid::export_map() const {
  const auto state_of = [&](Cell /*cell*/, std::int16_t value) {
    const double p = probability(value * log_odds_unit);
    if (p >= options_.occupied_threshold) return CellState::occupied;
    return p <= options_.free_threshold ? CellState::free : CellState::unknown;
  };
  return export_grid<float>(grid_, name, state_of,
                            [](std::int16_t value) { return static_cast<float>(value * log_odds_unit); });
}

Trace EvidenceGrid::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading);
  Planner planner(options_);
  const auto reach = planner.reach_of(reading);
  Map scratch(grid_.geometry(), grid_.memory_limit_bytes());
  if (!reach || !planner.add(reading, *reach, scratch)) return trace;
  scratch.for_each_tile([&](Map::TileIndex t, const Map::Tile&) {
    if (const Map::Tile* present = grid_.find(t)) *scratch.find(t) = *present;
  });
  const WeightedModel beam = planner.model_of(reading);
  apply_stripe(planner.plan(), scratch, 0, 1);

  const auto describe = [&](Cell cell) {
    const Vec2 centre = grid_.geometry().centre(cell);
    const double distance_m = reach->rim.half_path_m(centre);
    const Angle theta = wrap(bearing(centre - reach->rim.centre()) - reach->rim.axis());
    const double change = exact_increment(beam, *reach, centre) * log_odds_unit;
    trace.cells.push_back({cell,
                           centre,
                           cell_log_odds(cell),
                           scratch.value(cell) * log_odds_unit,
                           {{"sigma", distance_m, "m"},
                            {"theta", theta.deg(), "deg"},
                            {"angular_factor", beam.model.angular_factor(theta)},
                            {"p", probability(change)},
                            {"log_odds_added", change}}});
  };
  const PlannedRows& rows = planner.plan().rows;
  for (const UpdateGroup& group : planner.plan().groups)
    for (std::size_t k = group.rows.begin; k < group.rows.end; ++k)
      for (Cell cell{rows.begin[k], group.row(k)}; cell.i < rows.end[k]; ++cell.i)
        if (cell.i < rows.near_begin[k] || cell.i >= rows.near_end[k]) describe(cell);
  for (const SpotUpdate& spot : planner.plan().spots) describe(spot.cell);
  std::ranges::sort(trace.cells, [](const CellChange& a, const CellChange& b) { return a.cell < b.cell; });
  return trace;
}

bool EvidenceGrid::supports(const Reading& reading, Vec2 position) const {
  const Planner planner(options_);
  const auto reach = planner.reach_of(reading);
  if (!reach || !reach->echo_m) return false;
  const Vec2 centre = grid_.geometry().centre(grid_.geometry().cell_of(position));
  return exact_increment(planner.model_of(reading), *reach, centre) > 0;
}

std::vector<std::byte> EvidenceGrid::save() const {
  ByteWriter out;
  save_head<EvidenceGrid>(out, options_, counters_);
  grid_.save(out);
  return std::move(out).take();
}

Result<EvidenceGrid> EvidenceGrid::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<EvidenceGrid>(in, options, counters)) return damaged_state(name);
  EvidenceGrid method(options);
  if (!method.grid_.restore(in) || !in.done()) return damaged_state(name);
  method.counters_ = counters;
  return method;
}

}  // namespace echoarc
