// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <span>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/core/robot_motion.hpp"

namespace echoarc::nav {

/// The way a disc can go on its motion arc until its rim meets the first of the points it was told of. The disc's
/// centre is the origin of its base; forward speed and turning rate, held, make the arc: a circle of radius v/omega, or
/// a line. What lies within the disc already counts for motions towards it alone. A turn on the spot is always free,
/// and so is a motion that is no number; from a pose that is no number there is no free way at all.
class FreeWay {
 public:
  FreeWay(const Pose2& T_world_base, const RobotVelocity& velocity, double hull_radius_m, double look_m);

  /// Takes note of an obstacle, world, m. What is no number is none.
  void meet(Vec2 point);
  /// From the rim, m, less than `look_m`; none: nothing stands in it.
  [[nodiscard]] std::optional<double> free_m() const;

 private:
  Vec2 position_;
  Vec2 axis_;            // towards where the disc goes, world
  double turn_m_ = 0.0;  // signed radius of the circle as seen by who looks along `axis_`; left is positive
  double hull_radius_m_;
  double look_m_;
  double nearest_m_;
  bool moving_ = false;
  bool straight_ = false;
};

/// The free way of a disc from its rim along its motion arc, m, at the most `look_m`; none: nothing stands in it.
/// See `FreeWay`. `points` are obstacles, world, m.
[[nodiscard]] std::optional<double> free_way_m(const Pose2& T_world_base, const RobotVelocity& velocity,
                                               double hull_radius_m, std::span<const Vec2> points, double look_m = 3.0);

/// Whether the robot must stop at once: a point lies within `margin_m` of its hull, and the motion draws nearer to it.
/// A turn on the spot draws nearer to nothing.
[[nodiscard]] bool emergency(const Pose2& T_world_base, const RobotVelocity& velocity, double hull_radius_m,
                             std::span<const Vec2> points, double margin_m = 0.05);

/// How much room a robot that steers itself keeps ahead of it.
struct SafetyOptions {
  double stop_distance_m = 0.10;
  double emergency_m = 0.05;
  double deceleration_m_s2 = 0.3;

  static constexpr auto fields() {
    using O = SafetyOptions;
    return std::tuple{
        field("stop_distance_m", &O::stop_distance_m,
              {.unit = "m", .min = 0.0, .max = 1.0, .doc = "kept between hull and obstacle ahead"}),
        field("emergency_m", &O::emergency_m,
              {.unit = "m", .min = 0.0, .max = 1.0, .doc = "what is nearer to the hull is not driven at"}),
        field("deceleration_m_s2", &O::deceleration_m_s2,
              {.unit = "m/s^2", .min = 1e-3, .max = 100.0, .doc = "that the speed cap counts with"})};
  }
};

/// `wanted`, its forward speed lowered until the robot can come to rest in the free way of the arc it then drives on;
/// zero in an emergency. The turning rate stays: to turn on the spot is always safe for a disc.
[[nodiscard]] RobotVelocity safe_velocity(const Pose2& T_world_base, const RobotVelocity& wanted, double hull_radius_m,
                                          std::span<const Vec2> points, const SafetyOptions& options = {});

}  // namespace echoarc::nav
