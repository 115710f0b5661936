// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Two-way wall distance on recorded drives: the centre points of all echoes below 3 m against the log's own laser, with
// the figures an independent program found.

#include <filesystem>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/eval/wall_distance.hpp"
#include "echoarc/io/delimited.hpp"

namespace echoarc {
namespace {

struct Drive {
  const char* folder;
  std::size_t points;
  double accuracy_10cm;
  double coverage;
};

class CorridorScores : public testing::TestWithParam<Drive> {};

std::vector<Vec2> path_of(const PoseTrack& track) {
  std::vector<Vec2> path;
  for (const Odometry& sample : track.samples()) path.push_back(sample.T_world_robot.position);
  return path;
}

/// Where the echo was if it came from straight ahead of the sensor.
std::vector<Vec2> centre_points(const Log& log, const PoseTrack& track, double range_max_m) {
  std::vector<Vec2> points;
  for (const Ping& ping : log.pings) {
    if (!(ping.range_m < range_max_m)) continue;
    const Pose2 T_world_robot = std::get<Pose2>(track.at(ping.time_s));
    const Pose2 T_world_sensor = T_world_robot * log.robot.sensors.find(ping.rx)->mount.T_robot_sensor();
    points.push_back(T_world_sensor * Vec2{ping.range_m, 0.0});
  }
  return points;
}

TEST_P(CorridorScores, OfCentrePointsAreTheKnownOnes) {
  const std::filesystem::path root = ECHOARC_SOURCE_DIR;
  const std::filesystem::path input = root / "../shared/data/corridor" / GetParam().folder;
  if (!std::filesystem::exists(input)) GTEST_SKIP() << "the recorded logs (../shared/data) are not here";
  const auto description = io::read_description(root / "descriptions/corridor.toml");
  ASSERT_TRUE(description) << description.error().message;
  const Result<Log> log = io::read_delimited(*description, input);
  ASSERT_TRUE(log) << log.error().message;
  PoseTrack track;
  for (const Odometry& sample : log->odometry) ASSERT_FALSE(track.push(sample));

  const Result<Reference> laser = laser_reference(*log);
  ASSERT_TRUE(laser) << laser.error().message;
  const Result<PointSet> map = PointSet::make(centre_points(*log, track, 3.0));
  ASSERT_TRUE(map) << map.error().message;
  const WallDistance score = wall_distance(*map, *laser, *PointSet::make(path_of(track))).all;
  EXPECT_EQ(score.points, GetParam().points);
  EXPECT_NEAR(score.accuracy[1], GetParam().accuracy_10cm, 0.001);
  EXPECT_NEAR(score.coverage, GetParam().coverage, 0.001);
}

INSTANTIATE_TEST_SUITE_P(RecordedDrives, CorridorScores,
                         testing::Values(Drive{"run1", 1616, 0.718, 0.708}, Drive{"run2", 892, 0.772, 0.476},
                                         Drive{"run3", 2076, 0.741, 0.639}),
                         [](const auto& drive) { return std::string(drive.param.folder); });

}  // namespace
}  // namespace echoarc
