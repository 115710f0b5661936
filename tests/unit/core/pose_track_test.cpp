// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/pose_track.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Odometry at(double time_s, double x_m, double heading_deg) {
  return {time_s, {{x_m, 0.0}, degrees(heading_deg)}, 0};
}

TEST(PoseTrack, InterpolatesPositionAndShortestTurn) {
  const std::vector<Odometry> odometry = {at(1.0, 0.0, 170.0), at(3.0, 4.0, -170.0)};
  const PoseTrack track(odometry);
  const auto pose = track.T_world_robot(1.5);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->position.x, 1.0, 1e-12);
  EXPECT_NEAR(pose->heading.deg(), 175.0, 1e-12) << "through 180 degrees, not through 0";
}

TEST(PoseTrack, EndsBelongToTheTrackAndNothingBeyond) {
  const std::vector<Odometry> odometry = {at(1.0, 0.0, 0.0), at(3.0, 4.0, 0.0)};
  const PoseTrack track(odometry);
  EXPECT_EQ(track.T_world_robot(1.0)->position.x, 0.0);
  EXPECT_EQ(track.T_world_robot(3.0)->position.x, 4.0);
  EXPECT_FALSE(track.T_world_robot(0.999));
  EXPECT_FALSE(track.T_world_robot(3.001));
  EXPECT_FALSE(track.T_world_robot(nan));
  EXPECT_FALSE(PoseTrack{}.T_world_robot(0.0));
}

TEST(PoseTrack, RefusesToBridgeAGap) {
  const std::vector<Odometry> odometry = {at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(9.0, 9.0, 0.0)};
  const PoseTrack track(odometry);
  EXPECT_TRUE(track.T_world_robot(0.5, 1.0));
  EXPECT_FALSE(track.T_world_robot(5.0, 1.0));
  EXPECT_TRUE(track.T_world_robot(9.0, 1.0)) << "a record needs no neighbours";
}

TEST(PoseTrack, CountsWhatItLeavesOut) {
  const std::vector<Odometry> odometry = {at(0.0, 0.0, 0.0), at(nan, 1.0, 0.0), at(1.0, nan, 0.0), at(2.0, 2.0, nan),
                                          at(2.0, 2.0, 0.0), at(2.0, 9.0, 0.0), at(1.5, 9.0, 0.0), at(4.0, 4.0, 0.0)};
  const PoseTrack track(odometry);
  EXPECT_EQ(track.records().size(), 3U);
  EXPECT_EQ(track.not_finite(), 3U);
  EXPECT_EQ(track.out_of_order(), 2U);
  EXPECT_NEAR(track.T_world_robot(3.0)->position.x, 3.0, 1e-12);
}

}  // namespace
}  // namespace echoarc
