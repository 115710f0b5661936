// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/centerline.hpp"

#include <algorithm>

#include "mapping/counted_arc.hpp"
#include "mapping/point_export.hpp"
#include "mapping/saved_state.hpp"

namespace echoarc {
namespace {

constexpr std::size_t point_bytes = sizeof(MapPoint) + sizeof(PingId);

MapPoint middle_of(const Arc& arc, const Reading& reading) {
  MapPoint point;
  point.position = arc.midpoint();
  point.label = PointLabel::centerline;
  point.bound_m = std::max(norm(arc.point_at(arc.t_begin()) - point.position),
                           norm(arc.point_at(arc.t_end()) - point.position));  // circle: 2 r sin(beam / 4)
  point.time_s = reading.time_s;
  point.sensor = reading.rx;
  point.ping = reading.ping;
  return point;
}

}  // namespace

void Centerline::insert(std::span<const Reading> readings, Executor& /*executor*/) {
  for (const Reading& reading : readings) {
    const auto arc = counted_arc(reading, options_.beam_policy, counters_);
    if (!arc) continue;
    if ((map_.size() + 1) * point_bytes > memory_limit_bytes(options_)) {
      ++counters_.memory_limit;
      continue;
    }
    map_.add(middle_of(*arc, reading), std::span<const PingId>(&reading.ping, 1));
    ++counters_.used;
  }
}

Result<MapExport> Centerline::export_map() const {
  return export_points(map_, options_, name);
}

Trace Centerline::trace(const Reading& reading) const {
  Trace trace;
  trace.arc = arc_of(reading, options_.beam_policy);
  if (trace.arc) trace.points.push_back(trace.arc->midpoint());
  return trace;
}

bool Centerline::supports(const Reading& reading, Vec2 position) const {
  const auto arc = arc_of(reading, options_.beam_policy);
  return arc && norm(arc->midpoint() - position) <= eps_length_m;
}

std::vector<std::byte> Centerline::save() const {
  ByteWriter out;
  save_head<Centerline>(out, options_, counters_);
  out.put<std::uint64_t>(map_.size());
  for (const MapPoint& point : map_.points()) {
    out.put(point.position);
    out.put(point.bound_m);
    out.put(point.time_s);
    out.put(point.ping);
    out.put<std::uint64_t>(point.sensor);
  }
  return std::move(out).take();
}

Result<Centerline> Centerline::restore(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Options options;
  InsertCounters counters;
  if (!restore_head<Centerline>(in, options, counters)) return damaged_state(name);
  Centerline method(options);
  method.counters_ = counters;
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    MapPoint point;
    point.position = in.get<Vec2>();
    point.bound_m = in.get<double>();
    point.time_s = in.get<double>();
    point.ping = in.get<PingId>();
    point.sensor = static_cast<SensorId>(in.get<std::uint64_t>());
    if (!is_finite(point.position)) return damaged_state(name);
    method.map_.add(point, std::span<const PingId>(&point.ping, 1));
  }
  if (!in.done()) return damaged_state(name);
  return method;
}

}  // namespace echoarc
