// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/acoustics.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace echoarc::sim {
namespace {

double one_way_db(const PistonBeam& beam, double off_axis_deg) {
  return 20.0 * std::log10(std::abs(beam.amplitude(degrees(off_axis_deg))));
}

/// The half angle of the main lobe at which the one-way pattern has fallen to `level_db`.
double half_angle_deg(const PistonBeam& beam, double level_db) {
  double low = 0.0;
  double high = beam.first_null().deg();
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (one_way_db(beam, middle) > level_db ? low : high) = middle;
  }
  return low;
}

// V1.3
TEST(Piston, Polaroid6500) {
  const Acoustics acoustics{SonarOptions{}};
  const PistonBeam& beam = acoustics.beam();
  EXPECT_NEAR(1000.0 * acoustics.speed_of_sound_m_s() / 49'400.0, 6.949892, 5e-7);
  EXPECT_NEAR(beam.wave_number_radius(), 18.081390, 5e-7);
  EXPECT_NEAR(beam.first_null().deg(), 12.2346, 5e-5);
  EXPECT_NEAR(one_way_db(beam, 16.501), -17.570, 5e-4);
  EXPECT_GT(one_way_db(beam, 16.501), one_way_db(beam, 16.4));
  EXPECT_GT(one_way_db(beam, 16.501), one_way_db(beam, 16.6));
}

TEST(Piston, HalfAngles) {
  const PistonBeam beam = Acoustics{SonarOptions{}}.beam();
  const std::vector<std::pair<double, double>> one_way{{-3, 5.1204}, {-6, 7.0262}, {-12, 9.3040}, {-20, 10.9020}};
  for (const auto& [level_db, angle_deg] : one_way) EXPECT_NEAR(half_angle_deg(beam, level_db), angle_deg, 5e-5);
  const std::vector<std::pair<double, double>> two_way{{-3, 3.6731},   {-6, 5.1204},   {-12, 7.0262},  {-20, 8.6884},
                                                       {-30, 10.0409}, {-35, 10.5201}, {-40, 10.9020}, {-46, 11.2569}};
  for (const auto& [level_db, angle_deg] : two_way) EXPECT_NEAR(half_angle_deg(beam, level_db / 2.0), angle_deg, 5e-5);
}

TEST(Piston, Pattern) {
  const PistonBeam beam = Acoustics{SonarOptions{}}.beam();
  struct Row {
    double angle_deg;
    double amplitude;
    double two_way_db;
  };
  for (const Row& row : std::vector<Row>{{0, 1.00000, 0},
                                         {2.5, 0.92423, -1.37},
                                         {5, 0.72008, -5.70},
                                         {7.5, 0.44783, -13.96},
                                         {10, 0.18175, -29.62},
                                         {11.25, 0.07135, -45.86},
                                         {12.5, -0.01665, -71.15},
                                         {15, -0.11743, -37.21},
                                         {20, -0.07654, -44.64},
                                         {30, 0.05317, -50.97}}) {
    EXPECT_NEAR(beam.amplitude(degrees(row.angle_deg)), row.amplitude, 5e-6) << row.angle_deg;
    EXPECT_NEAR(2.0 * one_way_db(beam, row.angle_deg), row.two_way_db, 5e-3) << row.angle_deg;
  }
}

TEST(Piston, FollowsTheFormula) {
  for (const double ka : {0.01, 1.0, 18.081390, 300.0}) {
    const PistonBeam beam(ka);
    for (double angle_deg = -89.99; angle_deg < 90.0; angle_deg += 0.0917) {
      const double x = ka * std::abs(sin(degrees(angle_deg)));
      ASSERT_NEAR(beam.amplitude(degrees(angle_deg)), 2.0 * std::cyl_bessel_j(1, x) / x, 1e-9)
          << ka << " at " << angle_deg;
    }
    EXPECT_EQ(beam.amplitude(degrees(90.0)), 0.0);
    EXPECT_EQ(beam.amplitude(degrees(180.0)), 0.0);
    EXPECT_EQ(beam.amplitude(degrees(0.0)), 1.0);
  }
}

TEST(Acoustics, LevelOfAPath) {
  const Acoustics acoustics{SonarOptions{}};
  const EchoPath near{.length_m = 4.0, .departure = degrees(5.0), .arrival = degrees(7.5), .gain_db = -8.0};
  EXPECT_NEAR(acoustics.level_db(near, {}, {}), 20.0 * std::log10(0.72008 * 0.44783) - 8.0, 5e-4);
  EXPECT_NEAR(acoustics.level_db(near, degrees(5.0), degrees(7.5)), -8.0, 1e-9);
  EchoPath far = near;
  far.length_m = 16.0;
  EXPECT_NEAR(acoustics.level_db(far, degrees(5.0), degrees(7.5)), -8.0 - 6.0, 1e-9);
  EXPECT_EQ(acoustics.level_db(near, degrees(180.0), {}), -std::numeric_limits<double>::infinity());
}

TEST(Acoustics, ThresholdLeavesTheFirstSideLobeJustOut) {
  const Acoustics acoustics{SonarOptions{}};
  const EchoPath lobe{.length_m = 2.0, .departure = degrees(16.501), .arrival = degrees(16.501)};
  EXPECT_FALSE(acoustics.heard(acoustics.level_db(lobe, {}, {})));
  const Acoustics keen{SonarOptions{.threshold_db = 36.0}};
  EXPECT_TRUE(keen.heard(keen.level_db(lobe, {}, {})));
}

TEST(Acoustics, TheWindowGrowsWithTheBeam) {
  EXPECT_NEAR(Acoustics{SonarOptions{}}.half_window().deg(), 25.0, 1e-4);
  EXPECT_NEAR(Acoustics{SonarOptions{.listening = Listening::all}}.half_window().deg(), 90.0, 1e-9);
  EXPECT_NEAR(Acoustics{SonarOptions{.aperture_radius_m = 0.001}}.half_window().deg(), 90.0, 1e-9);
}

}  // namespace
}  // namespace echoarc::sim
