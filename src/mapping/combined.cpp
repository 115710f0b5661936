// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/combined.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "echoarc/mapping/atm.hpp"
#include "mapping/carved_ring.hpp"
#include "mapping/point_export.hpp"
#include "mapping/saved_points.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

constexpr std::size_t point_bytes = sizeof(MapPoint) + 3 * sizeof(PingId);

}  // namespace

/// One ring for both: arcs as measured, what carving left of them, where they cross.
class Combined::State {
 public:
  explicit State(const Options& options)
      : ring(std::size_t(options.history), options.guard_m), medians(transversal_rule_of(options)) {}

  [[nodiscard]] std::size_t memory_bytes() const {
    return ring.memory_bytes() + ring.history().size() * TransversalMedians::arc_bytes + medians.memory_bytes();
  }

  CarvedRing ring;
  TransversalMedians medians;
  std::uint64_t unprocessed = 0;
};

Combined::Combined(Options options) : options_(options), state_(std::make_unique<State>(options)) {}
Combined::Combined(Combined&&) noexcept = default;
Combined& Combined::operator=(Combined&&) noexcept = default;
Combined::~Combined() = default;

void Combined::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  map_.truncate(archived_);
  for (const Reading& reading : readings) {
    if (!options_.carve_with_timeouts || !is_no_echo(reading.outcome))
      take_echo(reading);
    else if (state_->ring.carve_silence(reading, options_.beam_policy, options_.max_range_m))
      ++counters_.used;
    else
      ++counters_.no_information;
  }
}

void Combined::take_echo(const Reading& reading) {
  const auto arc = carvable_arc(reading, options_.beam_policy, options_.max_range_m, counters_);
  if (!arc) return;
  const std::size_t needed = (archived_ + 2) * point_bytes + state_->memory_bytes();
  if (!ArcHistory::is_storable(*arc) || needed > memory_limit_bytes(options_)) {
    ++counters_.memory_limit;
    return;
  }
  CarvedRing& ring = state_->ring;
  if (const auto oldest = ring.history().leaving(reading.rx)) let_go(*oldest);
  ring.carve(*arc, reading);
  const ArcSlot slot = ring.enter(*arc, reading);
  state_->medians.insert(ring.history(), slot, ring.carver().met());
  if (options_.history == 0) let_go(slot);
  ++counters_.used;
}

/// The points that an arc gives as things stand.
void Combined::add_points(ArcSlot slot) {
  const Remains& remains = state_->ring.remains(slot);
  const auto median =
      atm_point(options_.variant, state_->ring.history(), state_->medians, slot, options_.small_d_center);
  const bool has_median = median && median->point.label == PointLabel::atm;
  if (has_median) map_.add(median->point, std::span(median->support).first(median->support_count));
  const bool shown_beside = options_.combine == Combine::both && remains.carved();
  if (!has_median || shown_beside) add_point(remains, error_limit_m(options_), map_);
}

ArcState Combined::state_of(ArcSlot slot) const {
  ArcState state = echoarc::state_of(state_->ring.remains(slot));
  state.crossed = state_->medians.median(state_->ring.history(), slot).count > 0;
  return state;
}

void Combined::visit_arcs(const ArcVisitor& visitor) const {
  for (const ArcSlot slot : state_->ring.history().in_time_order()) visitor(state_of(slot));
}

bool Combined::history_full() const {
  return state_->ring.history().full();
}

void Combined::let_go(ArcSlot slot) {
  if (watcher_) watcher_(state_of(slot));
  const Remains& remains = state_->ring.remains(slot);
  const bool crossed = state_->medians.median(state_->ring.history(), slot).count > 0;
  if (!crossed && !remains.dead && !remains.carved()) ++state_->unprocessed;
  if (options_.archive) {
    add_points(slot);
    archived_ = map_.size();
  }
  state_->medians.erase(slot);
  state_->ring.leave(slot);
}

void Combined::finish(Executor& /*executor*/) {
  map_.truncate(archived_);
  for (const ArcSlot slot : state_->ring.history().in_time_order()) add_points(slot);
}

Result<MapExport> Combined::export_map() const {
  return export_points(map_, options_, name);
}

std::vector<Tally> Combined::tallies() const {
  std::vector<Tally> tallies = state_->ring.carver().tallies();
  tallies.push_back({"unprocessed", state_->unprocessed});
  tallies.push_back({"pairs_left_out", state_->medians.pairs_left_out()});
  return tallies;
}

Trace Combined::trace(const Reading& reading) const {
  Trace trace;
  InsertCounters ignored;
  trace.arc = carvable_arc(reading, options_.beam_policy, options_.max_range_m, ignored);
  if (!trace.arc || !ArcHistory::is_storable(*trace.arc)) return trace;
  const TransversalMedian median = state_->medians.preview(state_->ring.history(), *trace.arc);
  const bool none = median.count == 0 || (options_.variant == AtmVariant::org && median.count == 2);
  trace.points.push_back(none ? trace.arc->midpoint() : trace.arc->point_at(median.t));
  return trace;
}

bool Combined::supports(const Reading& reading, Vec2 position) const {
  return on_carvable_arc(reading, options_.beam_policy, options_.max_range_m, position);
}

std::vector<std::byte> Combined::save() const {
  ByteWriter out;
  save_head<Combined>(out, options_, counters_);
  state_->ring.save(out);
  state_->medians.save(state_->ring.history(), out);
  out.put(state_->unprocessed);
  save_first_points(out, map_, archived_);
  return std::move(out).take();
}

Result<Combined> Combined::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Combined>(in, options, counters)) return damaged_state(name);
  Combined method(options);
  method.counters_ = counters;
  State& state = *method.state_;
  if (!state.ring.restore(in, options.beam_policy, options.max_range_m) ||
      !state.medians.restore(state.ring.history(), in))
    return damaged_state(name);
  state.unprocessed = in.get<std::uint64_t>();
  if (!restore_first_points(in, method.map_) || !in.done()) return damaged_state(name);
  method.archived_ = method.map_.size();
  InlineExecutor here;
  method.finish(here);
  return method;
}

}  // namespace echoarc
