// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/atm_resolution.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "echoarc/core/range_quantum.hpp"

namespace echoarc {
namespace {

constexpr Angle beam = degrees(22.5);
constexpr double half_digit = 5e-7;

TEST(AtmResolution, V312WhereACrossingStopsHelping) {
  const double range_m = crossing_interval_m(inch_m, degrees(30.0)) / beam.rad();
  EXPECT_NEAR(range_m, 0.241391, half_digit);
  EXPECT_NEAR(resolution_gain(range_m, beam, inch_m, degrees(30.0)), 1.0, 1e-12);
}

TEST(AtmResolution, V313Baselines) {
  EXPECT_NEAR(crossing_baseline_m(1.0, 1.0, degrees(30.0)), 0.517638, half_digit);
  EXPECT_NEAR(crossing_baseline_m(2.54, 2.54, degrees(30.0)), 1.314801, half_digit);
  EXPECT_NEAR(crossing_baseline_m(2.54, 2.54, degrees(30.0)) / inch_m, 51.76, 5e-3);
  EXPECT_NEAR(crossing_baseline_m(5.0, 5.0, degrees(30.0)), 2.588190, half_digit);
  EXPECT_NEAR(crossing_baseline_m(2.54, 2.54, degrees(13.0)), 0.575072, half_digit);
  EXPECT_NEAR(crossing_baseline_m(3.0, 4.0, degrees(90.0)), 5.0, 1e-12);
}

TEST(AtmResolution, V314Intervals) {
  const std::pair<double, double> cotangents[] = {
      {5.0, 22.903766}, {13.0, 8.776887}, {30.0, 3.732051}, {45.0, 2.414214}, {90.0, 1.0}};
  for (const auto& [angle_deg, cotangent] : cotangents)
    EXPECT_NEAR(crossing_interval_m(1.0, degrees(angle_deg)), cotangent, half_digit);
  EXPECT_NEAR(crossing_interval_m(inch_m, degrees(5.0)), 0.581756, half_digit);
  EXPECT_NEAR(crossing_interval_m(inch_m, degrees(13.0)), 0.222933, half_digit);
  EXPECT_NEAR(crossing_interval_m(inch_m, degrees(30.0)), 0.094794, half_digit);
  EXPECT_NEAR(crossing_interval_m(inch_m, degrees(45.0)), 0.061321, half_digit);
  EXPECT_TRUE(std::isinf(crossing_interval_m(inch_m, Angle{})));
}

TEST(AtmResolution, V315GainAndAngle) {
  EXPECT_NEAR(resolution_gain(2.54, beam, inch_m, degrees(30.0)), 10.522340, half_digit);
  EXPECT_NEAR(resolution_gain(2.54, beam, inch_m, degrees(13.0)), 4.474241, half_digit);
  EXPECT_NEAR(angle_for_gain(10.0, 2.54, beam, inch_m)->deg(), 28.573217, half_digit);
  EXPECT_NEAR(angle_for_gain(20.0, 2.54, beam, inch_m)->deg(), 53.979108, half_digit);
  EXPECT_NEAR(angle_for_gain(10.0, 1.0, beam, inch_m)->deg(), 65.790037, half_digit);
  EXPECT_NEAR(angle_for_gain(10.0, 2.0, beam, inch_m)->deg(), 35.842710, half_digit);
  EXPECT_NEAR(angle_for_gain(10.0, 4.0, beam, inch_m)->deg(), 18.370605, half_digit);
  EXPECT_FALSE(angle_for_gain(10.0, 0.5, beam, inch_m)) << "104.5 degrees";
}

TEST(AtmResolution, ChanceOfAClusterFallsWithItsSize) {
  EXPECT_NEAR(chance_of_cluster(degrees(2.25), beam, 3), 1e-3, 1e-15);
}

}  // namespace
}  // namespace echoarc
