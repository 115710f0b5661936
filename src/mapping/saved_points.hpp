// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <vector>

#include "echoarc/core/bytes.hpp"
#include "echoarc/maps/point_map.hpp"

/// Points in saved states.
namespace echoarc {

/// The first `count` points with their support.
inline void save_first_points(ByteWriter& out, const PointMap& map, std::size_t count) {
  out.put<std::uint64_t>(count);
  for (const MapPoint& point : map.points().first(count)) {
    out.put(point.position);
    out.put<std::uint8_t>(static_cast<std::uint8_t>(point.label));
    out.put(point.bound_m);
    out.put(point.time_s);
    out.put(point.sensor);
    out.put(point.ping);
    const auto support = map.support(point);
    out.put<std::uint32_t>(static_cast<std::uint32_t>(support.size()));
    out.put_all(support);
  }
}

/// False when the bytes are no points.
[[nodiscard]] inline bool restore_first_points(ByteReader& in, PointMap& map) {
  const auto count = in.get<std::uint64_t>();
  std::vector<PingId> support;
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    MapPoint point;
    point.position = in.get<Vec2>();
    const auto label = in.get<std::uint8_t>();
    point.label = static_cast<PointLabel>(label);
    point.bound_m = in.get<double>();
    point.time_s = in.get<double>();
    point.sensor = in.get<SensorId>();
    point.ping = in.get<PingId>();
    const auto pings = in.get<std::uint32_t>();
    support.clear();
    for (std::uint32_t p = 0; p < pings && in.ok(); ++p) support.push_back(in.get<PingId>());
    if (!in.ok() || label >= point_label_count || !is_finite(point.position)) return false;
    map.add(point, support);
  }
  return in.ok();
}

}  // namespace echoarc
