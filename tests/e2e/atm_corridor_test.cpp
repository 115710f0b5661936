// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The modified arc-transversal median on recorded drives: half beam 10 degrees, echoes below 3 m, 13 degrees, all arcs,
// against the log's own laser.

#include <filesystem>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/eval/wall_distance.hpp"
#include "echoarc/io/delimited.hpp"
#include "echoarc/mapping/atm.hpp"

namespace echoarc {
namespace {

struct Drive {
  const char* folder;
  double accuracy_10cm;
  double coverage;
};

class CorridorAtm : public testing::TestWithParam<Drive> {};

std::vector<Reading> readings_below(const Log& log, const PoseTrack& track, double range_max_m) {
  std::vector<Reading> readings;
  for (const Ping& ping : log.pings) {
    if (!(ping.range_m < range_max_m)) continue;
    Reading r;
    r.ping = readings.size();
    r.time_s = ping.time_s;
    r.tx = r.rx = ping.rx;
    r.T_world_robot = std::get<Pose2>(track.at(ping.time_s));
    r.T_world_tx = r.T_world_rx = r.T_world_robot * log.robot.sensors.find(ping.rx)->mount.T_robot_sensor();
    r.beam_width = degrees(20.0);
    r.outcome = Echo{ping.range_m};
    readings.push_back(r);
  }
  return readings;
}

TEST_P(CorridorAtm, ScoresAgainstTheLaser) {
  const std::filesystem::path root = ECHOARC_SOURCE_DIR;
  const std::filesystem::path input = root / "../shared/data/corridor" / GetParam().folder;
  if (!std::filesystem::exists(input)) GTEST_SKIP() << "the recorded logs (../shared/data) are not here";
  const auto description = io::read_description(root / "descriptions/corridor.toml");
  ASSERT_TRUE(description) << description.error().message;
  const Result<Log> log = io::read_delimited(*description, input);
  ASSERT_TRUE(log) << log.error().message;
  PoseTrack track;
  std::vector<Vec2> path;
  for (const Odometry& sample : log->odometry) {
    ASSERT_FALSE(track.push(sample));
    path.push_back(sample.T_world_robot.position);
  }

  AtmMod method;
  InlineExecutor executor;
  method.insert(readings_below(*log, track, 3.0), executor);
  method.finish(executor);
  std::vector<Vec2> points;
  for (const MapPoint& point : method.map().points()) points.push_back(point.position);

  const Result<Reference> laser = laser_reference(*log);
  ASSERT_TRUE(laser) << laser.error().message;
  const WallDistance score = wall_distance(*PointSet::make(points), *laser, *PointSet::make(path)).all;
  EXPECT_EQ(method.medians().pairs_left_out(), 0U);
  EXPECT_NEAR(score.accuracy[1], GetParam().accuracy_10cm, 0.001);
  EXPECT_NEAR(score.coverage, GetParam().coverage, 0.001);
}

INSTANTIATE_TEST_SUITE_P(RecordedDrives, CorridorAtm,
                         testing::Values(Drive{"run1", 0.981, 0.440}, Drive{"run3", 0.827, 0.498}),
                         [](const auto& drive) { return std::string(drive.param.folder); });

}  // namespace
}  // namespace echoarc
