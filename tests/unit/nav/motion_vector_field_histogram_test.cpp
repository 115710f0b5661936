// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/vector_field_histogram.hpp"
#include "unit/nav/motion_world.hpp"

namespace echoarc::nav {
namespace {

constexpr std::size_t sectors = VectorFieldHistogram::sector_count;
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

std::vector<Vec2> scattered(Rng& rng, int count) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) points.push_back(rng.uniform(0.1, 3.5) * unit(degrees(rng.uniform(-180.0, 180.0))));
  return points;
}

/// The slow obvious way: every sector asks every point, with the angle its enlarged disc covers.
std::vector<double> magnitudes(const std::vector<Vec2>& points, double radius_m) {
  const double reach_m = 2.0 * std::numbers::sqrt2;
  std::vector<double> plain(sectors, 0.0);
  for (std::size_t k = 0; k < sectors; ++k)
    for (const Vec2 point : points) {
      const double away_m = norm(point);
      const double covered = std::max(std::asin(std::min(1.0, radius_m / away_m)), degrees(2.5).rad());
      const double aside = std::abs(wrap(bearing(point) - degrees(5.0 * double(k) + 2.5)).rad());
      if (aside <= covered) plain[k] = std::max(plain[k], 1.0 - away_m / reach_m);
    }
  std::vector<double> smooth(sectors, 0.0);
  for (std::size_t k = 0; k < sectors; ++k)
    for (int aside = -2; aside <= 2; ++aside)
      smooth[k] += double(3 - std::abs(aside)) / 9.0 * plain[(k + sectors + std::size_t(aside + 2) - 2) % sectors];
  return smooth;
}

RC_GTEST_PROP(VectorFieldHistogram, WeighsAsTheSlowWayDoes, (std::uint64_t seed)) {
  Rng rng(seed);
  const RobotBody body{.radius_m = rng.uniform(0.02, 0.5)};
  const auto points = scattered(rng, 30);
  VectorFieldHistogram histogram(body);
  (void)histogram.steer({}, {100.0, 0.0}, points);
  const auto expected = magnitudes(points, body.radius_m + 0.05);
  for (std::size_t k = 0; k < sectors; ++k) RC_ASSERT(std::abs(histogram.magnitudes()[k] - expected[k]) < 1e-9);
}

RC_GTEST_PROP(VectorFieldHistogram, TurnsWithTheWorldByWholeSectors, (std::uint64_t seed)) {
  Rng rng(seed);
  const auto points = scattered(rng, 12);
  const Vec2 goal = rng.uniform(0.5, 8.0) * unit(degrees(rng.uniform(-180.0, 180.0)));
  const Pose2 T_other_world{{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)}, degrees(5.0 * double(rng.below(72)))};
  std::vector<Vec2> moved;
  for (const Vec2 point : points) moved.push_back(T_other_world * point);
  VectorFieldHistogram here({});
  VectorFieldHistogram there({});
  const auto one = here.steer({}, goal, points);
  const auto other = there.steer(T_other_world, T_other_world * goal, moved);
  RC_ASSERT(one.has_value() == other.has_value());
  if (!one) return;
  RC_ASSERT(std::abs(wrap(one->direction + T_other_world.heading - other->direction).rad()) < 1e-9);
  RC_ASSERT(one->speed_m_s == other->speed_m_s);
}

RC_GTEST_PROP(VectorFieldHistogram, NeverPointsIntoAClosedSector, (std::uint64_t seed)) {
  Rng rng(seed);
  VectorFieldHistogram histogram({});
  const auto heading = histogram.steer({}, 5.0 * unit(degrees(rng.uniform(-180.0, 180.0))), scattered(rng, 12));
  if (!heading) return;
  const double turn = std::fmod(heading->direction.rad() + 4.0 * std::numbers::pi, 2.0 * std::numbers::pi);
  RC_ASSERT(!histogram.closed()[std::size_t(turn / degrees(5.0).rad()) % sectors]);
}

TEST(VectorFieldHistogram, GoesStraightWhereAllIsFree) {
  VectorFieldHistogram histogram({});
  const auto heading = histogram.steer({{1.0, 1.0}, degrees(90.0)}, {4.0, 5.0}, {});
  ASSERT_TRUE(heading);
  EXPECT_NEAR(heading->direction.rad(), std::atan2(4.0, 3.0), 1e-12);
  EXPECT_EQ(heading->speed_m_s, HistogramOptions{}.cruise_m_s);
}

TEST(VectorFieldHistogram, WhatIsBeyondTheGoalDoesNotCount) {
  const std::vector<Vec2> wall{{1.6, -0.2}, {1.6, 0.0}, {1.6, 0.2}};
  VectorFieldHistogram histogram({});
  const auto near_goal = histogram.steer({}, {1.0, 0.0}, wall);
  ASSERT_TRUE(near_goal);
  EXPECT_NEAR(near_goal->direction.rad(), 0.0, 1e-12);
  const auto far_goal = histogram.steer({}, {3.0, 0.0}, wall);
  ASSERT_TRUE(far_goal);
  EXPECT_GT(std::abs(far_goal->direction.deg()), 15.0);
}

/// Between the thresholds a sector stays what it was.
TEST(VectorFieldHistogram, ThresholdsHaveHysteresis) {
  const auto closed_at = [](VectorFieldHistogram& histogram, double away_m) {
    (void)histogram.steer({}, {100.0, 0.0}, std::vector<Vec2>{{away_m, 0.01}});
    return histogram.closed()[0];
  };
  VectorFieldHistogram coming({});
  EXPECT_FALSE(closed_at(coming, 2.1));
  EXPECT_TRUE(closed_at(coming, 1.6));
  EXPECT_TRUE(closed_at(coming, 2.1));
  EXPECT_FALSE(closed_at(coming, 2.6));
  EXPECT_FALSE(closed_at(coming, 2.1));
}

TEST(VectorFieldHistogram, SaysBlockedWhenBoxedInAndForWhatIsNoNumber) {
  std::vector<Vec2> ring;
  for (int k = 0; k < 36; ++k) ring.push_back(0.6 * unit(degrees(10.0 * k)));
  VectorFieldHistogram histogram({});
  EXPECT_FALSE(histogram.steer({}, {3.0, 0.0}, ring));
  histogram.reset();
  EXPECT_TRUE(histogram.steer({}, {3.0, 0.0}, std::vector<Vec2>{{nan_value, 0.5}, {0.5, nan_value}}));
  EXPECT_FALSE(histogram.steer({}, {nan_value, 0.0}, {}));
  EXPECT_FALSE(histogram.steer({{nan_value, 0.0}, Angle{}}, {1.0, 0.0}, {}));
  EXPECT_FALSE(histogram.steer({{}, radians(nan_value)}, {1.0, 0.0}, {}));
  EXPECT_TRUE(validate(HistogramOptions{}));
}

TEST(VectorFieldHistogram, TurnsFirstWhenTheWayIsBehind) {
  const VectorFieldHistogram histogram({});
  const RobotVelocity back = histogram.velocity({}, {degrees(170.0), 0.25});
  EXPECT_EQ(back.forward_m_s, 0.0);
  EXPECT_GT(back.turn_per_s.rad(), 0.5);
  const RobotVelocity ahead = histogram.velocity({}, {Angle{}, 0.25});
  EXPECT_EQ(ahead, (RobotVelocity{0.25, Angle{}}));
}

/// Drives to a goal; whether it arrived without a touch.
testing::AssertionResult arrives(MotionWorld world, Vec2 goal) {
  const RobotBody body;
  VectorFieldHistogram histogram(body);
  while (norm(goal - world.T_world_base().position) > 0.15) {
    if (world.time_s() > 120.0) return testing::AssertionFailure() << "too late";
    const Surroundings seen = world.surroundings();
    const auto heading = histogram.steer(seen.T_world_base, goal, seen.points);
    if (!heading) return testing::AssertionFailure() << "blocked at " << seen.T_world_base.position.x;
    world.drive(
        safe_velocity(seen.T_world_base, histogram.velocity(seen.T_world_base, *heading), body.radius_m, seen.points));
    if (world.clearance_m() < 0.02) return testing::AssertionFailure() << "touched a wall";
  }
  return testing::AssertionSuccess();
}

std::vector<Segment> turned(std::vector<Segment> walls, Angle by) {
  for (Segment& wall : walls) wall = {rotate(wall.from, by), rotate(wall.to, by)};
  return walls;
}

TEST(VectorFieldHistogram, DrivesThroughAnOpeningOf80Centimetres) {
  for (const double aside_m : {0.0, 0.4}) {
    const auto walls = rectangle({0.0, -3.0}, {8.0, 3.0}) +
                       std::vector<Segment>{{{4.0, -3.0}, {4.0, aside_m - 0.4}}, {{4.0, aside_m + 0.4}, {4.0, 3.0}}};
    for (const double turn_deg : {0.0, 2.5, 33.3}) {
      const Angle turn = degrees(turn_deg);
      const Pose2 T_world_base{rotate({1.0, -1.0}, turn), turn};
      EXPECT_TRUE(arrives({turned(walls, turn), T_world_base}, rotate({7.0, 0.0}, turn))) << aside_m << " " << turn_deg;
    }
  }
}

TEST(VectorFieldHistogram, DrivesThroughACorridorOf90Centimetres) {
  for (const double turn_deg : {0.0, 1.3, 2.5, 33.3}) {
    const Angle turn = degrees(turn_deg);
    const Pose2 T_world_base{rotate({1.0, 0.35}, turn), turn + degrees(10.0)};
    EXPECT_TRUE(arrives({turned(rectangle({0.0, 0.0}, {6.0, 0.9}), turn), T_world_base}, rotate({5.0, 0.45}, turn)));
  }
}

TEST(VectorFieldHistogram, DrivesAroundPosts) {
  const auto walls =
      rectangle({0.0, -3.0}, {8.0, 3.0}) + rectangle({3.0, -0.2}, {3.2, 0.2}) + rectangle({5.0, -1.0}, {5.3, 0.1});
  EXPECT_TRUE(arrives({walls, {{1.0, 0.0}, Angle{}}}, {7.0, 0.0}));
}

}  // namespace
}  // namespace echoarc::nav
