// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/nav/corridor_heading.hpp"
#include "localise_ray_world.hpp"

namespace echoarc::nav {
namespace {

/// Both walls of a corridor 2 m wide that runs in a direction, seen with noise.
std::vector<Vec2> corridor(Angle direction, double noise_m, Rng& rng) {
  std::vector<Vec2> points;
  for (int n = 0; n < 120; ++n) {
    const double along = rng.uniform(-2.0, 2.0);
    const double side = n % 2 == 0 ? 1.0 : -1.0;
    points.push_back(rotate({along, side + rng.normal(0.0, noise_m)}, direction));
  }
  return points;
}

TEST(WallDirection, IsThatOfTheCorridorModuloAQuarterTurn) {
  Rng rng(1);
  for (const double deg : {0.0, 12.0, 44.0, 46.0, 89.5, 130.0, -70.0}) {
    const auto found = wall_direction(corridor(degrees(deg), 0.02, rng));
    ASSERT_TRUE(found.has_value()) << deg;
    EXPECT_LT(abs(turn_between(found->direction, degrees(deg))), degrees(1.0)) << deg;
    EXPECT_GE(found->direction.deg(), 0.0);
    EXPECT_LT(found->direction.deg(), 90.0);
    EXPECT_GT(found->strength, 0.35);
    EXPECT_LE(found->strength, 1.0);
  }
}

TEST(WallDirection, WallsAtARightAngleAgree) {
  Rng rng(2);
  std::vector<Vec2> points = corridor(degrees(20.0), 0.02, rng);
  for (const Vec2 p : corridor(degrees(110.0), 0.02, rng)) points.push_back(p);
  const auto found = wall_direction(points);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->direction.deg(), 20.0, 1.0);
}

TEST(WallDirection, ThereIsNoneAmongPointsWithoutLines) {
  Rng rng(3);
  std::vector<Vec2> cloud;
  for (int n = 0; n < 200; ++n) cloud.push_back(rng.uniform(0.0, 2.0) * unit(degrees(rng.uniform(0.0, 360.0))));
  EXPECT_FALSE(wall_direction(cloud).has_value());
  EXPECT_FALSE(wall_direction(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}}).has_value());
  EXPECT_FALSE(wall_direction(std::vector<Vec2>(100, {std::numeric_limits<double>::quiet_NaN(), 0.0})).has_value());
  EXPECT_FALSE(wall_direction(std::vector<Vec2>(100, {1.0, 1.0})).has_value());
  EXPECT_FALSE(wall_direction(DenseGrid<CellState>()).has_value());
}

TEST(WallDirection, OfAMapIsThatOfItsWalls) {
  const auto straight = wall_direction(testing::grid_of(testing::even_room()));
  ASSERT_TRUE(straight.has_value());
  EXPECT_LT(abs(turn_between(straight->direction, {})), degrees(0.5));
  std::vector<Vec2> corners;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{5, 0}, Vec2{5, 4}, Vec2{0, 4}})
    corners.push_back(rotate(p, degrees(25.0)) + Vec2{2.0, 0.0});
  const auto turned = wall_direction(testing::grid_of(testing::outline(corners)));
  ASSERT_TRUE(turned.has_value());
  EXPECT_NEAR(turned->direction.deg(), 25.0, 0.7);
}

TEST(TurnBetween, WorkedNumbers) {
  EXPECT_NEAR(turn_between(degrees(3.0), degrees(0.0)).deg(), -3.0, 1e-9);
  EXPECT_NEAR(turn_between(degrees(88.0), degrees(1.0)).deg(), 3.0, 1e-9);
  EXPECT_NEAR(turn_between(degrees(182.0), degrees(90.0)).deg(), -2.0, 1e-9);
}

TEST(HeadingCorrection, BringsTheCorridorIntoTheDirectionOfTheMap) {
  Rng rng(4);
  const WallDirection on_map{degrees(10.0), 1.0};
  // Seen by a heading that is 4 degrees too small the corridor lies 4 degrees too low.
  const auto turn = heading_correction(corridor(degrees(100.0 - 4.0), 0.02, rng), on_map);
  ASSERT_TRUE(turn.has_value());
  EXPECT_NEAR(turn->deg(), 4.0, 1.0);
  EXPECT_FALSE(heading_correction(corridor(degrees(40.0), 0.02, rng), on_map).has_value());
  EXPECT_FALSE(heading_correction({}, on_map).has_value());
}

TEST(CorridorHeadingOptions, AreLegal) {
  EXPECT_TRUE(validate(CorridorHeadingOptions{}));
}

}  // namespace
}  // namespace echoarc::nav
