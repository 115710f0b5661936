// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/saved_history.hpp"

#include <algorithm>
#include <cmath>

#include "mapping/saved_points.hpp"

namespace echoarc::consensus {

void save_history(ByteWriter& out, const History& history, std::size_t context) {
  history.arcs.save(out);
  const std::size_t settled = std::min(history.settled, context);
  out.put<std::uint64_t>(settled);
  for (const EchoEstimate& estimate : std::span(history.estimates).first(settled)) {
    out.put(estimate.t);
    out.put(estimate.p);
    out.put(estimate.bound_m);
    out.put(estimate.wall_share);
    out.put(estimate.evidence);
  }
  out.put_vector(history.path);
  out.put_vector(history.path_arcs);
  history.looks.save(out);
}

namespace {

bool restore_estimates(ByteReader& in, History& history) {
  history.settled = in.get<std::uint64_t>();
  for (std::size_t i = 0; i < history.settled && in.ok(); ++i) {
    EchoEstimate estimate;
    estimate.t = in.get<Angle>();
    estimate.p = in.get<double>();
    estimate.bound_m = in.get<double>();
    estimate.wall_share = in.get<double>();
    estimate.evidence = in.get<double>();
    const bool shares =
        estimate.p >= 0.0 && estimate.p <= 1.0 && estimate.wall_share >= 0.0 && estimate.wall_share <= 1.0;
    if (!shares || !(abs(estimate.t) <= widest_search) || !(estimate.bound_m >= 0.0) ||
        !std::isfinite(estimate.bound_m) || !std::isfinite(estimate.evidence))
      return false;
    history.estimates.push_back(estimate);
  }
  return in.ok() && history.settled <= history.arcs.size();
}

}  // namespace

bool restore_history(ByteReader& in, History& history) {
  if (!history.arcs.restore(in) || !restore_estimates(in, history)) return false;
  history.path = in.get_vector<Vec2>();
  history.path_arcs = in.get_vector<std::uint32_t>();
  return history.looks.restore(in) && history.path.size() == history.path_arcs.size() &&
         std::ranges::all_of(history.path, [](Vec2 p) { return is_finite(p); }) &&
         std::ranges::is_sorted(history.path_arcs) &&
         (history.path_arcs.empty() || history.path_arcs.back() <= history.arcs.size());
}

void save_final_map(ByteWriter& out, const PointMap& map, const MapSize& size) {
  save_first_points(out, map, size.points);
  for (const PointBelief& belief : map.beliefs().first(size.points)) {
    out.put(belief.normal);
    out.put(belief.probability);
    out.put<std::uint8_t>(belief.provisional ? 1 : 0);
  }
  out.put<std::uint64_t>(size.segments);
  for (const MapSegment& segment : map.segments().first(size.segments)) {
    out.put(segment.begin);
    out.put(segment.end);
    out.put<std::uint8_t>(static_cast<std::uint8_t>(segment.label));
    out.put(segment.sensor);
    out.put(segment.ping);
  }
}

namespace {

bool restore_segments(ByteReader& in, PointMap& map) {
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    MapSegment segment;
    segment.begin = in.get<Vec2>();
    segment.end = in.get<Vec2>();
    const auto label = in.get<std::uint8_t>();
    segment.label = static_cast<PointLabel>(label);
    segment.sensor = in.get<SensorId>();
    segment.ping = in.get<PingId>();
    if (!in.ok() || label >= point_label_count || !is_finite(segment.begin) || !is_finite(segment.end)) return false;
    map.add(segment);
  }
  return in.ok();
}

}  // namespace

bool restore_final_map(ByteReader& in, PointMap& map) {
  PointMap points;
  if (!restore_first_points(in, points)) return false;
  for (const MapPoint& point : points.points()) {
    PointBelief belief;
    belief.normal = in.get<Vec2>();
    belief.probability = in.get<double>();
    belief.provisional = in.get<std::uint8_t>() != 0;
    if (!in.ok() || !is_finite(belief.normal) || !(belief.probability >= 0.0) || !(belief.probability <= 1.0))
      return false;
    map.add(point, points.support(point), belief);
  }
  return restore_segments(in, map);
}

}  // namespace echoarc::consensus
