// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/carver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace echoarc {
namespace {

/// A beam that an arc can have; `SensorArray` lets no other in, a hand-made reading may.
bool is_beam(Angle beam_width) {
  return beam_width > Angle{} && beam_width < degrees(180.0);
}

}  // namespace

void Carver::carve(const ArcHistory& history, const Arc& newer, const ArcSource& by) {
  const FreeSector sector(newer, guard_m_);
  const Vec2 margin{eps_length_m, eps_length_m};  // for other users of `met`, whose arcs may touch
  const Box near{sector.bounds().low - margin, sector.bounds().high + margin};
  history.unordered_candidates(near, candidates_);  // each is carved for itself
  for (const ArcSlot slot : candidates_) {
    if (is_spared(outlines_[slot], sector)) continue;
    apply(remains_[slot], sector, by);
    trace_outline(slot);
  }
}

void Carver::trace_outline(ArcSlot slot) {
  const Remains& remains = remains_[slot];
  outlines_[slot] = {remains.left.outline(), remains.arc().is_circular(), remains.dead};
}

void Carver::apply(Remains& older, const FreeSector& newer, const ArcSource& by) {
  const Carving carving = echoarc::carve(older.left, newer);
  switch (carving.outcome) {
    case CarveOutcome::unchanged: return;
    case CarveOutcome::removed_full:
      ++counts_.removed_full;
      older.dead = true;
      return;
    case CarveOutcome::removed_split:
      ++counts_.removed_split;
      older.dead = true;
      return;
    case CarveOutcome::carved: break;
  }
  if (!older.carved()) ++counts_.carved;
  if (carving.t_begin > older.arc().t_begin()) older.low_by = by;
  if (carving.t_end < older.arc().t_end()) older.high_by = by;
  older.left.set_limits(carving.t_begin, carving.t_end);
}

void Carver::admit(const ArcHistory& history, ArcSlot slot) {
  if (slot >= remains_.size()) {
    remains_.resize(slot + 1);
    outlines_.resize(slot + 1);
  }
  const ArcSource& own = history.source(slot);
  remains_[slot] = {CarvableArc(history.arc(slot)), history.box(slot), own, own, own, false};
  trace_outline(slot);
}

std::vector<Tally> Carver::tallies() const {
  return {{"carved", counts_.carved},
          {"removed_full", counts_.removed_full},
          {"removed_split", counts_.removed_split},
          {"left_history", counts_.left_history}};
}

void Carver::save(ByteWriter& out, ArcSlot slot) const {
  const Remains& remains = remains_[slot];
  out.put(remains.arc().t_begin());
  out.put(remains.arc().t_end());
  for (const ArcSource* by : {&remains.low_by, &remains.high_by}) {
    out.put(by->ping);
    out.put(by->time_s);
    out.put(by->sensor);
  }
  out.put<std::uint8_t>(remains.dead ? 1 : 0);
}

bool Carver::restore(ByteReader& in, ArcSlot slot) {
  Remains& remains = remains_[slot];
  const auto begin = in.get<Angle>();
  const auto end = in.get<Angle>();
  for (ArcSource* by : {&remains.low_by, &remains.high_by}) {
    by->ping = in.get<PingId>();
    by->time_s = in.get<double>();
    by->sensor = in.get<SensorId>();
  }
  remains.dead = in.get<std::uint8_t>() != 0;
  if (!in.ok() || !(begin >= remains.arc().t_begin() && begin < end && end <= remains.arc().t_end())) return false;
  remains.left.set_limits(begin, end);
  trace_outline(slot);
  return true;
}

void add_point(const Remains& remains, double max_error_m, PointMap& map) {
  const Arc& arc = remains.arc();
  const double error_m = echoarc::max_error_m(arc);
  if (remains.dead || error_m > max_error_m) return;
  std::array<PingId, 3> support{remains.own.ping};
  std::size_t count = 1;
  ArcSource newest = remains.own;
  for (const ArcSource& by : {remains.low_by, remains.high_by}) {
    const auto known = std::span(support).first(count);
    if (std::ranges::find(known, by.ping) != known.end()) continue;
    support[count++] = by.ping;
    if (by.time_s >= newest.time_s) newest = by;
  }
  map.add({.position = arc.point_at(0.5 * (arc.t_begin() + arc.t_end())),
           .label = remains.carved() ? PointLabel::carved : PointLabel::centerline,
           .bound_m = error_m,
           .time_s = newest.time_s,
           .sensor = newest.sensor,
           .ping = newest.ping},
          std::span(support).first(count));
}

std::optional<Arc> carvable_arc(const Reading& reading, BeamPolicy policy, double max_range_m,
                                InsertCounters& counters) {
  const auto range_m = echo_range_m(reading.outcome);
  if (!range_m || *range_m > max_range_m) {
    ++counters.no_information;
    return std::nullopt;
  }
  std::optional<Arc> arc;
  if (*range_m > 0.0 && is_beam(reading.beam_width)) arc = arc_of(reading, policy);
  if (!arc) ++counters.no_arc;
  return arc;
}

bool on_carvable_arc(const Reading& reading, BeamPolicy policy, double max_range_m, Vec2 position) {
  InsertCounters ignored;
  const auto arc = carvable_arc(reading, policy, max_range_m, ignored);
  return arc && std::abs(arc->half_path_m(position) - arc->range_m()) <= eps_length_m &&
         arc->contains_bearing(bearing(position - arc->centre()));
}

std::optional<Arc> silent_arc(const Reading& reading, BeamPolicy policy, double max_range_m) {
  if (!is_no_echo(reading.outcome) || !is_beam(reading.beam_width)) return std::nullopt;
  const double free_m = std::min({reading.trusted_range_m, reading.range_max_m, max_range_m});
  if (!(free_m > 0.0)) return std::nullopt;
  Reading heard = reading;
  heard.outcome = Echo{free_m};
  return arc_of(heard, policy);
}

}  // namespace echoarc
