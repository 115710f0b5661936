// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/path.hpp"
#include "echoarc/nav/path_follower.hpp"
#include "unit/nav/plan_drives.hpp"

namespace echoarc::nav {
namespace {

const PathFollowerOptions options{.speed_m_s = 0.3, .look_ahead_m = 0.5, .arrival_m = 0.1};

TEST(PathFollower, HeadsForAPointAheadOnThePath) {
  PathFollower follower(options);
  follower.follow({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}});
  const Following start = follower.update({{0.0, 0.1}, {}});
  EXPECT_EQ(start.target, (Vec2{0.5, 0.0}));
  EXPECT_DOUBLE_EQ(start.off_path_m, 0.1);
  EXPECT_DOUBLE_EQ(start.remaining_m, 4.0);
  EXPECT_EQ(follower.update({{1.0, 0.0}, {}}).target, (Vec2{1.5, 0.0}));
  EXPECT_NEAR(norm(follower.update({{1.8, 0.0}, {}}).target - Vec2{2.0, 0.3}), 0.0, 1e-12);
  EXPECT_FALSE(follower.update({{2.0, 1.5}, {}}).arrived);
  EXPECT_TRUE(follower.update({{2.0, 1.95}, {}}).arrived);
}

TEST(PathFollower, DrawsTheTargetInUntilItIsInSight) {
  PathFollower follower(options);
  follower.follow({{0.0, 0.0}, {0.2, 0.0}, {0.2, 1.0}});
  const auto in_sight = [](Vec2, Vec2 to) { return to.y <= 0.1; };
  const Following following = follower.update({{0.0, 0.0}, {}}, in_sight);
  EXPECT_LE(following.target.y, 0.1);
  EXPECT_GT(norm(following.target), 0.1);
  const Following blind = follower.update({{0.0, 0.0}, {}}, [](Vec2, Vec2) { return false; });
  EXPECT_GT(norm(blind.target), 0.05) << "never down to nothing";
}

TEST(PathFollower, DrivesAPathThatComesNearItselfWhole) {
  PathFollower follower(options);
  follower.follow({{0.0, 0.0}, {3.0, 0.0}, {3.0, 0.3}, {0.0, 0.3}});
  EXPECT_FALSE(follower.update({{0.0, 0.2}, {}}).arrived) << "its end is near, but not along the path";
  EXPECT_EQ(follower.update({{0.0, 0.2}, {}}).target, (Vec2{0.5, 0.0}));
}

TEST(PathFollower, GetsPastAPlaceWhereThePathMeetsItself) {
  PathFollower follower(options);
  follower.follow({{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.15}, {0.0, 0.15}, {0.0, 0.0}, {0.0, -2.0}});
  Following following;
  for (int k = 0; k < 5; ++k) following = follower.update({{0.0, -0.01 * k}, degrees(-90.0)});
  EXPECT_LT(following.target.y, -0.1) << "not the first leg again, on which it stands as well";
}

TEST(PathFollower, ComesBackToAnEndThatItHasPassedAside) {
  PathFollower follower(options);
  follower.follow({{0.0, 0.0}, {1.0, 0.0}});
  const Following passed = follower.update({{1.05, 0.15}, {}});
  EXPECT_FALSE(passed.arrived);
  EXPECT_NEAR(passed.remaining_m, std::hypot(0.05, 0.15), 1e-12) << "or it would stand still there";
}

TEST(PathFollower, WithoutAPathOrPose) {
  PathFollower follower(options);
  EXPECT_TRUE(follower.update({{1.0, 2.0}, {}}).arrived);
  follower.follow({{0.0, 0.0}, {3.0, 0.0}});
  const Following lost = follower.update({{std::nan(""), 0.0}, {}});
  EXPECT_FALSE(lost.arrived);
  EXPECT_DOUBLE_EQ(lost.remaining_m, 3.0);
}

TEST(PathFollower, SteersAnArcThroughTheTarget) {
  const RobotLimits limits;
  const RobotVelocity velocity = steer_to({}, {0.4, 0.2}, 5.0, limits, options);
  EXPECT_DOUBLE_EQ(velocity.forward_m_s, 0.3);
  const double radius_m = velocity.forward_m_s / velocity.turn_per_s.rad();
  EXPECT_NEAR(std::hypot(0.4, 0.2 - radius_m), radius_m, 1e-12);
  const RobotVelocity aside = steer_to({}, {0.0, -1.0}, 5.0, limits, options);
  EXPECT_EQ(aside.forward_m_s, 0.0) << "turns first";
  EXPECT_LT(aside.turn_per_s.rad(), 0.0);
  EXPECT_NEAR(steer_to({}, {0.03, 0.0}, 0.03, limits, options).forward_m_s, std::sqrt(2.0 * 0.3 * 0.03), 1e-12);
  EXPECT_EQ(steer_to({}, {std::nan(""), 1.0}, 5.0, limits, options), RobotVelocity{});
  EXPECT_EQ(steer_to({}, {0.0, 0.0}, 5.0, limits, options), RobotVelocity{});
}

RC_GTEST_PROP(PathFollowerProperty, KeepsTheLimitsAndGetsThere, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> path{{0.0, 0.0}};
  for (std::uint64_t k = 0; k < 1 + rng.below(5); ++k)
    path.push_back(path.back() + rng.uniform(0.3, 2.0) * unit(degrees(rng.uniform(-180.0, 180.0))));
  const RobotLimits limits;
  PathFollower follower(options);
  follower.follow(path);
  Pose2 T_world_base{{}, degrees(rng.uniform(-180.0, 180.0))};
  Following following;
  double furthest_m = 0.0;
  for (int k = 0; k < 2000 && !following.arrived; ++k) {
    following = follower.update(T_world_base);
    furthest_m = std::max(furthest_m, following.off_path_m);
    const RobotVelocity v = steer_to(T_world_base, following.target, following.remaining_m, limits, options);
    RC_ASSERT(v.forward_m_s >= 0.0 && v.forward_m_s <= options.speed_m_s);
    RC_ASSERT(abs(v.turn_per_s).rad() <= limits.turn_rate_per_s.rad() + 1e-12);
    T_world_base = driven(T_world_base, v, 0.1);
  }
  RC_ASSERT(following.arrived);
  RC_ASSERT(furthest_m < options.look_ahead_m);
}

}  // namespace
}  // namespace echoarc::nav
