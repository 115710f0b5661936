// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/morphological_processing.hpp"

#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {

MorphologicalProcessing::MorphologicalProcessing(Options options)
    : options_(options), map_{VoteGrid(geometry_of(options), memory_limit_bytes(options), options.sampling), {}} {}

void MorphologicalProcessing::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings)
    if (const auto arc = counted_arc(reading, options_.beam_policy, counters_))
      ++(map_.votes.add(*arc) ? counters_.used : counters_.memory_limit);
  map_.votes.settle();
  finished_ = finished_ && readings.empty();
}

void MorphologicalProcessing::finish(Executor& /*executor*/) {
  thin();
  finished_ = true;
}

void MorphologicalProcessing::thin() {
  map_.kept = TiledBits(map_.votes.counts(), [](std::uint16_t arcs) { return arcs != 0; });
  for (int pass = 0; pass < options_.passes; ++pass) {
    TiledBits thinned = map_.kept.thinned(options_.neighbours);
    const bool stable = thinned == map_.kept;
    map_.kept = std::move(thinned);
    if (stable) return;
  }
}

Result<MapExport> MorphologicalProcessing::export_map() const {
  const auto state = [&](Cell cell, std::uint16_t) {
    return map_.kept.at(cell) ? CellState::occupied : CellState::unknown;
  };
  return export_grid<std::uint16_t>(map_.votes.counts(), name, state, [](std::uint16_t count) { return count; });
}

Trace MorphologicalProcessing::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  if (trace.arc) trace.cells = map_.votes.changes(*trace.arc);
  return trace;
}

bool MorphologicalProcessing::supports(const Reading& reading, Vec2 position) const {
  const auto arc = arc_of(reading, options_.beam_policy);
  return arc && map_.votes.crosses(*arc, position);
}

std::vector<std::byte> MorphologicalProcessing::save() const {
  ByteWriter out;
  save_head<MorphologicalProcessing>(out, options_, counters_);
  out.put<std::uint8_t>(finished_ ? 1 : 0);
  map_.votes.save(out);
  return std::move(out).take();
}

Result<MorphologicalProcessing> MorphologicalProcessing::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<MorphologicalProcessing>(in, options, counters)) return damaged_state(name);
  MorphologicalProcessing method(options);
  method.counters_ = counters;
  method.finished_ = in.get<std::uint8_t>() == 1;
  if (!method.map_.votes.restore(in) || !in.done()) return damaged_state(name);
  if (method.finished_) method.thin();
  return method;
}

}  // namespace echoarc
