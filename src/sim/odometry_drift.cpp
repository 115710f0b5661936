// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/odometry_drift.hpp"

#include <cmath>

#include "sim/random_streams.hpp"

namespace echoarc::sim {

OdometryDrift::OdometryDrift(const OdometryOptions& options, std::uint64_t seed, const Pose2& T_world_start)
    : options_(options), seed_(seed), T_world_before_(T_world_start), T_odom_robot_(T_world_start) {}

Pose2 OdometryDrift::advance(const Pose2& T_world_robot) {
  if (options_.perfect) return T_world_robot;
  const Pose2 T_before_now = inverse(T_world_before_) * T_world_robot;
  const double step_m = norm(T_before_now.position);
  const Angle turn = T_before_now.heading;

  Rng rng = stream(seed_, Draw::odometry, step_++);
  const double scale = 1.0 + options_.step_bias_share + rng.normal(0.0, options_.step_noise_share);
  const Angle wander = rng.normal(0.0, 1.0) * std::sqrt(step_m) * options_.heading_noise_per_sqrt_m;
  const Angle slip = rng.normal(0.0, options_.turn_noise_share) * turn;
  const Angle measured_turn = (1.0 + options_.turn_bias_share) * turn + wander + slip;

  T_world_before_ = T_world_robot;
  T_odom_robot_ = T_odom_robot_ * Pose2{scale * T_before_now.position, measured_turn};
  return T_odom_robot_;
}

}  // namespace echoarc::sim
