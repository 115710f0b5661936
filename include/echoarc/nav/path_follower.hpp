// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/core/robot_motion.hpp"

namespace echoarc::nav {

struct PathFollowerOptions {
  double speed_m_s = 0.3;
  double look_ahead_m = 0.6;
  double arrival_m = 0.10;
  Angle turn_first = degrees(40.0);

  static constexpr auto fields() {
    using O = PathFollowerOptions;
    return std::tuple{
        field("speed_m_s", &O::speed_m_s, {.unit = "m/s", .min = 0.01, .max = 5.0, .doc = "along the path"}),
        field("look_ahead_m", &O::look_ahead_m,
              {.unit = "m", .min = 0.05, .max = 5.0, .doc = "how far ahead on the path the robot heads for"}),
        field("arrival_m", &O::arrival_m,
              {.unit = "m", .min = 0.01, .max = 2.0, .doc = "so near to its end the path has been driven"}),
        field("turn_first_deg", &O::turn_first,
              {.unit = "deg", .min = 1.0, .max = 180.0, .doc = "facing further away than this it turns on the spot"})};
  }
};

/// Where to head for now.
struct Following {
  Vec2 target;               ///< the point to head for, world, m
  double remaining_m = 0.0;  ///< along the path, at least as far as its end is away
  double off_path_m = 0.0;   ///< from the robot to the path
  bool arrived = false;
};

/// Follows a path by pure pursuit ([Coulter92]): heads for a point a little ahead on it. Progress never goes back, so
/// that a path that comes near itself is driven whole.
class PathFollower {
 public:
  /// Whether the straight way between two points is clear; without it every way is.
  using Sight = std::function<bool(Vec2, Vec2)>;

  explicit PathFollower(const PathFollowerOptions& options = {}) : options_(options) {}

  [[nodiscard]] const PathFollowerOptions& options() const { return options_; }
  void follow(std::vector<Vec2> path);
  [[nodiscard]] const std::vector<Vec2>& path() const { return path_; }
  [[nodiscard]] double along_m() const { return along_m_; }  ///< of the path that is driven
  /// The target is drawn in towards the robot until it is in sight. Without a path: arrived, at the robot's place.
  [[nodiscard]] Following update(const Pose2& T_world_base, const Sight& in_sight = {});

 private:
  PathFollowerOptions options_;
  std::vector<Vec2> path_;
  double length_m_ = 0.0;
  double along_m_ = 0.0;
};

/// Turns towards `target`, on the spot if it is far aside, else drives an arc through it; slow enough to stop after
/// `remaining_m` and to keep the limits of the turn.
[[nodiscard]] RobotVelocity steer_to(const Pose2& T_world_base, Vec2 target, double remaining_m,
                                     const RobotLimits& limits, const PathFollowerOptions& options);

}  // namespace echoarc::nav
