// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/voting.hpp"

#include "mapping/counted_arc.hpp"
#include "mapping/grid_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {

Voting::Voting(Options options)
    : options_(options), votes_(geometry_of(options), memory_limit_bytes(options), options.sampling) {}

void Voting::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings)
    if (const auto arc = counted_arc(reading, options_.beam_policy, counters_))
      ++(votes_.add(*arc) ? counters_.used : counters_.memory_limit);
  votes_.settle();
}

Result<MapExport> Voting::export_map() const {
  const auto state = [&](Cell, std::uint16_t count) {
    return count >= options_.threshold ? CellState::occupied : CellState::unknown;
  };
  return export_grid<std::uint16_t>(map(), name, state, [](std::uint16_t count) { return count; });
}

Trace Voting::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  if (trace.arc) trace.cells = votes_.changes(*trace.arc);
  return trace;
}

bool Voting::supports(const Reading& reading, Vec2 position) const {
  const auto arc = arc_of(reading, options_.beam_policy);
  return arc && votes_.crosses(*arc, position);
}

std::vector<std::byte> Voting::save() const {
  ByteWriter out;
  save_head<Voting>(out, options_, counters_);
  votes_.save(out);
  return std::move(out).take();
}

Result<Voting> Voting::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Voting>(in, options, counters)) return damaged_state(name);
  Voting method(options);
  method.counters_ = counters;
  if (!method.votes_.restore(in) || !in.done()) return damaged_state(name);
  return method;
}

}  // namespace echoarc
