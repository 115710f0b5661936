// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/carved_grid.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "echoarc/maps/sector_raster.hpp"
#include "mapping/carved_cells.hpp"
#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"
#include "mapping/sensor_memory.hpp"

namespace echoarc {
namespace {

constexpr float clamp_log_odds = 8.0F;

}  // namespace

/// Ring, grid and what connects them.
class CarvedGrid::State {
 public:
  explicit State(const Options& options)
      : options_(options),
        // The ring may take up to a half, the map what is left; two grids a half of that each.
        ring_limit_(std::min(std::size_t(options.history) * CarvedRing::arc_bytes, memory_limit_bytes(options) / 2)),
        ring_(ring_limit_ / CarvedRing::arc_bytes, options.guard_m),
        sensors_(std::size_t(options.profile_arcs), std::size_t(options.profile_least)),
        raster_(geometry_of(options)),
        grid_(geometry_of(options), grid_limit()),
        shown_(geometry_of(options), grid_limit()) {}

  [[nodiscard]] const CarvedRing& ring() const { return ring_; }
  [[nodiscard]] const Map& shown() const { return deferred() ? shown_ : grid_; }

  void take(const Reading& reading, InsertCounters& counters);
  void show();
  template <class Visit>
  void for_each_change(const Reading& reading, Visit&& visit) const;
  void save(ByteWriter& out) const;
  [[nodiscard]] bool restore(ByteReader& in);

 private:
  [[nodiscard]] bool deferred() const { return options_.mode == CarvedGridMode::deferred; }
  [[nodiscard]] std::size_t grid_limit() const {
    const std::size_t left = memory_limit_bytes(options_) - ring_limit_;
    return deferred() ? left / 2 : left;
  }
  [[nodiscard]] bool make_room(const CarvedBeam& beam);
  void take_arc(const Arc& arc, const Reading& reading, const CarvedBeam& beam);
  void let_go(ArcSlot slot);
  void apply(const CarvedBeam& beam, const BandAmplitude& amplitude, Map& grid) const;
  void apply_remains(ArcSlot slot, Map& grid) const;
  [[nodiscard]] BandAmplitude present_band(const Reading& reading, Angle half_width) const;

  Options options_;
  std::size_t ring_limit_;
  CarvedRing ring_;
  SensorMemory sensors_;
  mutable SectorRaster raster_;  // scratch
  Map grid_;                     // everything but, in mode deferred, the arcs of the ring
  Map shown_;                    // mode deferred: with them
};

bool CarvedGrid::State::make_room(const CarvedBeam& beam) {
  if (ring_.memory_bytes() + sensors_.memory_bytes() > memory_limit_bytes(options_)) return false;
  if (!within_reach(beam.rim, grid_.geometry(), grid_.memory_limit_bytes())) return false;
  Box box = beam.rim.bounds();
  const Vec2 apex = beam.rim.centre();
  box.low = {std::min(box.low.x, apex.x), std::min(box.low.y, apex.y)};
  box.high = {std::max(box.high.x, apex.x), std::max(box.high.y, apex.y)};
  return grid_.ensure_cells(grid_.geometry().cells_of(box));
}

void CarvedGrid::State::take(const Reading& reading, InsertCounters& counters) {
  if (!echo_range_m(reading.outcome) && !is_no_echo(reading.outcome)) {
    ++counters.no_information;
    return;
  }
  const auto beam = carved_beam(reading, options_);
  const auto arc = beam && beam->echo_m ? arc_of(reading, options_.beam_policy) : std::nullopt;
  if (!beam || (beam->echo_m && !arc)) {
    ++(is_no_echo(reading.outcome) ? counters.no_information : counters.no_arc);
    return;
  }
  if (!make_room(*beam)) {
    ++counters.memory_limit;
    return;
  }
  ++counters.used;
  if (arc && arc->range_m() <= options_.max_range_m) {
    take_arc(*arc, reading, *beam);
    return;
  }
  if (options_.carve_with_timeouts) ring_.carve_silence(reading, options_.beam_policy, options_.max_range_m);
  apply(*beam, gaussian_band(sonar_model(options_, beam->rim.half_width())), grid_);
}

void CarvedGrid::State::take_arc(const Arc& arc, const Reading& reading, const CarvedBeam& beam) {
  if (const auto oldest = ring_.history().leaving(reading.rx)) let_go(*oldest);
  ring_.carve(arc, reading);
  if (!deferred()) apply(beam, present_band(reading, arc.half_width()), grid_);
  const ArcSlot slot = ring_.enter(arc, reading);
  sensors_.entered(reading, slot);
  if (ring_.capacity() == 0) let_go(slot);
}

void CarvedGrid::State::let_go(ArcSlot slot) {
  if (deferred()) apply_remains(slot, grid_);
  sensors_.leaves(ring_.reading(slot), ring_.remains(slot));
  ring_.leave(slot);
}

BandAmplitude CarvedGrid::State::present_band(const Reading& reading, Angle half_width) const {
  const auto profile = sensors_.profile(reading, ring_, half_width);
  if (!profile) return gaussian_band(sonar_model(options_, half_width));
  return [profile = *profile, peak = options_.occupied_peak - 0.5](Angle theta) { return peak * profile.at(theta); };
}

void CarvedGrid::State::apply(const CarvedBeam& beam, const BandAmplitude& amplitude, Map& grid) const {
  const InverseSonarModel model = sonar_model(options_, beam.rim.half_width());
  for (const RowSpan& row : raster_.spans(beam.rim))
    for (std::int32_t i = row.i_begin; i < row.i_end; ++i) {
      const Cell cell{i, row.j};
      float& value = grid.at(cell);
      const double change = carved_increment(beam, model, amplitude, grid.geometry().centre(cell));
      value = std::clamp(float(value + change), -clamp_log_odds, clamp_log_odds);
    }
}

void CarvedGrid::State::apply_remains(ArcSlot slot, Map& grid) const {
  const auto beam = carved_beam(ring_.reading(slot), options_);
  apply(*beam, remaining_band(ring_.remains(slot), options_), grid);
}

void CarvedGrid::State::show() {
  if (!deferred()) return;
  shown_ = grid_;
  for (const ArcSlot slot : ring_.history().in_time_order()) apply_remains(slot, shown_);
}

/// Visits (cell, change) of a reading; in mode deferred as if it left the ring uncarved.
template <class Visit>
void CarvedGrid::State::for_each_change(const Reading& reading, Visit&& visit) const {
  const auto beam = carved_beam(reading, options_);
  if (!beam || !within_reach(beam->rim, grid_.geometry(), grid_.memory_limit_bytes())) return;
  const bool carvable = beam->echo_m && *beam->echo_m <= options_.max_range_m;
  const InverseSonarModel model = sonar_model(options_, beam->rim.half_width());
  BandAmplitude amplitude = gaussian_band(model);
  if (carvable && deferred())
    amplitude = remaining_band({.left = CarvableArc(beam->rim)}, options_);
  else if (carvable)
    amplitude = present_band(reading, beam->rim.half_width());
  for (const RowSpan& row : raster_.spans(beam->rim))
    for (std::int32_t i = row.i_begin; i < row.i_end; ++i)
      if (const double change = carved_increment(*beam, model, amplitude, grid_.geometry().centre({i, row.j}));
          change != 0.0)
        visit(Cell{i, row.j}, change);
}

void CarvedGrid::State::save(ByteWriter& out) const {
  ring_.save(out);
  sensors_.save(out);
  grid_.save(out);
}

bool CarvedGrid::State::restore(ByteReader& in) {
  if (!ring_.restore(in, options_.beam_policy, options_.max_range_m) || !sensors_.restore(in)) return false;
  for (const ArcSlot slot : ring_.history().in_time_order()) {
    sensors_.entered(ring_.reading(slot), slot);
    if (!carved_beam(ring_.reading(slot), options_)) return false;
  }
  if (!restore_grid(in, grid_)) return false;
  // Tiles under the arcs of the ring were made when they came; damaged bytes may lack them.
  for (const ArcSlot slot : ring_.history().in_time_order())
    if (!make_room(*carved_beam(ring_.reading(slot), options_))) return false;
  return true;
}

CarvedGrid::CarvedGrid(Options options) : options_(options), state_(std::make_unique<State>(options)) {}
CarvedGrid::CarvedGrid(CarvedGrid&&) noexcept = default;
CarvedGrid& CarvedGrid::operator=(CarvedGrid&&) noexcept = default;
CarvedGrid::~CarvedGrid() = default;

void CarvedGrid::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) state_->take(reading, counters_);
}

void CarvedGrid::finish(Executor& /*executor*/) {
  state_->show();
}

const CarvedGrid::Map& CarvedGrid::map() const {
  return state_->shown();
}

std::vector<Tally> CarvedGrid::tallies() const {
  return state_->ring().carver().tallies();
}

Result<MapExport> CarvedGrid::export_map() const {
  const auto state_of = [&](Cell /*cell*/, float value) {
    const double p = probability(double(value));
    if (p >= options_.occupied_threshold) return CellState::occupied;
    return p <= options_.free_threshold ? CellState::free : CellState::unknown;
  };
  return export_grid<float>(map(), name, state_of, [](float value) { return value; });
}

Trace CarvedGrid::trace(const Reading& reading) const {
  Trace trace;
  InsertCounters ignored;
  trace.arc = carvable_arc(reading, options_.beam_policy, std::numeric_limits<double>::max(), ignored);
  state_->for_each_change(reading, [&](Cell cell, double change) {
    const float before = map().value(cell);
    const float after = std::clamp(float(before + change), -clamp_log_odds, clamp_log_odds);
    trace.cells.push_back({cell,
                           map().geometry().centre(cell),
                           double(before),
                           double(after),
                           {{"p", probability(change)}, {"log_odds_added", change}}});
  });
  return trace;
}

bool CarvedGrid::supports(const Reading& reading, Vec2 position) const {
  const auto beam = carved_beam(reading, options_);
  if (!beam || !beam->echo_m) return false;
  const Vec2 centre = map().geometry().centre(map().geometry().cell_of(position));
  const InverseSonarModel model = sonar_model(options_, beam->rim.half_width());
  return carved_increment(*beam, model, gaussian_band(model), centre) > 0.0;
}

std::vector<std::byte> CarvedGrid::save() const {
  ByteWriter out;
  save_head<CarvedGrid>(out, options_, counters_);
  state_->save(out);
  return std::move(out).take();
}

Result<CarvedGrid> CarvedGrid::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<CarvedGrid>(in, options, counters)) return damaged_state(name);
  CarvedGrid method(options);
  method.counters_ = counters;
  if (!method.state_->restore(in) || !in.done()) return damaged_state(name);
  method.state_->show();
  return method;
}

}  // namespace echoarc
