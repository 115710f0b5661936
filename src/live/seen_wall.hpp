// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/eval/reference.hpp"
#include "echoarc/live/source.hpp"
#include "echoarc/maps/point_map.hpp"

namespace echoarc::live {

/// Whether a map has a point near: points in square cells as large as the distance.
class NearPoints {
 public:
  NearPoints(std::span<const MapPoint> points, double distance_m);
  [[nodiscard]] bool has(Vec2 p) const;

 private:
  double distance_m_;
  std::unordered_map<std::uint64_t, std::vector<Vec2>> cells_;
};

/// Which part of the true walls has been in sight of the robot, sample by sample.
class SeenWall {
 public:
  static constexpr double spacing_m = 0.05;

  explicit SeenWall(const SourceDescription& source);
  /// Looks around, unless the last look was nearer than `step_m`.
  void look_from(Vec2 eye, double step_m);
  /// Share of the samples seen that have a map point near; none before anything was seen.
  [[nodiscard]] std::optional<double> share_found(const NearPoints& points) const;

 private:
  std::shared_ptr<const sim::World> world_;
  double reach_m_ = 0.0;  ///< of the farthest sensor
  std::vector<Vec2> unseen_;
  std::vector<Vec2> seen_;
  std::optional<Vec2> last_eye_;
};

/// The surfaces that the lasers have seen so far, as `laser_reference` counts them.
class LaserCells {
 public:
  void add(const Scan& scan, const PoseTrack& track, std::span<const LaserMount> lasers);
  [[nodiscard]] bool empty() const { return surfaces_.empty(); }
  /// To the nearest surface.
  [[nodiscard]] double distance_m(Vec2 p);
  [[nodiscard]] std::optional<double> share_found(const NearPoints& points) const;

 private:
  LaserReferenceOptions options_;
  std::unordered_map<std::uint64_t, int> returns_;
  std::vector<Vec2> surfaces_;
  // An index over all surfaces but the newest; rebuilt when they are asked for.
  std::unique_ptr<PointSet> indexed_;
  std::unique_ptr<NearestPoints> nearest_;
};

}  // namespace echoarc::live
