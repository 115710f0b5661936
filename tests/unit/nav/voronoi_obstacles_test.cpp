// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/obstacle_distances.hpp"
#include "unit/nav/voronoi_world.hpp"

namespace echoarc::nav {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Vec2> line(Vec2 from, Vec2 to, double spacing_m = 0.02) {
  std::vector<Vec2> points;
  const int steps = int(std::lround(norm(to - from) / spacing_m));
  for (int i = 0; i <= steps; ++i) points.push_back(from + (double(i) / double(steps)) * (to - from));
  return points;
}

std::vector<Vec2> operator+(std::vector<Vec2> a, const std::vector<Vec2>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(VoronoiObstacles, CorridorHasTwo) {
  const auto found = obstacle_distances(line({-3, 1}, {3, 1}) + line({-3, -1.2}, {3, -1.2}), {0, 0});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].distance_m, 1.0, 1e-3);
  EXPECT_NEAR(found[0].bearing.deg(), 90.0, 0.5);
  EXPECT_NEAR(found[1].distance_m, 1.2, 1e-3);
  EXPECT_NEAR(found[1].closest.x, 0.0, 0.01);
  EXPECT_NEAR(found[1].closest.y, -1.2, 1e-9);
}

TEST(VoronoiObstacles, WallIsOneHoweverLong) {
  EXPECT_EQ(obstacle_distances(line({-5, 1}, {5, 1}), {0, 0}).size(), 1u);
}

TEST(VoronoiObstacles, CornerHasTwoWallsUntilItsNoseIsInIt) {
  const auto walls = line({0, 0}, {3, 0}) + line({0, 0}, {0, 3});
  EXPECT_EQ(obstacle_distances(walls, {1, 1}).size(), 2u);
  EXPECT_EQ(obstacle_distances(walls, {0.3, 0.3}).size(), 2u);  // the corner lies 0.12 m further
  EXPECT_EQ(obstacle_distances(walls, {0.2, 0.2}).size(), 1u);  // 0.08 m
}

TEST(VoronoiObstacles, BumpOfAWallIsOfTheWall) {
  const auto wall = line({-2, 1}, {0.6, 1}) + line({0.6, 1}, {0.7, 0.95}) + line({0.7, 0.95}, {2, 0.95});
  EXPECT_EQ(obstacle_distances(wall, {0, 0}).size(), 1u);
}

TEST(VoronoiObstacles, ThinPolesCountByTheirBearing) {
  const auto pole = [](double deg, double distance_m) { return distance_m * unit(degrees(deg)); };
  EXPECT_EQ(obstacle_distances(std::vector{pole(0, 2), pole(20, 2.1)}, {0, 0}).size(), 1u);
  EXPECT_EQ(obstacle_distances(std::vector{pole(0, 2), pole(40, 2.1)}, {0, 0}).size(), 2u);
}

TEST(VoronoiObstacles, WithoutARiseBetweenThemOnlyAChainOfPointsJoins) {
  std::vector<Vec2> arc;  // round the place at 1 m, a shallow minimum at 0 and at 60 degrees
  for (int deg = -20; deg <= 80; deg += 2) {
    const double wave = 0.03 * (1.0 - std::cos(degrees(6.0 * deg).rad()));
    arc.push_back((1.0 + wave) * unit(degrees(deg + 0.5)));
  }
  EXPECT_EQ(obstacle_distances(arc, {0, 0}).size(), 1u);
  ObstacleOptions loose;
  loose.link_m = 0.02;  // its points are 0.035 m apart
  EXPECT_EQ(obstacle_distances(arc, {0, 0}, loose).size(), 2u);
}

TEST(VoronoiObstacles, ShortGapsAreBridged) {
  const auto sparse = line({-2, 1}, {2, 1}, 0.2);
  EXPECT_EQ(obstacle_distances(sparse, {0.05, 0}).size(), 1u);
  ObstacleOptions loose;
  loose.link_m = 0.1;
  EXPECT_GT(obstacle_distances(sparse, {0.05, 0}, loose).size(), 1u);
}

TEST(VoronoiObstacles, ClosestPlaceIsTheMeanOfWhatIsAboutAsNear) {
  const std::vector<Vec2> points{{1.0, 0.05}, {1.0, -0.01}, {1.02, 0.02}, {1.1, 0.0}};
  const auto found = obstacle_distances(points, {0, 0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].closest.x, 3.02 / 3.0, 1e-12);
  EXPECT_NEAR(found[0].closest.y, 0.02, 1e-12);
  EXPECT_DOUBLE_EQ(found[0].distance_m, norm(found[0].closest));
}

TEST(VoronoiObstacles, BadPointsAreIgnored) {
  const std::vector<Vec2> points{{nan, 0}, {infinity, 1}, {0, 0}, {50, 0}, {0, 1}};
  const auto found = obstacle_distances(points, {0, 0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].closest, (Vec2{0, 1}));
  EXPECT_TRUE(obstacle_distances({}, {0, 0}).empty());
  EXPECT_TRUE(obstacle_distances(points, {nan, 0}).empty());
  EXPECT_EQ(clearance_m({}, {0, 0}), infinity);
  EXPECT_EQ(clearance_m(std::vector<Vec2>{{nan, 1}, {0, 2}}, {0, 0}), 2.0);
}

/// The rule as it is written, over one distance per bin: a local minimum is an obstacle unless a lower place can be
/// reached, either way round, without climbing by `rise_m`. Then the separation of bearings, nearest first.
std::vector<std::size_t> slow_minima(const std::vector<double>& profile, const ObstacleOptions& options) {
  const std::size_t n = profile.size();
  std::vector<std::size_t> kept;
  for (std::size_t b = 0; b < n; ++b) {
    bool drowned = false;
    for (const std::size_t step : {std::size_t{1}, n - 1}) {
      double highest = profile[b];
      for (std::size_t c = (b + step) % n; c != b && highest < profile[b] + options.rise_m; c = (c + step) % n) {
        highest = std::max(highest, profile[c]);
        drowned = drowned || (profile[c] < profile[b] && highest < profile[b] + options.rise_m);
      }
    }
    if (!drowned) kept.push_back(b);
  }
  std::sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) { return profile[a] < profile[b]; });
  std::vector<std::size_t> apart;
  for (const std::size_t b : kept) {
    const auto near = [&](std::size_t c) {
      return abs(wrap(360.0 / double(n) * degrees(double(b) - double(c)))) < options.separation - degrees(1e-6);
    };
    if (std::none_of(apart.begin(), apart.end(), near)) apart.push_back(b);
  }
  return apart;
}

RC_GTEST_PROP(VoronoiObstaclesProperty, EqualTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  ObstacleOptions options;
  options.near_m = 1e-9;
  options.link_m = 100.0;  // all of one chain: the rise alone counts
  options.separation = degrees(29.0);
  std::vector<double> profile;
  std::vector<Vec2> points;
  const double waves = rng.uniform(1, 12);
  for (int b = 0; b < 180; ++b) {
    profile.push_back(2.0 + std::sin(waves * 2.0 * std::numbers::pi * b / 180.0) + rng.uniform(0, 0.2));
    points.push_back(profile.back() * unit(degrees(-179.0 + 2.0 * b)));
  }
  const std::vector<std::size_t> expected = slow_minima(profile, options);
  const auto found = obstacle_distances(points, {0, 0}, options);
  RC_ASSERT(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) RC_ASSERT(std::abs(found[i].distance_m - profile[expected[i]]) < 1e-9);
}

RC_GTEST_PROP(VoronoiObstaclesProperty, NearestIsAboutTheClearanceAndOrderDoesNotMatter, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) points.push_back({rng.uniform(-3, 3), rng.uniform(-3, 3)});
  const auto found = obstacle_distances(points, {0, 0});
  RC_ASSERT(!found.empty());
  RC_ASSERT(std::abs(found[0].distance_m - clearance_m(points, {0, 0})) <= ObstacleOptions{}.near_m);
  RC_ASSERT(std::is_sorted(found.begin(), found.end(),
                           [](const auto& a, const auto& b) { return a.distance_m < b.distance_m; }));
  std::reverse(points.begin(), points.end());
  const auto again = obstacle_distances(points, {0, 0});
  RC_ASSERT(again.size() == found.size());
  for (std::size_t i = 0; i < found.size(); ++i) RC_ASSERT(norm(found[i].closest - again[i].closest) < 1e-9);
}

}  // namespace
}  // namespace echoarc::nav
