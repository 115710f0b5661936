// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/odometry_drift.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echoarc::sim {
namespace {

TEST(OdometryDrift, PerfectOdometryIsTheTruth) {
  OdometryDrift drift({}, 1, {{1.0, 2.0}, degrees(10.0)});
  EXPECT_EQ(drift.advance({{3.0, 4.0}, degrees(50.0)}), (Pose2{{3.0, 4.0}, degrees(50.0)}));
}

TEST(OdometryDrift, BiasesAloneAreExact) {
  const OdometryOptions options{.perfect = false,
                                .step_bias_share = 0.02,
                                .step_noise_share = 0.0,
                                .turn_bias_share = 0.1,
                                .turn_noise_share = 0.0,
                                .heading_noise_per_sqrt_m = Angle{}};
  OdometryDrift drift(options, 1, {{1.0, 0.0}, Angle{}});
  const Pose2 ahead = drift.advance({{3.0, 0.0}, Angle{}});
  EXPECT_NEAR(ahead.position.x, 1.0 + 2.0 * 1.02, 1e-12);
  EXPECT_EQ(ahead.heading, Angle{});
  const Pose2 turned = drift.advance({{3.0, 0.0}, degrees(90.0)});
  EXPECT_NEAR(turned.heading.deg(), 99.0, 1e-9);
  EXPECT_EQ(turned.position, ahead.position) << "a turn on the spot does not move";
}

/// Mean and standard deviation of the heading after a metre in `steps`, over many seeds.
TEST(OdometryDrift, HeadingWandersAsStatedWhateverTheRate) {
  const OdometryOptions options{.perfect = false, .turn_bias_share = 0.0};
  for (const int steps : {1, 20}) {
    constexpr int runs = 4000;
    double sum_deg = 0.0;
    double squares = 0.0;
    double length_m = 0.0;
    for (int run = 0; run < runs; ++run) {
      OdometryDrift drift(options, static_cast<std::uint64_t>(run), {});
      Pose2 T_odom_robot;
      for (int k = 1; k <= steps; ++k) T_odom_robot = drift.advance({{static_cast<double>(k) / steps, 0.0}, Angle{}});
      const double heading_deg = T_odom_robot.heading.deg();
      sum_deg += heading_deg;
      squares += heading_deg * heading_deg;
      length_m += T_odom_robot.position.x;
    }
    // The standard error of a standard deviation over n runs is sigma / sqrt(2 n): 0.0056 degrees; four of them.
    EXPECT_NEAR(std::sqrt(squares / runs), 0.5, 0.023) << steps;
    EXPECT_NEAR(sum_deg / runs, 0.0, 4.0 * 0.5 / std::sqrt(runs)) << steps;
    EXPECT_NEAR(length_m / runs, 1.005, 0.001) << steps;
  }
}

}  // namespace
}  // namespace echoarc::sim
