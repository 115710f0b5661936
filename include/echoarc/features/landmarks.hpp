// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/features/depth_regions.hpp"
#include "echoarc/features/feature.hpp"

/// Walls, corners and edges out of regions of constant depth seen from several positions ([Choset03] II-C).
namespace echoarc {

/// The wall n.x = H that fits n.S_k + r_k = H best.
struct WallFit {
  Vec2 normal;  ///< unit, from the robot to the wall
  double distance_m = 0.0;
  double rms_m = 0.0;
};
/// The point C that fits |C - S_k| = r_k best.
struct PointFit {
  Vec2 position;
  double rms_m = 0.0;
};

/// Least squares by Gauss-Newton, from the mean of the normals. At least two regions.
[[nodiscard]] WallFit fit_wall(std::span<const DepthRegion> regions);
/// Least squares by Gauss-Newton, from the mean of the echo points. At least two regions.
[[nodiscard]] PointFit fit_point(std::span<const DepthRegion> regions);

/// What one landmark is made of.
struct LandmarkTrack {
  std::vector<DepthRegion> regions;  ///< in order of time, one per position
  int wall_votes = 0;
  int point_votes = 0;
};

/// Follows regions from position to position. Every position from the third on votes for the hypothesis, wall or point,
/// that leaves `vote_ratio` times less over; the majority decides.
class Landmarks {
 public:
  /// Regions kept per landmark, the newest ones: fits stay quick however long a wall is followed.
  static constexpr std::size_t max_regions = 64;

  explicit Landmarks(DepthRegionOptions options = {}) : options_(options) {}

  /// Readings in the order of time. Those of one place of the robot are one sweep, wherever it looks; of a bearing that
  /// is met again within a quarter of a degree the newest counts.
  void insert(std::span<const Reading> readings);
  /// The regions of one position.
  void insert(const std::vector<DepthRegion>& regions);
  /// Walls, corners, edges and what cannot be told apart; without what lies behind a wall (multiple reflections). The
  /// sweep that is under way is part of it.
  [[nodiscard]] std::vector<Feature> features() const;
  [[nodiscard]] std::span<const LandmarkTrack> tracks() const { return tracks_; }
  /// Sweeps finished so far.
  [[nodiscard]] std::uint64_t sweeps() const { return sweeps_; }

 private:
  void hear(const DepthReturn& heard);
  void end_sweep();
  void follow(const DepthRegion& region, std::size_t known);

  DepthRegionOptions options_;
  std::vector<LandmarkTrack> tracks_;
  std::optional<Vec2> place_;  ///< of the sweep under way
  std::vector<DepthReturn> sweep_;
  std::uint64_t sweeps_ = 0;
};

}  // namespace echoarc
