// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/common_tangents.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_readings.hpp"

namespace echoarc {
namespace {

Arc arc_at(Vec2 sensor, double axis_deg, double range_m, double beam_deg = 25.0) {
  return Arc::circular(sensor, degrees(axis_deg), range_m, degrees(beam_deg));
}

/// The differences of ranges that have a common tangent, by trying them out.
std::pair<double, double> accepted_differences(double axis_deg) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (double difference = -0.25; difference <= 0.25; difference += 1e-5) {
    if (!common_tangent(arc_at({0.0, 0.0}, axis_deg, 1.5 + difference), arc_at({0.2, 0.0}, axis_deg, 1.5))) continue;
    low = std::min(low, difference);
    high = std::max(high, difference);
  }
  return {low, high};
}

TEST(CommonTangent, V321TheIntervalOfDifferences) {
  const auto [low90, high90] = accepted_differences(90.0);
  EXPECT_NEAR(low90, -0.043288, 1e-5);
  EXPECT_NEAR(high90, 0.043288, 1e-5);
  const auto [low67, high67] = accepted_differences(67.5);
  EXPECT_NEAR(low67, 0.034730, 1e-5);
  EXPECT_NEAR(high67, 0.114715, 1e-5);
}

TEST(CommonTangent, V321EchoPoints) {
  const auto tangent = common_tangent(arc_at({0.0, 0.0}, 90.0, 1.52), arc_at({0.2, 0.0}, 90.0, 1.50));
  ASSERT_TRUE(tangent);
  EXPECT_NEAR(bearing(tangent->normal).deg(), 84.260830, 5e-7);
  EXPECT_NEAR(tangent->first.x, 0.152000, 5e-7);
  EXPECT_NEAR(tangent->first.y, 1.512381, 5e-7);
  EXPECT_NEAR(tangent->second.x, 0.350000, 5e-7);
  EXPECT_NEAR(tangent->second.y, 1.492481, 5e-7);
  EXPECT_FALSE(common_tangent(arc_at({0.0, 0.0}, 90.0, 1.60), arc_at({0.2, 0.0}, 90.0, 1.50)));
}

TEST(CommonTangent, CarvedArcsHaveFewer) {
  Arc first = arc_at({0.0, 0.0}, 90.0, 1.52);
  const Arc second = arc_at({0.2, 0.0}, 90.0, 1.50);
  first.set_limits(degrees(-12.5), degrees(-5.0));  // 84.26 degrees is 5.74 to the right of the axis
  EXPECT_TRUE(common_tangent(first, second));
  first.set_limits(degrees(-5.0), degrees(12.5));
  EXPECT_FALSE(common_tangent(first, second));
}

TEST(CommonTangent, NoneWithoutABaselineOrForEllipses) {
  const Arc arc = arc_at({0.0, 0.0}, 90.0, 1.5);
  EXPECT_FALSE(common_tangent(arc, arc));
  EXPECT_FALSE(common_tangent(arc, arc_at({0.04, 0.0}, 90.0, 1.5), 0.05));
  EXPECT_FALSE(common_tangent(arc, arc_at({1e9, 0.0}, 90.0, 1e9)));
  const auto ellipse = Arc::elliptical({{0, 0}, degrees(90)}, {{0.1, 0}, degrees(90)}, 1.5, degrees(25));
  ASSERT_TRUE(ellipse);
  EXPECT_FALSE(common_tangent(arc, *ellipse));
}

/// Both points lie on their arcs, and the segment is perpendicular to both radii.
RC_GTEST_PROP(CommonTangentProperty, TouchesBothArcs, (std::uint64_t seed)) {
  Rng rng(seed);
  const Arc first = arc_at({rng.uniform(-1, 1), rng.uniform(-1, 1)}, rng.uniform(-180, 180), rng.uniform(0.5, 3), 60);
  const Arc second = arc_at({rng.uniform(-1, 1), rng.uniform(-1, 1)}, first.axis().deg() + rng.uniform(-10, 10),
                            first.range_m() + rng.uniform(-0.5, 0.5), 60);
  const auto tangent = common_tangent(first, second);
  // The oracle walks over the bearings of the first arc and looks for a line that is as far from the second sensor as
  // it should be.
  const auto off = [&](Angle t) {
    const Vec2 n = unit(first.axis() + t);
    return dot(n, second.centre() - first.centre()) + second.range_m() - first.range_m();
  };
  bool crossed = false;
  constexpr int steps = 2000;
  for (int k = 0; k < steps; ++k) {
    const Angle t = first.t_begin() + (double(k) / steps) * (first.t_end() - first.t_begin());
    const Angle next = first.t_begin() + (double(k + 1) / steps) * (first.t_end() - first.t_begin());
    if (off(t) * off(next) <= 0.0 && second.contains_bearing(first.axis() + 0.5 * (t + next))) crossed = true;
  }
  if (crossed) RC_ASSERT(tangent.has_value());
  if (!tangent) return;
  RC_ASSERT(std::abs(norm(tangent->first - first.centre()) - first.range_m()) < 1e-12);
  RC_ASSERT(std::abs(norm(tangent->second - second.centre()) - second.range_m()) < 1e-12);
  RC_ASSERT(std::abs(dot(tangent->normal, tangent->second - tangent->first)) < 1e-12);
  RC_ASSERT(first.contains_bearing(bearing(tangent->first - first.centre())));
  RC_ASSERT(second.contains_bearing(bearing(tangent->second - second.centre())));
}

/// A sonar at the left side of a robot that drives along +x past a wall at y = 1.5 + slope x.
std::vector<Reading> past_wall(int count, double slope, double step_m = 0.06) {
  std::vector<Reading> readings;
  const Vec2 normal = Vec2{-slope, 1.0} / std::hypot(slope, 1.0);
  for (int k = 0; k < count; ++k) {
    const Vec2 sensor{step_m * k, 0.0};
    readings.push_back(test::monostatic_reading({sensor, degrees(90.0)}, Echo{dot(normal, Vec2{0.0, 1.5} - sensor)}));
    readings.back().ping = PingId(k);
  }
  return readings;
}

TEST(CommonTangents, AWallBecomesOneSegment) {
  CommonTangents tangents;
  tangents.insert(past_wall(20, 0.1));
  const std::vector<Feature> found = tangents.features();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FeatureKind::tangent);
  EXPECT_EQ(found[0].count, 20U);
  EXPECT_EQ(found[0].pings.size(), 20U);
  EXPECT_LT(found[0].residual_m, 1e-9);
  for (const Vec2 p : {found[0].begin, found[0].end}) EXPECT_NEAR(p.y, 1.5 + 0.1 * p.x, 1e-9);
  EXPECT_NEAR(norm(found[0].end - found[0].begin), 19 * 0.06 / std::hypot(1.0, 0.1), 1e-9);
  EXPECT_EQ(tangents.counters().tangents, 19U);
}

TEST(CommonTangents, ACornerEndsASegment) {
  std::vector<Reading> readings = past_wall(10, 0.0);
  for (const Reading& reading : past_wall(20, 0.15)) {
    if (reading.ping < 10) continue;
    readings.push_back(reading);
  }
  CommonTangents tangents({.arcs_min = 3});
  tangents.insert(readings);
  EXPECT_EQ(tangents.features().size(), 2U);
}

TEST(CommonTangents, HostileReadingsGiveNoLineAndLittleMemory) {
  const std::vector<Reading> still(100000, past_wall(1, 0.0)[0]);
  CommonTangents tangents;
  tangents.insert(still);
  EXPECT_TRUE(tangents.features().empty());
  EXPECT_EQ(tangents.counters().passed_over, still.size() - 1);
  std::vector<Reading> bad;
  for (const double range_m :
       {0.0, -1.0, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    bad.push_back(test::monostatic_reading({}, Echo{range_m}));
  bad.push_back(test::monostatic_reading({}, Echo{1.0}, degrees(180.0)));
  bad.push_back(test::monostatic_reading({{std::numeric_limits<double>::infinity(), 0.0}, {}}, Echo{1.0}));
  tangents.insert(bad);
  EXPECT_EQ(tangents.counters().passed_over, still.size() - 1 + bad.size());
  std::vector<Reading> jumping;
  for (int k = 0; k < 100; ++k) jumping.push_back(test::monostatic_reading({{100.0 * k, 0.0}, degrees(90)}, Echo{2.0}));
  tangents.insert(jumping);
  EXPECT_TRUE(tangents.features().empty());
  Reading bistatic = still[0];
  bistatic.rx = 1;
  tangents.insert(std::span(&bistatic, 1));
  EXPECT_EQ(tangents.counters().bistatic, 1U);
}

RC_GTEST_PROP(CommonTangentsProperty, MoveWithTheWorld, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::wall_drive(rng, 60);
  const Pose2 T{{rng.uniform(-50, 50), rng.uniform(-50, 50)}, degrees(rng.uniform(-180, 180))};
  CommonTangents here;
  CommonTangents there;
  here.insert(readings);
  for (Reading reading : readings) {
    reading.T_world_tx = reading.T_world_rx = T * reading.T_world_tx;
    there.insert(std::span(&reading, 1));
  }
  const std::vector<Feature> a = here.features();
  const std::vector<Feature> b = there.features();
  RC_ASSERT(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    RC_ASSERT(norm(T * a[k].begin - b[k].begin) < 1e-9);
    RC_ASSERT(norm(T * a[k].end - b[k].end) < 1e-9);
    RC_ASSERT(a[k].pings == b[k].pings);
  }
}

}  // namespace
}  // namespace echoarc
