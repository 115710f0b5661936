// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/io/delimited.hpp"

namespace echoarc::io {
namespace {

const std::filesystem::path root = ECHOARC_SOURCE_DIR;

/// A recorded log beside the checkout, read by a description the project ships; nothing where it is absent.
std::optional<Log> real_log(const char* description, const char* path) {
  const std::filesystem::path input = root / "../shared/data" / path;
  if (!std::filesystem::exists(input)) return std::nullopt;
  const auto read_of_description = read_description(root / "descriptions" / description);
  EXPECT_TRUE(read_of_description) << read_of_description.error().message;
  const Result<Log> log = read_delimited(*read_of_description, input);
  EXPECT_TRUE(log) << log.error().where << ": " << log.error().message;
  return *log;
}
constexpr const char* absent = "the recorded logs (../shared/data) are not here";

double path_length_m(const Log& log) {
  double length = 0.0;
  for (std::size_t i = 1; i < log.odometry.size(); ++i)
    length += norm(log.odometry[i].T_world_robot.position - log.odometry[i - 1].T_world_robot.position);
  return length;
}
double echo_share(const Log& log) {
  const auto echoes = std::ranges::count_if(log.pings, [](const Ping& ping) { return std::isfinite(ping.range_m); });
  return static_cast<double>(echoes) / static_cast<double>(log.pings.size());
}
double duration_s(const Log& log) {
  return log.odometry.back().time_s - log.odometry.front().time_s;
}

struct Run {
  const char* folder;
  std::size_t rows;
  double seconds;
  double path_m;
  double echo_share;
};
class Corridor : public testing::TestWithParam<Run> {};

TEST_P(Corridor, HasTheRowsTimesAndPathOfItsReadme) {
  const auto log = real_log("corridor.toml", GetParam().folder);
  if (!log) GTEST_SKIP() << absent;
  EXPECT_EQ(log->odometry.size(), GetParam().rows);
  EXPECT_EQ(log->pings.size(), 8 * GetParam().rows);
  EXPECT_EQ(log->scans.size(), GetParam().rows);
  EXPECT_EQ(log->report.bad_lines, 0U);
  EXPECT_EQ(log->report.lines, 3 * GetParam().rows);
  EXPECT_NEAR(duration_s(*log), GetParam().seconds, 0.05);
  EXPECT_NEAR(path_length_m(*log), GetParam().path_m, 0.05);
  EXPECT_NEAR(echo_share(*log), GetParam().echo_share, 0.005);
  EXPECT_TRUE(std::ranges::all_of(log->scans, [](const Scan& scan) { return scan.ranges_m.size() == 361; }));
}

INSTANTIATE_TEST_SUITE_P(RealLogs, Corridor,
                         testing::Values(Run{"corridor/run1", 413, 92.8, 25.0, 0.68},
                                         Run{"corridor/run2", 214, 47.2, 9.1, 0.67},
                                         Run{"corridor/run3", 366, 88.4, 10.9, 0.87}));

TEST(RealLogs, CorridorFirstRow) {
  const auto log = real_log("corridor.toml", "corridor/run1");
  if (!log) GTEST_SKIP() << absent;
  EXPECT_EQ(log->odometry[0].T_world_robot, Pose2{});
  EXPECT_DOUBLE_EQ(log->odometry[0].time_s, 1686.487);
  EXPECT_EQ(log->pings[0].range_m, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(log->pings[2].range_m, 2.32);
  EXPECT_EQ(log->pings[2].tx, 2U);
  EXPECT_FLOAT_EQ(log->scans[0].ranges_m[0], 12.24F);
}

TEST(RealLogs, GardenDriveComesBackToItsStart) {
  const auto log = real_log("garden.toml", "garden/drive.csv");
  if (!log) GTEST_SKIP() << absent;
  EXPECT_EQ(log->odometry.size(), 1666U);
  EXPECT_EQ(log->pings.size(), 4 * 1666U);
  EXPECT_EQ(log->report.bad_lines, 0U);
  // The drive is a loop: ticks, scale and the sign of the compass are right if dead reckoning closes it.
  EXPECT_GT(path_length_m(*log), 50.0);
  EXPECT_LT(norm(log->odometry.back().T_world_robot.position), 1.5);
}

TEST(RealLogs, ScitosHasRangesAndNoPoses) {
  const auto log = real_log("scitos.toml", "scitos/sensor_readings_24.data");
  if (!log) GTEST_SKIP() << absent;
  EXPECT_EQ(log->pings.size(), 24 * 5456U);
  EXPECT_TRUE(log->odometry.empty());
  EXPECT_EQ(log->report.bad_lines, 0U);
  EXPECT_EQ(log->pings[0].tx, 0U);
  EXPECT_DOUBLE_EQ(log->pings[0].range_m, 0.438);
  EXPECT_EQ(log->pings[1].tx, 23U) << "S2 is 15 degrees to the right of S1";
  EXPECT_EQ(log->pings[4].range_m, std::numeric_limits<double>::infinity()) << "5.000 is no echo";
}

}  // namespace
}  // namespace echoarc::io
