// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/landmark_filter.hpp"

namespace echoarc::nav {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double determinant(const Matrix3& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Symmetric to the last bit, and by its leading minors positive.
bool is_covariance(const Matrix3& m) {
  return m[0][1] == m[1][0] && m[0][2] == m[2][0] && m[1][2] == m[2][1] && m[0][0] > 0.0 &&
         m[0][0] * m[1][1] - m[0][1] * m[1][0] > 0.0 && determinant(m) > 0.0;
}

TEST(LandmarkFilter, WorkedNumbers) {
  // From the origin, 2 m ahead: range sees x alone, bearing sees y / 2 m and the heading.
  LandmarkFilterOptions options;
  options.landmark_deviation_m = 0.0;
  options.least_range_deviation_m = 0.03;
  options.range_deviation_m = 0.08;
  options.least_bearing_deviation = radians(1e-4);
  options.bearing_deviation = radians(0.0);
  const std::vector<Vec2> landmarks = {{2.0, 0.0}};
  LandmarkFilter filter(landmarks, options);
  filter.start_at({}, 0.1, radians(0.1));
  // n_t = 4: sigma_r^2 = 0.03^2 + 0.08^2 / 4 = 0.0025; gain 0.01 / 0.0125 = 0.8.
  EXPECT_EQ(filter.observe({1.95, {}, 4}), Association::matched);
  EXPECT_NEAR(filter.T_map_robot().position.x, 0.8 * 0.05, 1e-12);
  EXPECT_NEAR(filter.covariance()[0][0], 0.01 * 0.2, 1e-12);
  // n_t = 1: the same sighting weighs less.
  filter.start_at({}, 0.1, radians(0.1));
  EXPECT_EQ(filter.observe({1.95, {}, 1}), Association::matched);
  EXPECT_NEAR(filter.T_map_robot().position.x, 0.05 * 0.01 / (0.01 + 0.0073), 1e-12);
  // A bearing of 0.125 rad is shared by heading (0.01 rad^2) and y (0.01 / 4 rad^2): -0.1 rad and 0.125 / 5 * 2 m.
  filter.start_at({}, 0.1, radians(0.1));
  EXPECT_EQ(filter.observe({2.0, radians(-0.125), 1}), Association::matched);
  EXPECT_NEAR(filter.T_map_robot().heading.rad(), 0.1, 1e-5);
  EXPECT_NEAR(filter.T_map_robot().position.y, 0.05, 1e-5);
}

TEST(LandmarkFilter, TheGateIsAt99Percent) {
  LandmarkFilterOptions options;
  options.landmark_deviation_m = 0.0;
  options.range_deviation_m = 0.0;
  options.least_range_deviation_m = 0.1;
  const std::vector<Vec2> landmarks = {{2.0, 0.0}};
  LandmarkFilter filter(landmarks, options);
  const double edge_m = std::sqrt(9.21 * 0.02);  // innovation variance 0.1^2 + 0.1^2
  filter.start_at({}, 0.1, radians(0.1));
  EXPECT_EQ(filter.observe({2.0 + edge_m + 1e-6, {}, 3}), Association::no_match);
  EXPECT_EQ(filter.T_map_robot(), Pose2{});
  EXPECT_EQ(filter.observe({2.0 + edge_m - 1e-6, {}, 3}), Association::matched);
}

TEST(LandmarkFilter, TakesNeitherOfTwoThatFitAlike) {
  const std::vector<Vec2> landmarks = {{2.0, 0.1}, {2.0, -0.1}, {nan, 0.0}};
  LandmarkFilter filter(landmarks);
  filter.start_at({}, 0.1, degrees(5.0));
  EXPECT_EQ(filter.observe({2.0, {}, 3}), Association::ambiguous);
  EXPECT_EQ(filter.T_map_robot(), Pose2{});
}

TEST(LandmarkFilter, PassesOverWhatIsNoSighting) {
  const std::vector<Vec2> landmarks = {{2.0, 0.0}};
  LandmarkFilter filter(landmarks);
  filter.start_at({}, 0.1, degrees(5.0));
  EXPECT_EQ(filter.observe({nan, {}, 3}), Association::invalid);
  EXPECT_EQ(filter.observe({2.0, radians(nan), 3}), Association::invalid);
  EXPECT_EQ(filter.observe({2.0, {}, 0}), Association::invalid);
  EXPECT_EQ(filter.observe({0.0, {}, 3}), Association::invalid);
  filter.move({{nan, 0.0}, {}});
  filter.start_at({{nan, 0.0}, {}}, 0.1, degrees(5.0));
  EXPECT_EQ(filter.T_map_robot(), Pose2{});
  EXPECT_EQ(LandmarkFilter({}).observe({2.0, {}, 3}), Association::no_match);
  EXPECT_EQ(name(Association::no_match), "no_match");
}

RC_GTEST_PROP(LandmarkFilter, CovarianceStaysSymmetricAndPositive, ()) {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  std::vector<Vec2> landmarks;
  for (int n = 0; n < 12; ++n) landmarks.push_back({number(-5000, 5000), number(-5000, 5000)});
  LandmarkFilter filter(landmarks);
  filter.start_at({}, 0.2, degrees(10.0));
  Pose2 T_map_robot;
  for (int n = 0; n < 30; ++n) {
    const Pose2 T_before_now{{number(1, 300), number(-20, 20)}, radians(number(-300, 300))};
    T_map_robot = T_map_robot * T_before_now;
    filter.move(T_before_now);
    RC_ASSERT(is_covariance(filter.covariance()));
    for (const Vec2 landmark : landmarks) {
      LandmarkSighting sighting = sighting_of(T_map_robot, landmark, *rc::gen::inRange(1, 20));
      sighting.range_m += number(-50, 50);
      filter.observe(sighting);
      RC_ASSERT(is_covariance(filter.covariance()));
    }
  }
}

TEST(LandmarkFilter, TracksThroughDrift) {
  std::vector<Vec2> landmarks;
  for (int n = 0; n < 8; ++n) landmarks.push_back({1.5 * n, n % 2 == 0 ? 1.2 : -1.0});
  LandmarkFilter filter(landmarks);
  filter.start_at({}, 0.1, degrees(3.0));
  Rng rng(4);
  Pose2 T_map_robot;
  Pose2 T_odom_robot;
  int matched = 0;
  for (int n = 0; n < 100; ++n) {
    const Pose2 T_before_now{{0.1, 0.0}, {}};
    const Pose2 measured{{0.1 * (1.005 + rng.normal(0.0, 0.01)), 0.0}, degrees(0.1 + rng.normal(0.0, 0.16))};
    T_map_robot = T_map_robot * T_before_now;
    T_odom_robot = T_odom_robot * measured;
    filter.move(measured);
    for (const Vec2 landmark : landmarks) {
      if (n % 5 != 0 || norm(landmark - T_map_robot.position) > 2.5) continue;
      // Triangulated in odometry's frame, as the fusion gives it.
      const LandmarkSighting seen = sighting_of(T_map_robot, landmark, 4);
      const Vec2 point = T_odom_robot * ((seen.range_m + rng.normal(0.0, 0.03)) * unit(seen.bearing));
      if (filter.observe(sighting_of(T_odom_robot, point, 4)) == Association::matched) ++matched;
    }
  }
  EXPECT_GT(matched, 40);
  EXPECT_LT(norm(filter.T_map_robot().position - T_map_robot.position), 0.1);
  EXPECT_LT(abs(wrap(filter.T_map_robot().heading)), degrees(2.0));
  EXPECT_GT(abs(T_odom_robot.heading), degrees(6.0));
  EXPECT_LT(filter.spread().deviation_m.x, 0.15);
  EXPECT_EQ(filter.spread().T_world_axes.position, filter.T_map_robot().position);
}

}  // namespace
}  // namespace echoarc::nav
