// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/motion_noise.hpp"

#include <cmath>

namespace echoarc::nav {

StepDeviation step_deviation(const MotionNoiseOptions& noise, const Pose2& T_before_now) {
  const double length_m = norm(T_before_now.position);
  const double root = std::sqrt(length_m);
  const double place_m = noise.place_noise_m_per_sqrt_m * root;
  return {.along_m = std::hypot(noise.step_noise_share * length_m, place_m),
          .across_m = place_m,
          .heading = radians(std::hypot(noise.heading_noise_per_sqrt_m.rad() * root,
                                        noise.turn_noise_share * T_before_now.heading.rad()))};
}

Pose2 sample_step(const StepDeviation& deviation, const Pose2& T_before_now, Rng& rng) {
  const double length_m = norm(T_before_now.position);
  const Vec2 along = length_m > 0.0 ? T_before_now.position / length_m : Vec2{1.0, 0.0};
  const double error_along_m = rng.normal(0.0, deviation.along_m);
  const double error_across_m = rng.normal(0.0, deviation.across_m);
  return {T_before_now.position + error_along_m * along + error_across_m * perpendicular(along),
          T_before_now.heading + radians(rng.normal(0.0, deviation.heading.rad()))};
}

}  // namespace echoarc::nav
