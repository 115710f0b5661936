// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/core/rng.hpp"

namespace echoarc::nav {

/// How far odometry may be wrong. The biases of wheels are constant but unknown: to who does not know them they are one
/// more spread of every step.
struct MotionNoiseOptions {
  double step_noise_share = 0.02;
  double place_noise_m_per_sqrt_m = 0.02;
  Angle heading_noise_per_sqrt_m = degrees(1.0);
  double turn_noise_share = 0.04;

  static constexpr auto fields() {
    using O = MotionNoiseOptions;
    return std::tuple{
        field("step_noise_share", &O::step_noise_share,
              {.min = 0.0, .max = 1.0, .doc = "standard deviation of a step, as a share of its length"}),
        field("place_noise_m_per_sqrt_m", &O::place_noise_m_per_sqrt_m,
              {.unit = "m/sqrt(m)",
               .min = 0.0,
               .max = 1.0,
               .doc = "standard deviation of the place after a metre, to either side and along"}),
        field(
            "heading_noise_per_sqrt_m_deg", &O::heading_noise_per_sqrt_m,
            {.unit = "deg/sqrt(m)", .min = 0.0, .max = 90.0, .doc = "standard deviation of the heading after a metre"}),
        field("turn_noise_share", &O::turn_noise_share,
              {.min = 0.0, .max = 1.0, .doc = "standard deviation of a turn, as a share of it"})};
  }
};

/// Standard deviations of one measured step.
struct StepDeviation {
  double along_m = 0.0;
  double across_m = 0.0;
  Angle heading;
};

/// `T_before_now` is the step as odometry measured it, in the robot's frame before it.
[[nodiscard]] StepDeviation step_deviation(const MotionNoiseOptions& noise, const Pose2& T_before_now);

/// A step that may have been made where `T_before_now` was measured. Draws three normal numbers.
[[nodiscard]] Pose2 sample_step(const StepDeviation& deviation, const Pose2& T_before_now, Rng& rng);

}  // namespace echoarc::nav
