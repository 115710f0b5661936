// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/nav/wall_follower.hpp"
#include "unit/nav/motion_world.hpp"

namespace echoarc::nav {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_s = 300.0;

std::string side_name(bool left) {
  return left ? "left" : "right";
}

/// Drives the loop; whether it closed without a touch, most of it with the wall on the side where it was to be.
testing::AssertionResult closes(MotionWorld& world, bool left) {
  WallFollower follower({}, {.left = left});
  const WallSide side = left ? WallSide::left : WallSide::right;
  int followed = 0;
  int other = 0;
  world.watch = [&](const Steering& steering) {
    followed += steering.followed == side ? 1 : 0;
    other += steering.followed && *steering.followed != side ? 1 : 0;
  };
  const Steering last = world.run(follower, longest_s);
  const std::string where = side_name(left) + ", " + last.reason + " at " +
                            std::to_string(world.T_world_base().position.x) + " " +
                            std::to_string(world.T_world_base().position.y);
  if (last.status != Status::finished) return testing::AssertionFailure() << "not finished: " << where;
  if (last.wanted != RobotVelocity{}) return testing::AssertionFailure() << "does not halt: " << where;
  if (world.clearance_m() <= 0.05) return testing::AssertionFailure() << "too near: " << where;
  if (other > 0 || followed < int(world.track().size() * 3 / 4))
    return testing::AssertionFailure() << "followed " << followed << " of " << world.track().size() << ": " << where;
  return testing::AssertionSuccess() << where;
}

/// How far the robot's way went around a point, in turns, counter-clockwise.
double turns_around(const MotionWorld& world, Vec2 point) {
  Angle sum;
  for (std::size_t k = 1; k < world.track().size(); ++k)
    sum += wrap(bearing(world.track()[k].position - point) - bearing(world.track()[k - 1].position - point));
  return sum.deg() / 360.0;
}

/// Newest points alone, or a memory that is filled by a third of the echoes.
void set_hearing(MotionWorld& world, bool sparse) {
  world.echo_every = sparse ? 3 : 1;
}

TEST(WallFollower, RoundARoomOnEitherSideFromItsMiddleAndFromItsWall) {
  for (const bool left : {true, false})
    for (const bool sparse : {true, false})
      for (const Pose2& T_world_base : {Pose2{{2.0, 1.5}, degrees(20.0)}, Pose2{{1.0, 0.6}, Angle{}}}) {
        MotionWorld world(rectangle({0.0, 0.0}, {4.0, 3.0}), T_world_base);
        set_hearing(world, sparse);
        EXPECT_TRUE(closes(world, left));
        EXPECT_GT(turns_around(world, {2.0, 1.5}) * (left ? -1.0 : 1.0), 0.7);
      }
}

TEST(WallFollower, AroundTheConvexCornersOfABlock) {
  for (const bool left : {true, false})
    for (const bool sparse : {true, false}) {
      MotionWorld world(rectangle({0.0, 0.0}, {8.0, 6.0}) + rectangle({3.0, 2.0}, {5.0, 4.0}),
                        {{4.0, 1.3}, left ? Angle{} : degrees(180.0)});
      set_hearing(world, sparse);
      EXPECT_TRUE(closes(world, left));
      EXPECT_NEAR(turns_around(world, {4.0, 3.0}) * (left ? 1.0 : -1.0), 1.0, 0.1);
    }
}

TEST(WallFollower, ThroughConcaveAndConvexCorners) {
  const std::vector<Segment> walls{{{0.0, 0.0}, {6.0, 0.0}}, {{6.0, 0.0}, {6.0, 5.0}}, {{6.0, 5.0}, {3.5, 5.0}},
                                   {{3.5, 5.0}, {3.5, 3.0}}, {{3.5, 3.0}, {2.5, 3.0}}, {{2.5, 3.0}, {2.5, 5.0}},
                                   {{2.5, 5.0}, {0.0, 5.0}}, {{0.0, 5.0}, {0.0, 0.0}}};
  for (const bool left : {true, false})
    for (const bool sparse : {true, false}) {
      MotionWorld world(walls, {{1.0, 2.0}, degrees(30.0)});
      set_hearing(world, sparse);
      EXPECT_TRUE(closes(world, left));
      EXPECT_GT(world.driven_m(), 16.0);  // into both bays
    }
}

TEST(WallFollower, PassesADoorwayOf90Centimetres) {
  const std::vector<Segment> walls{{{0.0, 0.0}, {2.0, 0.0}},
                                   {{2.9, 0.0}, {5.0, 0.0}},
                                   {{5.0, 0.0}, {5.0, 4.0}},
                                   {{5.0, 4.0}, {0.0, 4.0}},
                                   {{0.0, 4.0}, {0.0, 0.0}}};
  for (const bool left : {true, false}) {
    MotionWorld world(walls, {{2.0, 2.0}, degrees(30.0)});
    EXPECT_TRUE(closes(world, left));
    for (const Pose2& T_world_base : world.track()) EXPECT_GT(T_world_base.position.y, 0.25);
  }
}

TEST(WallFollower, GoesAroundAPillarOnce) {
  MotionWorld world(rectangle({-0.15, -0.15}, {0.15, 0.15}), {{-1.0, 0.6}, Angle{}});
  EXPECT_TRUE(closes(world, false));
  EXPECT_LT(turns_around(world, {}), -0.9);
  EXPECT_GT(turns_around(world, {}), -2.6);
}

TEST(WallFollower, KeepsItsDistance) {
  MotionWorld world({{{-1.0, 1.0}, {30.0, 1.0}}}, {});
  WallFollower follower({});
  (void)world.run(follower, 60.0);
  EXPECT_NEAR(1.0 - world.T_world_base().position.y, WallFollowerOptions{}.distance_m, 0.02);
  EXPECT_NEAR(world.T_world_base().heading.deg(), 0.0, 1.0);
}

TEST(WallFollower, DrivesToTheNearestWallFirst) {
  MotionWorld world(rectangle({-2.5, -2.5}, {2.5, 2.5}), {{0.0, 0.5}, degrees(-90.0)});
  EXPECT_TRUE(closes(world, true));
}

/// The reason for which a follower ends in a world of its own.
std::string why_it_fails(MotionWorld& world) {
  WallFollower follower({});
  const Steering last = world.run(follower, longest_s);
  EXPECT_EQ(last.status, Status::failed);
  EXPECT_EQ(last.wanted, RobotVelocity{});
  EXPECT_EQ(follower.update(world.surroundings()).reason, last.reason);  // for good
  return last.reason;
}

TEST(WallFollower, SilentSensorsEndItWhereItStands) {
  MotionWorld world(rectangle({0.0, 0.0}, {4.0, 3.0}), {{2.0, 1.5}, Angle{}});
  world.deaf = true;
  EXPECT_EQ(why_it_fails(world), "the wall is lost: nothing is heard, and no wall is known");
  EXPECT_EQ(world.driven_m(), 0.0);
}

TEST(WallFollower, SilenceOnTheWayStopsIt) {
  MotionWorld world(rectangle({0.0, 0.0}, {4.0, 3.0}), {{1.0, 0.6}, Angle{}});
  world.watch = [&](const Steering&) { world.deaf = world.time_s() > 5.0; };
  EXPECT_EQ(why_it_fails(world), "the wall is lost: nothing is heard, and no wall is known");
  EXPECT_GT(world.clearance_m(), 0.0);
}

TEST(WallFollower, WithoutAnEchoItGoesToAWallOfTheMap) {
  DenseGrid<CellState> map({.cell_m = 0.1}, 60, 60, CellState::free);
  map.at({5, 40}) = CellState::occupied;
  map.at({50, 40}) = CellState::occupied;
  WallFollower follower({});
  Surroundings seen{.T_world_base = {{2.0, 4.0}, degrees(90.0)}, .map = &map};
  Steering steering;
  for (; seen.time_s < 6.0; seen.time_s += 0.1) steering = follower.update(seen);
  EXPECT_EQ(steering.reason, "to the nearest wall");
  EXPECT_GT(steering.wanted.turn_per_s.deg(), 10.0);  // it lies to the left
}

TEST(WallFollower, BoxedInItGivesUp) {
  MotionWorld world(rectangle({-0.29, -0.29}, {0.29, 0.29}), {});
  EXPECT_EQ(why_it_fails(world), "stuck: no way on after 3 tries to back off and turn");
  EXPECT_GT(world.clearance_m(), 0.0);
}

TEST(WallFollower, APoseJumpEndsIt) {
  MotionWorld world(rectangle({0.0, 0.0}, {4.0, 3.0}), {{1.0, 0.6}, Angle{}});
  bool jumped = false;
  world.watch = [&](const Steering&) {
    if (!jumped && world.time_s() > 3.0) world.jump({1.0, 0.0});
    jumped = world.time_s() > 3.0;
  };
  EXPECT_EQ(why_it_fails(world), "the pose jumped by 1.0 m");
}

TEST(WallFollower, WhatIsNoNumberEndsItOrIsPassedOver) {
  WallFollower lost({});
  EXPECT_EQ(lost.update({.T_world_base = {{nan_value, 0.0}, Angle{}}}).reason, "the pose is no number");
  const std::vector<Vec2> points{{nan_value, 0.3}, {0.0, 0.6}, {0.1, nan_value}};
  WallFollower follower({});
  const Steering steering = follower.update({.points = points});
  EXPECT_EQ(steering.status, Status::running);
  EXPECT_EQ(steering.followed, WallSide::left);
  EXPECT_EQ(steering.wanted.forward_m_s, WallFollowerOptions{}.cruise_m_s);
}

TEST(WallFollower, AWayWithoutEndEndsIt) {
  MotionWorld world({{{-1.0, 0.6}, {100.0, 0.6}}}, {});
  WallFollower follower({}, {.longest_m = 5.0});
  const Steering last = world.run(follower, longest_s);
  EXPECT_EQ(last.status, Status::failed);
  EXPECT_EQ(last.reason, "no way round: the longest way is driven");
  EXPECT_TRUE(validate(WallFollowerOptions{}));
}

}  // namespace
}  // namespace echoarc::nav
