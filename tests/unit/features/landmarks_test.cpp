// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_readings.hpp"

namespace echoarc {
namespace {

DepthRegion region(Vec2 position, double depth_m, double bearing_deg) {
  return {position, depth_m, degrees(bearing_deg), degrees(20.0), {}};
}

/// The region of a wall n.x = H, or of a point, from a position.
DepthRegion of_wall(Vec2 normal, double distance_m, Vec2 position) {
  return {position, distance_m - dot(normal, position), bearing(normal), degrees(20.0), {1}};
}
DepthRegion of_point(Vec2 point, Vec2 position, double extent_deg = 20.0) {
  return {position, norm(point - position), bearing(point - position), degrees(extent_deg), {2}};
}

constexpr Vec2 stops[] = {{0.0, 0.0}, {0.2, 0.05}, {0.4, 0.0}, {0.6, 0.1}, {0.8, 0.0}};

std::size_t count_of(const std::vector<Feature>& features, FeatureKind kind) {
  return std::size_t(std::ranges::count(features, kind, &Feature::kind));
}

TEST(LandmarkFits, V322TwoPositionsFitAWallExactly) {
  const std::vector<DepthRegion> regions{region({0, 0}, 1.52, 90.0), region({0.2, 0}, 1.50, 90.0)};
  const WallFit fit = fit_wall(regions);
  EXPECT_NEAR(dot(fit.normal, Vec2{0.2, 0.0}), 0.020000, 1e-12);
  EXPECT_NEAR(fit.rms_m, 0.0, 1e-12);
  EXPECT_NEAR(bearing(fit.normal).deg(), 84.260830, 5e-7);
  EXPECT_NEAR(fit.distance_m, 1.52, 1e-12);
}

TEST(LandmarkFits, APointIsFoundAgain) {
  const Vec2 truth{0.7, 1.4};
  std::vector<DepthRegion> regions;
  for (const Vec2 stop : stops) regions.push_back(of_point(truth, stop));
  for (DepthRegion& r : regions) r.bearing += degrees(4.0);  // bearings are poor, depths are good
  const PointFit fit = fit_point(regions);
  EXPECT_LT(norm(fit.position - truth), 1e-6);
  EXPECT_LT(fit.rms_m, 1e-7);
  EXPECT_GT(fit_wall(regions).rms_m, 0.01);
}

TEST(Landmarks, WallsCornersAndEdgesAreToldApart) {
  const Vec2 concave{2.0, 1.5};
  const Vec2 convex{-0.6, 0.9};
  Landmarks landmarks;
  for (const Vec2 stop : stops)
    landmarks.insert(
        {of_wall({0, 1}, 1.5, stop), of_wall({1, 0}, 2.0, stop), of_point(concave, stop), of_point(convex, stop)});
  const std::vector<Feature> found = landmarks.features();
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(count_of(found, FeatureKind::wall), 2U);
  ASSERT_EQ(count_of(found, FeatureKind::corner), 1U);
  ASSERT_EQ(count_of(found, FeatureKind::edge), 1U);
  const Feature& corner = *std::ranges::find(found, FeatureKind::corner, &Feature::kind);
  EXPECT_LT(norm(corner.begin - concave), 1e-6);
  EXPECT_TRUE(corner.is_point());
  EXPECT_EQ(corner.count, 5U);
  const Feature& wall = *std::ranges::find(found, FeatureKind::wall, &Feature::kind);
  EXPECT_NEAR(wall.begin.y, 1.5, 1e-9);
  EXPECT_NEAR(norm(wall.end - wall.begin), 0.8, 1e-9);
}

TEST(Landmarks, WithoutWallsTheExtentDecides) {
  for (const double extent_deg : {12.0, 20.0}) {
    Landmarks landmarks;
    for (const Vec2 stop : stops) landmarks.insert({of_point({0.7, 1.4}, stop, extent_deg)});
    const auto found = landmarks.features();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, extent_deg < 15.0 ? FeatureKind::edge : FeatureKind::corner);
  }
}

TEST(Landmarks, TwoPositionsAreNotEnough) {
  Landmarks landmarks;
  for (const Vec2 stop : {stops[0], stops[1]}) landmarks.insert({of_wall({0, 1}, 1.5, stop)});
  const auto found = landmarks.features();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FeatureKind::region);
  EXPECT_EQ(found[0].count, 2U);
}

TEST(Landmarks, EchoesOfEchoesBehindAWallAreDropped) {
  Landmarks landmarks;
  for (const Vec2 stop : stops) landmarks.insert({of_wall({0, 1}, 1.5, stop), of_wall({0, 1}, 2.5, stop)});
  const auto found = landmarks.features();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].begin.y, 1.5, 1e-9);
}

/// A ring of 16 sonars turned in place nine times by 2.5 degrees in front of a wall at x = 1.5: [Choset03] Fig. 11.
std::vector<Reading> turn_in_place(Vec2 position, PingId first) {
  std::vector<Reading> readings;
  for (int turn = 0; turn < 9; ++turn)
    for (int sensor = 0; sensor < 16; ++sensor) {
      const Angle heading = degrees(2.5 * turn);
      const Angle axis = heading + degrees(22.5 * sensor);
      const Pose2 T_world_sensor{position + 0.23 * unit(axis), axis};
      const double slant_rad = abs(wrap(axis)).rad();
      Outcome outcome = NoEcho{};
      if (slant_rad < degrees(12.5).rad())  // the beam holds the wall's normal
        outcome = Echo{1.5 - position.x - 0.23};
      Reading reading = test::monostatic_reading(T_world_sensor, outcome);
      reading.T_world_robot = {position, heading};
      reading.ping = first + readings.size();
      readings.push_back(reading);
    }
  return readings;
}

TEST(Landmarks, ReadingsOfOnePlaceAreOneSweep) {
  Landmarks landmarks;
  for (int stop = 0; stop < 4; ++stop) landmarks.insert(turn_in_place({0.05 * stop, 0.3 * stop}, PingId(144 * stop)));
  EXPECT_EQ(landmarks.sweeps(), 3U);
  const auto found = landmarks.features();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FeatureKind::wall);
  EXPECT_EQ(found[0].count, 4U);
  EXPECT_NEAR(found[0].begin.x, 1.5, 0.01);
  EXPECT_NEAR(found[0].end.x, 1.5, 0.01);
  EXPECT_GE(found[0].pings.size(), 16U);
}

TEST(Landmarks, StandingStillAndBadReadingsAreBounded) {
  Landmarks landmarks;
  const std::vector<Reading> once = turn_in_place({}, 0);
  for (int hour = 0; hour < 500; ++hour) landmarks.insert(once);
  EXPECT_EQ(landmarks.sweeps(), 0U);
  EXPECT_EQ(landmarks.features().size(), 1U);
  std::vector<Reading> bad;
  for (const double range_m :
       {0.0, -1.0, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    bad.push_back(test::monostatic_reading({}, Echo{range_m}));
  bad.push_back(test::monostatic_reading({{std::numeric_limits<double>::infinity(), 0.0}, {}}, Echo{1.0}));
  bad.push_back(bad[0]);
  bad.back().outcome = Invalid{};
  landmarks.insert(bad);
  for (const Feature& feature : landmarks.features()) EXPECT_TRUE(is_finite(feature.begin));
  Landmarks jumping;
  for (int k = 0; k < 200; ++k) jumping.insert({of_wall({0, 1}, 1.5 + 100.0 * k, {100.0 * k, 100.0 * k})});
  for (const LandmarkTrack& track : jumping.tracks()) EXPECT_LE(track.regions.size(), Landmarks::max_regions);
}

RC_GTEST_PROP(LandmarksProperty, MoveWithTheWorld, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 T{{rng.uniform(-50, 50), rng.uniform(-50, 50)}, degrees(rng.uniform(-180, 180))};
  Landmarks here;
  Landmarks there;
  for (const Vec2 stop : stops) {
    std::vector<DepthRegion> regions{of_wall({0, 1}, 1.5, stop), of_wall({1, 0}, 2.0, stop), of_point({2, 1.5}, stop)};
    for (DepthRegion& r : regions) r.depth_m += rng.uniform(-0.001, 0.001);
    std::vector<DepthRegion> moved = regions;
    for (DepthRegion& r : moved) r = {T * r.position, r.depth_m, wrap(r.bearing + T.heading), r.extent, r.pings};
    here.insert(regions);
    there.insert(moved);
  }
  const auto a = here.features();
  const auto b = there.features();
  RC_ASSERT(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    RC_ASSERT(a[k].kind == b[k].kind);
    RC_ASSERT(norm(T * a[k].begin - b[k].begin) < 1e-7);
    RC_ASSERT(norm(T * a[k].end - b[k].end) < 1e-7);
  }
}

}  // namespace
}  // namespace echoarc
