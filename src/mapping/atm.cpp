// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/atm.hpp"

#include <algorithm>
#include <cmath>

#include "echoarc/mapping/atm_resolution.hpp"
#include "mapping/counted_arc.hpp"
#include "mapping/point_export.hpp"
#include "mapping/saved_history.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

constexpr std::size_t point_bytes = sizeof(MapPoint) + 3 * sizeof(PingId);
// The hash keeps an arc in a few cells; 200 bytes are what it took on drives, with its tables' room to grow.
constexpr std::size_t hash_bytes_per_arc = 200;
constexpr std::size_t arc_bytes = sizeof(Arc) + sizeof(ArcSource) + sizeof(Box) + 2 * sizeof(std::uint64_t) +
                                  hash_bytes_per_arc + TransversalMedians::arc_bytes + point_bytes;

/// Half the arc's length, or `at_most` when that is less: quadrature is only done where it decides.
double half_length_or(const Arc& arc, double at_most) {
  const double angle = (arc.t_end() - arc.t_begin()).rad();
  if (at_most <= 0.5 * angle * arc.semi_minor_m()) return at_most;
  return std::min(at_most, 0.5 * arc.length_m());
}

SupportedPoint centre_point(const Arc& arc, const ArcSource& source) {
  SupportedPoint centre;
  MapPoint& point = centre.point;
  point.position = arc.midpoint();
  point.label = PointLabel::centerline;
  point.bound_m =
      std::max(norm(arc.point_at(arc.t_begin()) - point.position), norm(arc.point_at(arc.t_end()) - point.position));
  point.time_s = source.time_s;
  point.sensor = source.sensor;
  point.ping = source.ping;
  centre.support[centre.support_count++] = source.ping;
  return centre;
}

SupportedPoint median_point(const ArcHistory& history, ArcSlot slot, const TransversalMedian& median,
                            double interval_m) {
  const Arc& arc = history.arc(slot);
  SupportedPoint found;
  found.support[found.support_count++] = history.source(slot).ping;
  ArcSlot newest = slot;
  for (const ArcSlot partner : median.partners) {
    const PingId ping = history.source(partner).ping;
    if (found.support_count == 2 && found.support[1] == ping) continue;
    found.support[found.support_count++] = ping;
    if (history.sequence(partner) > history.sequence(newest)) newest = partner;
  }
  found.point.position = arc.point_at(median.t);
  found.point.label = PointLabel::atm;
  found.point.bound_m = half_length_or(arc, 0.5 * interval_m);
  found.point.time_s = history.source(newest).time_s;
  found.point.sensor = history.source(newest).sensor;
  found.point.ping = history.source(newest).ping;
  return found;
}

enum class Row { nothing, centre, median };

/// The table of the three papers.
Row row_of(AtmVariant variant, std::size_t crossings) {
  if (crossings == 0) return variant == AtmVariant::mod ? Row::nothing : Row::centre;
  if (crossings == 2 && variant == AtmVariant::org) return Row::nothing;
  return Row::median;
}

/// Whether a crossing would leave an interval no shorter than the arc ([Choset03] IV-B).
bool too_near(const Arc& arc, double interval_m) {
  return interval_m >= arc.range_m() * (arc.t_end() - arc.t_begin()).rad();
}

double interval_of(const TransversalMedians& medians, const Arc& arc) {
  return crossing_interval_m(medians.rule().range_quantum_m, medians.least_angle(arc));
}

}  // namespace

std::optional<SupportedPoint> atm_point(AtmVariant variant, const ArcHistory& history,
                                        const TransversalMedians& medians, ArcSlot slot, bool small_d_center) {
  const Arc& arc = history.arc(slot);
  const double interval_m = interval_of(medians, arc);
  if (small_d_center && too_near(arc, interval_m)) return centre_point(arc, history.source(slot));
  const TransversalMedian median = medians.median(history, slot);
  const Row row = row_of(variant, median.count);
  if (row == Row::nothing) return std::nullopt;
  return row == Row::centre ? centre_point(arc, history.source(slot)) : median_point(history, slot, median, interval_m);
}

template <AtmVariant variant>
Atm<variant>::Atm(Options options)
    : options_(options),
      history_(options.history, std::size_t(std::max(1, options.history_arcs))),
      medians_(transversal_rule_of(options)) {}

template <AtmVariant variant>
std::size_t Atm<variant>::memory_bytes() const {
  return history_.size() * arc_bytes + medians_.memory_bytes() + archive_.size() * 2 * point_bytes;
}

template <AtmVariant variant>
ArcState Atm<variant>::state_of(ArcSlot slot) const {
  return {
      .arc = history_.arc(slot), .source = history_.source(slot), .crossed = medians_.median(history_, slot).count > 0};
}

template <AtmVariant variant>
void Atm<variant>::visit_arcs(const ArcVisitor& visitor) const {
  for (const ArcSlot slot : history_.in_time_order()) visitor(state_of(slot));
}

template <AtmVariant variant>
bool Atm<variant>::history_full() const {
  return history_.full();
}

template <AtmVariant variant>
void Atm<variant>::see_off(ArcSlot slot) {
  if (watcher_) watcher_(state_of(slot));
  if (options_.archive)
    if (const auto last = point_of(slot))
      archive_.add(last->point, std::span(last->support).first(last->support_count));
  medians_.erase(slot);
  history_.evict(slot);
}

template <AtmVariant variant>
void Atm<variant>::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) {
    const auto arc = counted_arc(reading, options_.beam_policy, counters_);
    if (!arc) continue;
    if (!ArcHistory::is_storable(*arc)) {
      ++counters_.no_arc;
      continue;
    }
    if (memory_bytes() + arc_bytes > memory_limit_bytes(options_)) {
      ++counters_.memory_limit;
      continue;
    }
    if (const auto oldest = history_.leaving(reading.rx)) see_off(*oldest);
    medians_.insert(history_, history_.insert(*arc, {reading.ping, reading.time_s, reading.rx}));
    ++counters_.used;
  }
}

template <AtmVariant variant>
void Atm<variant>::finish(Executor& /*executor*/) {
  map_ = archive_;
  for (const ArcSlot slot : history_.in_time_order())
    if (const auto found = point_of(slot))
      map_.add(found->point, std::span(found->support).first(found->support_count));
}

template <AtmVariant variant>
Result<MapExport> Atm<variant>::export_map() const {
  return export_points(map_, options_, name);
}

template <AtmVariant variant>
std::vector<Tally> Atm<variant>::tallies() const {
  std::size_t with_median = 0;
  for (const MapPoint& point : map_.points()) with_median += point.label == PointLabel::atm ? 1 : 0;
  return {{"points_atm", with_median},
          {"points_centerline", map_.size() - with_median},
          {"pairs_left_out", medians_.pairs_left_out()}};
}

template <AtmVariant variant>
Trace Atm<variant>::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  if (!trace.arc || !ArcHistory::is_storable(*trace.arc)) return trace;
  const Arc& arc = *trace.arc;
  const TransversalMedian median = medians_.preview(history_, arc);
  const bool near = options_.small_d_center && too_near(arc, interval_of(medians_, arc));
  const Row row = near ? Row::centre : row_of(variant, median.count);
  if (row != Row::nothing) trace.points.push_back(row == Row::centre ? arc.midpoint() : arc.point_at(median.t));
  return trace;
}

template <AtmVariant variant>
bool Atm<variant>::supports(const Reading& reading, Vec2 position) const {
  const auto arc = arc_of(reading, options_.beam_policy);
  return arc && std::abs(arc->half_path_m(position) - arc->range_m()) <= eps_length_m &&
         arc->contains_bearing(bearing(position - arc->centre()));
}

template <AtmVariant variant>
std::vector<std::byte> Atm<variant>::save() const {
  ByteWriter out;
  save_head<Atm>(out, options_, counters_);
  save_history(out, history_);
  medians_.save(history_, out);
  save_points(out, archive_);
  return std::move(out).take();
}

template <AtmVariant variant>
Result<Atm<variant>> Atm<variant>::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Atm>(in, options, counters)) return damaged_state(name);
  Atm method(options);
  method.counters_ = counters;
  if (!restore_history(in, method.history_) || !method.medians_.restore(method.history_, in) ||
      !restore_points(in, method.archive_) || !in.done())
    return damaged_state(name);
  InlineExecutor executor;
  method.finish(executor);
  return method;
}

template class Atm<AtmVariant::org>;
template class Atm<AtmVariant::mod>;
template class Atm<AtmVariant::silver>;

}  // namespace echoarc
