// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/core/reading.hpp"

namespace echoarc {

/// What made a map point.
enum class PointLabel : std::uint8_t {
  centerline,    ///< the middle of an arc: nothing but the reading is known
  cell,          ///< the centre of an occupied grid cell
  carved,        ///< the middle of what newer readings left of an arc
  atm,           ///< the median of an arc's transversal intersections
  edge,          ///< where several arcs meet in one point: an edge or a pole
  triangulated,  ///< where arcs meet, but not in one point: a wall, most likely
  wall,          ///< where a wall touches an arc, by the consensus of arcs
  point,         ///< where a corner, an edge or a pole lies on an arc, by the consensus of arcs
  link,          ///< between two such points with nothing that speaks against a wall
  zone,          ///< what a wall must reach to for its echo to be heard
  weak,          ///< likelier than anywhere else on its arc, where the map has nothing else
};
inline constexpr std::size_t point_label_count = 11;
/// As files spell it.
[[nodiscard]] constexpr std::string_view name(PointLabel label) {
  constexpr std::string_view names[point_label_count] = {
      "centerline", "cell", "carved", "atm", "edge", "triangulated", "wall", "point", "link", "zone", "weak"};
  return names[static_cast<std::size_t>(label)];
}

struct MapPoint {
  Vec2 position;  ///< world, metres
  PointLabel label = PointLabel::centerline;
  double bound_m = 0.0;  ///< upper bound on the distance from the true reflecting point, if the reading is no outlier
  double time_s = 0.0;   ///< of the newest supporting ping; NaN for a cell
  SensorId sensor = 0;   ///< receiver of that ping
  PingId ping = 0;
  std::uint32_t support_begin = 0;  ///< see `PointMap::support`
  std::uint32_t support_count = 0;
};

/// What some methods know of a point besides.
struct PointBelief {
  Vec2 normal;               ///< unit vector out of the surface, towards the sensor
  double probability = 1.0;  ///< that the point is where its method says
  bool provisional = false;  ///< what follows may still move or remove it
  friend bool operator==(const PointBelief&, const PointBelief&) = default;
};

/// A straight piece of surface that a map claims between or beside its points. Scores by cell and pictures draw it; the
/// points themselves do not depend on it.
struct MapSegment {
  Vec2 begin;  ///< world, metres
  Vec2 end;
  PointLabel label = PointLabel::link;
  SensorId sensor = 0;  ///< receiver of the newest ping behind it
  PingId ping = 0;
  friend bool operator==(const MapSegment&, const MapSegment&) = default;
};

/// Points with the pings that speak for them, and the pieces of surface between them.
class PointMap {
 public:
  void add(MapPoint point, std::span<const PingId> support = {}) {
    point.support_begin = static_cast<std::uint32_t>(support_.size());
    point.support_count = static_cast<std::uint32_t>(support.size());
    support_.insert(support_.end(), support.begin(), support.end());
    points_.push_back(point);
  }
  /// The same with a belief; a map has one for each of its points or for none.
  void add(MapPoint point, std::span<const PingId> support, const PointBelief& belief) {
    add(point, support);
    beliefs_.push_back(belief);
  }
  void add(const MapSegment& segment) { segments_.push_back(segment); }
  /// Keeps the first `count` segments.
  void truncate_segments(std::size_t count) { segments_.resize(std::min(count, segments_.size())); }
  /// Keeps the first `count` points; segments stay.
  void truncate(std::size_t count) {
    if (count >= points_.size()) return;
    support_.resize(points_[count].support_begin);
    points_.resize(count);
    if (count < beliefs_.size()) beliefs_.resize(count);
  }
  [[nodiscard]] std::span<const MapPoint> points() const { return points_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool empty() const { return points_.empty(); }
  /// One a point in the same order, or empty.
  [[nodiscard]] std::span<const PointBelief> beliefs() const { return beliefs_; }
  [[nodiscard]] std::span<const MapSegment> segments() const { return segments_; }
  /// Ids of the pings behind a point of this map; empty for cells, whose support is found by replay.
  [[nodiscard]] std::span<const PingId> support(const MapPoint& point) const {
    return std::span<const PingId>(support_).subspan(point.support_begin, point.support_count);
  }

 private:
  std::vector<MapPoint> points_;
  std::vector<PingId> support_;
  std::vector<PointBelief> beliefs_;
  std::vector<MapSegment> segments_;
};

}  // namespace echoarc
