// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/io/delimited.hpp"

/// The recorded corridor runs, which are not part of the project (CONTRIBUTING.md).
namespace echoarc::test {

inline std::filesystem::path corridor_folder(const std::string& run) {
  return std::filesystem::path(ECHOARC_SOURCE_DIR) / "../shared/data/corridor" / run;
}

struct CorridorDrive {
  Log log;
  std::vector<Vec2> path;         ///< of the robot, by odometry sample
  std::vector<Reading> readings;  ///< the echoes
};

inline void read_corridor(const std::string& run, CorridorDrive& drive) {
  const std::filesystem::path root = ECHOARC_SOURCE_DIR;
  const auto description = io::read_description(root / "descriptions/corridor.toml");
  ASSERT_TRUE(description) << description.error().message;
  Result<Log> log = io::read_delimited(*description, corridor_folder(run));
  ASSERT_TRUE(log) << log.error().message;
  drive.log = std::move(*log);
  PoseTrack track;
  for (const Odometry& sample : drive.log.odometry) {
    ASSERT_FALSE(track.push(sample));
    drive.path.push_back(sample.T_world_robot.position);
  }
  for (const Ping& ping : drive.log.pings) {
    if (!(ping.range_m < 5.1)) continue;  // 5.11: no echo
    Reading r;
    r.ping = drive.readings.size();
    r.time_s = ping.time_s;
    r.tx = r.rx = ping.rx;
    r.T_world_robot = std::get<Pose2>(track.at(ping.time_s));
    r.T_world_tx = r.T_world_rx = r.T_world_robot * drive.log.robot.sensors.find(ping.rx)->mount.T_robot_sensor();
    r.beam_width = degrees(20.0);
    r.outcome = Echo{ping.range_m};
    drive.readings.push_back(r);
  }
}

}  // namespace echoarc::test
