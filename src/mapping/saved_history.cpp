// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/saved_history.hpp"

#include <cmath>
#include <numbers>

namespace echoarc {

static_assert(sizeof(Arc) == 11 * sizeof(double), "an arc is written as it lies in memory, without padding");

bool is_plausible(const Arc& arc) {
  const double full_turn = 2.0 * std::numbers::pi;
  const bool ordered = arc.t_begin() <= arc.t_end() && abs(arc.t_begin()).rad() < full_turn &&
                       abs(arc.t_end()).rad() < full_turn && arc.half_width() > Angle{} &&
                       arc.half_width().rad() < full_turn && is_finite(arc.axis());
  return ordered && arc.range_m() > 0.0 && arc.semi_minor_m() > 0.0 && arc.semi_minor_m() <= arc.range_m() &&
         std::abs(norm(arc.focal_axis()) - 1.0) < 1e-6 && is_finite(arc.transmitter()) && ArcHistory::is_storable(arc);
}

void save_history(ByteWriter& out, const ArcHistory& history) {
  out.put<std::uint64_t>(history.size());
  for (const ArcSlot slot : history.in_time_order()) {
    const ArcSource& source = history.source(slot);
    out.put(history.arc(slot));
    out.put(source.ping);
    out.put(source.time_s);
    out.put<std::uint64_t>(source.sensor);
  }
}

bool restore_history(ByteReader& in, ArcHistory& history) {
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    const auto arc = in.get<Arc>();
    ArcSource source;
    source.ping = in.get<PingId>();
    source.time_s = in.get<double>();
    source.sensor = static_cast<SensorId>(in.get<std::uint64_t>());
    if (!in.ok() || !is_plausible(arc) || history.leaving(source.sensor)) return false;
    history.insert(arc, source);
  }
  return in.ok();
}

void save_points(ByteWriter& out, const PointMap& map) {
  out.put<std::uint64_t>(map.size());
  for (const MapPoint& point : map.points()) {
    out.put(point.position);
    out.put(point.bound_m);
    out.put(point.time_s);
    out.put(point.ping);
    out.put(point.sensor);
    out.put<std::uint8_t>(std::uint8_t(point.label));
    out.put<std::uint8_t>(std::uint8_t(point.support_count));
    out.put_all(map.support(point));
  }
}

bool restore_points(ByteReader& in, PointMap& map) {
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    MapPoint point;
    point.position = in.get<Vec2>();
    point.bound_m = in.get<double>();
    point.time_s = in.get<double>();
    point.ping = in.get<PingId>();
    point.sensor = in.get<SensorId>();
    const auto label = in.get<std::uint8_t>();
    std::array<PingId, 255> support{};
    const auto supports = std::span(support).first(in.get<std::uint8_t>());
    if (!in.get_all(supports) || label >= point_label_count || !is_finite(point.position)) return false;
    point.label = static_cast<PointLabel>(label);
    map.add(point, supports);
  }
  return in.ok();
}

}  // namespace echoarc
