// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/himm.hpp"

#include <algorithm>

#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {

Himm::Himm(Options options) : options_(options), map_(geometry_of(options), memory_limit_bytes(options)) {}

std::optional<Himm::Beam> Himm::beam_of(const Reading& reading) const {
  const auto echo_m = echo_range_m(reading.outcome);
  if (!reading.monostatic() || (!echo_m && !is_no_echo(reading.outcome))) return std::nullopt;
  const double trusted_m = std::min(reading.trusted_range_m, reading.range_max_m);
  Beam beam;
  beam.origin = reading.T_world_tx.position;
  beam.direction = unit(reading.T_world_tx.heading);
  beam.length_m = echo_m ? std::min(*echo_m, reading.range_max_m) : trusted_m;
  beam.hits = echo_m && *echo_m <= reading.range_max_m;
  if (!(beam.length_m > 0.0)) return std::nullopt;
  beam.end = map_.geometry().cell_of(beam.origin + beam.length_m * beam.direction);
  return beam;
}

/// The cells on the axis from the sensor's own on, without the one of the echo.
std::vector<Cell> Himm::passed_cells(const Beam& beam) const {
  const Cell first = map_.geometry().cell_of(beam.origin);
  const auto [i_low, i_high] = std::minmax(first.i, beam.end.i);
  const auto [j_low, j_high] = std::minmax(first.j, beam.end.j);
  RayRaster raster(map_.geometry());
  const auto cells = raster.cells(beam.origin, beam.direction, beam.length_m, {i_low, j_low, i_high + 1, j_high + 1});
  std::vector<Cell> passed(cells.begin(), cells.end());
  if (beam.hits) std::erase(passed, beam.end);
  return passed;
}

int Himm::lowered(Cell cell) const {
  return std::max(int{map_.value(cell).certainty} - options_.decrement, 0);
}

/// CV + I+, and with the growth rate operator half the neighbours' sum, rounded down.
int Himm::raised(Cell cell) const {
  int around = 0;
  if (options_.growth_rate)
    for (std::int32_t dj = -1; dj <= 1; ++dj)
      for (std::int32_t di = -1; di <= 1; ++di)
        if (di != 0 || dj != 0) around += map_.value({cell.i + di, cell.j + dj}).certainty;
  return std::min(map_.value(cell).certainty + options_.increment + around / 2, HimmCell::max_certainty);
}

/// False when the memory limit forbids it; no certainty has changed then.
bool Himm::apply(const Beam& beam) {
  if (!within_reach(Arc::circular(beam.origin, Angle{}, beam.length_m, degrees(1.0)), map_.geometry(),
                    map_.memory_limit_bytes()))
    return false;
  const std::vector<Cell> passed = passed_cells(beam);
  if (beam.hits && !map_.ensure(Map::tile_of(beam.end))) return false;
  for (const Cell cell : passed)
    if (!map_.ensure(Map::tile_of(cell))) return false;
  const int at_end = raised(beam.end);  // from the neighbours as they were before this reading
  for (const Cell cell : passed) map_.at(cell) = {std::uint8_t(lowered(cell)), 1};
  if (beam.hits) map_.at(beam.end) = {std::uint8_t(at_end), 1};
  return true;
}

void Himm::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) {
    if (const auto beam = beam_of(reading)) {
      ++(apply(*beam) ? counters_.used : counters_.memory_limit);
      continue;
    }
    ++counters_.no_information;
    const bool informative = echo_range_m(reading.outcome) || is_no_echo(reading.outcome);
    bistatic_ += informative && !reading.monostatic() ? 1 : 0;
  }
}

Result<MapExport> Himm::export_map() const {
  const auto state = [&](Cell, HimmCell cell) {
    if (cell.certainty >= options_.threshold) return CellState::occupied;
    return cell.certainty == 0 ? CellState::free : CellState::unknown;
  };
  return export_grid<std::uint16_t>(map_, name, state, [](HimmCell cell) { return std::uint16_t{cell.certainty}; });
}

Trace Himm::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading);
  const auto beam = beam_of(reading);
  if (!beam) return trace;
  const auto add = [&](Cell cell, int after, std::string_view term, int amount) {
    trace.cells.push_back({cell,
                           map_.geometry().centre(cell),
                           double(map_.value(cell).certainty),
                           double(after),
                           {{term, double(amount), ""}}});
  };
  if (!within_reach(Arc::circular(beam->origin, Angle{}, beam->length_m, degrees(1.0)), map_.geometry(),
                    map_.memory_limit_bytes()))
    return trace;
  for (const Cell cell : passed_cells(*beam)) add(cell, lowered(cell), "decrement", options_.decrement);
  if (beam->hits) add(beam->end, raised(beam->end), "increment", options_.increment);
  return trace;
}

bool Himm::supports(const Reading& reading, Vec2 position) const {
  const auto beam = beam_of(reading);
  return beam && beam->hits && map_.geometry().cell_of(position) == beam->end;
}

std::vector<std::byte> Himm::save() const {
  ByteWriter out;
  save_head<Himm>(out, options_, counters_);
  out.put(bistatic_);
  map_.save(out);
  return std::move(out).take();
}

Result<Himm> Himm::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Himm>(in, options, counters)) return damaged_state(name);
  Himm method(options);
  method.counters_ = counters;
  method.bistatic_ = in.get<std::uint64_t>();
  if (!restore_grid(in, method.map_) || !in.done()) return damaged_state(name);
  bool sound = true;
  method.map_.for_each_nonzero(
      [&](Cell, HimmCell cell) { sound = sound && cell.certainty <= HimmCell::max_certainty && cell.visited == 1; });
  if (!sound) return damaged_state(name);
  return method;
}

}  // namespace echoarc
