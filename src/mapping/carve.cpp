// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/carve.hpp"

#include <utility>

#include "mapping/carved_ring.hpp"
#include "mapping/point_export.hpp"
#include "mapping/saved_points.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

constexpr std::size_t point_bytes = sizeof(MapPoint) + 3 * sizeof(PingId);

}  // namespace

Carve::Carve(Options options)
    : options_(options), ring_(std::make_unique<CarvedRing>(std::size_t(options.history), options.guard_m)) {}
Carve::Carve(Carve&&) noexcept = default;
Carve& Carve::operator=(Carve&&) noexcept = default;
Carve::~Carve() = default;

void Carve::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  map_.truncate(archived_);
  for (const Reading& reading : readings) {
    if (!options_.carve_with_timeouts || !is_no_echo(reading.outcome))
      take_echo(reading);
    else if (ring_->carve_silence(reading, options_.beam_policy, options_.max_range_m))
      ++counters_.used;
    else
      ++counters_.no_information;
  }
}

void Carve::take_echo(const Reading& reading) {
  const auto arc = carvable_arc(reading, options_.beam_policy, options_.max_range_m, counters_);
  if (!arc) return;
  const std::size_t needed = (archived_ + 1) * point_bytes + ring_->memory_bytes();
  if (!ArcHistory::is_storable(*arc) || needed > memory_limit_bytes(options_)) {
    ++counters_.memory_limit;
    return;
  }
  if (const auto oldest = ring_->history().leaving(reading.rx)) let_go(*oldest);
  ring_->carve(*arc, reading);
  const ArcSlot slot = ring_->enter(*arc, reading);
  if (options_.history == 0) let_go(slot);
  ++counters_.used;
}

ArcState Carve::state_of(ArcSlot slot) const {
  return echoarc::state_of(ring_->remains(slot));
}

void Carve::visit_arcs(const ArcVisitor& visitor) const {
  for (const ArcSlot slot : ring_->history().in_time_order()) visitor(state_of(slot));
}

bool Carve::history_full() const {
  return ring_->history().full();
}

void Carve::let_go(ArcSlot slot) {
  if (watcher_) watcher_(state_of(slot));
  if (options_.archive) {
    add_point(ring_->remains(slot), error_limit_m(options_), map_);
    archived_ = map_.size();
  }
  ring_->leave(slot);
}

void Carve::finish(Executor& /*executor*/) {
  map_.truncate(archived_);
  for (const ArcSlot slot : ring_->history().in_time_order())
    add_point(ring_->remains(slot), error_limit_m(options_), map_);
}

Result<MapExport> Carve::export_map() const {
  return export_points(map_, options_, name);
}

std::vector<Tally> Carve::tallies() const {
  return ring_->carver().tallies();
}

Trace Carve::trace(const Reading& reading) const {
  Trace trace;
  InsertCounters ignored;
  trace.arc = carvable_arc(reading, options_.beam_policy, options_.max_range_m, ignored);
  if (trace.arc) trace.points.push_back(trace.arc->midpoint());
  return trace;
}

bool Carve::supports(const Reading& reading, Vec2 position) const {
  return on_carvable_arc(reading, options_.beam_policy, options_.max_range_m, position);
}

std::vector<std::byte> Carve::save() const {
  ByteWriter out;
  save_head<Carve>(out, options_, counters_);
  ring_->save(out);
  save_first_points(out, map_, archived_);
  return std::move(out).take();
}

Result<Carve> Carve::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Carve>(in, options, counters)) return damaged_state(name);
  Carve method(options);
  method.counters_ = counters;
  if (!method.ring_->restore(in, options.beam_policy, options.max_range_m) || !restore_first_points(in, method.map_) ||
      !in.done())
    return damaged_state(name);
  method.archived_ = method.map_.size();
  InlineExecutor here;
  method.finish(here);
  return method;
}

}  // namespace echoarc
