// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/followed_direction.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

constexpr double wall_y_m = 1.0;

/// A drive along y = 0 past a wall at y = 1 on the left, whose way sways by so much; the sensors look at the wall.
Trial drive(double sway_m, WallSide side) {
  SceneScoring scoring;
  scoring.region = {{-1.0, -1.0}, {5.0, 2.0}};
  scoring.cell_m = 0.02;
  scoring.walls = {{.begin = {4.0, wall_y_m}, .end = {0.0, wall_y_m}, .depth_m = 1.0}};
  std::vector<Vec2> surface;
  for (int k = 0; k <= 400; ++k) surface.push_back({0.01 * k, wall_y_m});
  Reference reference{PointSet::make(std::move(surface)).value(), 0.01, "a wall"};
  Trial trial;
  trial.scorer = std::make_shared<const SceneScorer>(SceneScorer::make(std::move(reference), scoring).value());
  for (int k = 0; k <= 160; ++k) {
    Reading reading;
    reading.ping = static_cast<PingId>(k);
    reading.scan = static_cast<std::uint32_t>(k);
    reading.time_s = 0.1 * k;
    reading.T_world_robot.position = {0.025 * k, sway_m * std::sin(0.15 * k)};
    reading.T_world_tx = reading.T_world_rx = {reading.T_world_robot.position, degrees(90.0)};
    reading.outcome = Echo{wall_y_m - reading.T_world_robot.position.y};
    reading.wall = side;
    trial.readings.push_back(reading);
  }
  return trial;
}

TEST(FollowedDirection, StraightDriveIsTheIdeal) {
  const auto scores = score_directions(drive(0.0, WallSide::left));
  ASSERT_TRUE(scores && *scores);
  EXPECT_EQ((*scores)->followed.points, (*scores)->ideal.points);
  EXPECT_EQ((*scores)->followed.mae_m, (*scores)->ideal.mae_m);
  EXPECT_GT((*scores)->followed.points, 100U);
}

TEST(FollowedDirection, SwayingCostsTheFollowedDirectionAlone) {
  const auto straight = score_directions(drive(0.0, WallSide::left));
  const auto swaying = score_directions(drive(0.1, WallSide::left));
  ASSERT_TRUE(straight && *straight && swaying && *swaying);
  EXPECT_NE((*swaying)->followed.points, (*swaying)->ideal.points);
  EXPECT_GE((*swaying)->ideal.detection.overall_ratio(), (*swaying)->followed.detection.overall_ratio());
}

TEST(FollowedDirection, NothingWithoutAFollowedWall) {
  const auto scores = score_directions(drive(0.0, WallSide::unknown));
  ASSERT_TRUE(scores);
  EXPECT_FALSE(scores->has_value());
}

}  // namespace
}  // namespace echoarc::studies
