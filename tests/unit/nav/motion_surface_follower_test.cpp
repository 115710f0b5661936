// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/nav/surface_follower.hpp"
#include "unit/nav/motion_world.hpp"

namespace echoarc::nav {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_s = 300.0;

/// The curve of the cardboard, scene E1.
std::vector<Segment> cardboard() {
  const auto place = [](double x) { return Vec2{x, 1.0 + 0.16 * std::cos(2.6 * x + 0.5) - 0.07 * std::sin(4.3 * x)}; };
  std::vector<Segment> walls;
  for (int k = -20; k < 20; ++k) walls.push_back({place(0.05 * k), place(0.05 * (k + 1))});
  return walls;
}

std::vector<Segment> cylinder(double radius_m) {
  std::vector<Segment> walls;
  for (int k = 0; k < 36; ++k)
    walls.push_back({radius_m * unit(degrees(10.0 * k)), radius_m * unit(degrees(10.0 * k + 10.0))});
  return walls;
}

double distance_m(const std::vector<Segment>& walls, Vec2 point) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Segment& wall : walls) least_m = std::min(least_m, distance_m(wall, point));
  return least_m;
}

TEST(SurfaceFollower, FollowsACurveToItsEndOnEitherSide) {
  for (const bool left : {true, false}) {
    MotionWorld world(cardboard(), {{left ? -1.0 : 1.0, 0.0}, left ? Angle{} : degrees(180.0)});
    world.remembered_scans = 1;
    SurfaceFollower follower({}, {.left = left});
    int abreast = 0;
    world.watch = [&](const Steering& steering) {
      if (steering.followed != (left ? WallSide::left : WallSide::right)) return;
      ++abreast;
      EXPECT_NEAR(distance_m(cardboard(), world.T_world_base().position), 1.0, 0.4);
    };
    const Steering last = world.run(follower, longest_s);
    EXPECT_EQ(last.status, Status::finished);
    EXPECT_EQ(last.reason, "the surface ends here");
    EXPECT_GT(abreast, 60);
    EXPECT_GT(world.T_world_base().position.x * (left ? 1.0 : -1.0), 0.9);
  }
}

TEST(SurfaceFollower, GoesRoundACylinderAtItsDistance) {
  for (const bool left : {true, false}) {
    MotionWorld world(cylinder(0.5), {{-1.5, 0.0}, left ? degrees(-90.0) : degrees(90.0)});
    SurfaceFollower follower({}, {.left = left});
    world.watch = [&](const Steering&) { EXPECT_NEAR(norm(world.T_world_base().position), 1.5, 0.25); };
    const Steering last = world.run(follower, longest_s);
    EXPECT_EQ(last.status, Status::finished);
    EXPECT_EQ(last.reason, "round: the start is reached again");
    EXPECT_GT(world.driven_m(), 8.5);
  }
}

TEST(SurfaceFollower, RoundARoom) {
  MotionWorld world(rectangle({0.0, 0.0}, {5.0, 4.0}), {{1.1, 1.1}, degrees(100.0)});
  SurfaceFollower follower({});
  EXPECT_EQ(world.run(follower, longest_s).status, Status::finished);
  EXPECT_GT(world.clearance_m(), 0.2);
}

TEST(SurfaceFollower, AlongAPlaneItSettlesAtItsDistance) {
  MotionWorld world({{{-1.0, 1.5}, {30.0, 1.5}}}, {});
  SurfaceFollower follower({});
  (void)world.run(follower, 40.0);
  EXPECT_NEAR(1.5 - world.T_world_base().position.y, SurfaceFollowerOptions{}.distance_m, 0.02);
}

TEST(SurfaceFollower, TurnsBesideWhatItFacesFirst) {
  MotionWorld world({{{1.2, -3.0}, {1.2, 3.0}}}, {});
  SurfaceFollower follower({});
  (void)world.run(follower, 6.0);
  EXPECT_NEAR(world.T_world_base().heading.deg(), -90.0, 20.0);
}

std::string why_it_fails(MotionWorld& world) {
  SurfaceFollower follower({});
  const Steering last = world.run(follower, longest_s);
  EXPECT_EQ(last.status, Status::failed);
  EXPECT_EQ(last.wanted, RobotVelocity{});
  EXPECT_EQ(follower.update(world.surroundings()).reason, last.reason);
  return last.reason;
}

TEST(SurfaceFollower, NothingToFollowEndsIt) {
  MotionWorld silent(cardboard(), {});
  silent.deaf = true;
  EXPECT_EQ(why_it_fails(silent), "no surface is heard within its reach");
  MotionWorld far({{{-1.0, 2.5}, {1.0, 2.5}}}, {});
  EXPECT_EQ(why_it_fails(far), "no surface is heard within its reach");
}

TEST(SurfaceFollower, BoxedInAndAPoseJumpEndIt) {
  MotionWorld boxed(rectangle({-0.29, -0.29}, {0.29, 0.29}), {});
  EXPECT_EQ(why_it_fails(boxed), "stuck: no way on after 3 tries to back off and turn");
  MotionWorld world(rectangle({0.0, 0.0}, {5.0, 4.0}), {{1.1, 1.1}, degrees(100.0)});
  bool jumped = false;
  world.watch = [&](const Steering&) {
    if (!jumped && world.time_s() > 3.0) world.jump({0.0, 2.0});
    jumped = world.time_s() > 3.0;
  };
  EXPECT_EQ(why_it_fails(world), "the pose jumped by 2.0 m");
}

TEST(SurfaceFollower, WhatIsNoNumberEndsItOrIsPassedOver) {
  SurfaceFollower lost({});
  EXPECT_EQ(lost.update({.T_world_base = {{}, radians(nan_value)}}).reason, "the pose is no number");
  const std::vector<Vec2> points{{nan_value, 0.3}, {0.0, 1.0}};
  SurfaceFollower follower({});
  const Steering steering = follower.update({.points = points});
  EXPECT_EQ(steering.followed, WallSide::left);
  EXPECT_GT(steering.wanted.forward_m_s, 0.0);
  EXPECT_TRUE(validate(SurfaceFollowerOptions{}));
}

}  // namespace
}  // namespace echoarc::nav
