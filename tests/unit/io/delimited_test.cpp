// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/delimited.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/io/byte_source.hpp"

namespace echoarc::io {
namespace {

using Files = std::map<std::string, std::string>;

/// Reads tables out of memory.
Result<Log> read(const std::string& toml, const Files& files) {
  const Result<DelimitedDescription> description = parse_description(toml, "log.toml");
  if (!description) return description.error();
  return read_delimited(*description, [&](const std::string& file) -> Result<std::unique_ptr<ByteSource>> {
    const auto found = files.find(file);
    if (found == files.end()) return Error{ErrorCode::not_found, "there is no such file", file, "add it"};
    return std::unique_ptr<ByteSource>(new MemorySource(found->second, file));
  });
}

constexpr const char* pose_and_range = R"(
[[table]]
file = "log.txt"
columns = [
  { column = 1, quantity = "time", unit = "ms" },
  { column = 2, quantity = "x", unit = "mm" },
  { column = 3, quantity = "y", unit = "cm" },
  { column = 4, quantity = "yaw", unit = "0.1deg", scale = -1 },
  { columns = [5, 6], quantity = "range", unit = "in", sensors = [7, 3], no_echo = [255, "none"] },
]
)";

TEST(Delimited, UnitsAndScales) {
  const Result<Log> log =
      read(pose_and_range, {{"log.txt", "# a comment\n1500 2000 -50 900 10 255\n\n2500 0 0 0 none 20\n"}});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->odometry.size(), 2U);
  EXPECT_DOUBLE_EQ(log->odometry[0].time_s, 1.5);
  EXPECT_DOUBLE_EQ(log->odometry[0].T_world_robot.position.x, 2.0);
  EXPECT_DOUBLE_EQ(log->odometry[0].T_world_robot.position.y, -0.5);
  EXPECT_DOUBLE_EQ(log->odometry[0].T_world_robot.heading.deg(), -90.0);
  EXPECT_EQ(log->odometry[0].line, 2U);
  ASSERT_EQ(log->pings.size(), 4U);
  EXPECT_DOUBLE_EQ(log->pings[0].range_m, 0.254);
  EXPECT_EQ(log->pings[0].tx, 7U);
  EXPECT_EQ(log->pings[0].rx, 7U);
  EXPECT_EQ(log->pings[1].tx, 3U);
  EXPECT_EQ(log->pings[1].range_m, std::numeric_limits<double>::infinity());
  EXPECT_EQ(log->pings[2].range_m, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(log->pings[3].time_s, 2.5);
  EXPECT_EQ(log->pings[3].line, 4U);
  EXPECT_EQ(log->report.lines, 2U);
}

TEST(Delimited, SpecialRangesAndEmptyCells) {
  const Result<Log> log = read(R"(
[[table]]
delimiter = "comma"
rate_hz = 4
columns = [ { columns = [1, 4], quantity = "range", sensors = [0, 1, 2, 3], no_echo = { above = 4.999 } } ]
)",
                               {{"", "inf,-inf,nan,\n4.999,4.998,\" 1.5\",0\n"}});
  ASSERT_TRUE(log) << log.error().message;
  constexpr double inf = std::numeric_limits<double>::infinity();
  ASSERT_EQ(log->pings.size(), 7U) << "an empty cell is no ping";
  EXPECT_EQ(log->pings[0].range_m, inf);
  EXPECT_EQ(log->pings[1].range_m, -inf);
  EXPECT_TRUE(std::isnan(log->pings[2].range_m));
  EXPECT_EQ(log->pings[3].range_m, inf);
  EXPECT_EQ(log->pings[4].range_m, 4.998);
  EXPECT_EQ(log->pings[5].range_m, 1.5);
  EXPECT_EQ(log->pings[6].range_m, 0.0) << "a value that no rule names stays for sensing";
  EXPECT_EQ(log->pings[0].time_s, 0.0);
  EXPECT_EQ(log->pings[6].time_s, 0.25);
}

TEST(Delimited, NamedColumnsAndSensorColumn) {
  const Result<Log> log = read(R"(
[[table]]
file = "a.csv"
delimiter = "semicolon"
header = true
skip_lines = 1
columns = [
  { column = "when", quantity = "time" },
  { column = "id", quantity = "sensor" },
  { column = "far", quantity = "range", unit = "cm" },
]
)",
                               {{"a.csv", "made by hand\nfar ; note ; when ; id\n150;x;0.5;12\n"}});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->pings.size(), 1U);
  EXPECT_EQ(log->pings[0].tx, 12U);
  EXPECT_DOUBLE_EQ(log->pings[0].range_m, 1.5);
  EXPECT_EQ(log->pings[0].time_s, 0.5);
}

TEST(Delimited, ScanWithNoReturn) {
  const Result<Log> log = read(R"(
[[table]]
columns = [
  { column = 1, quantity = "time" },
  { columns = [2, 4], quantity = "scan", unit = "mm", laser = 2, angle_min_deg = -90, angle_step_deg = 0.5, no_return = 81910 },
]
)",
                               {{"", "1 1000 81910 500\n"}});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->scans.size(), 1U);
  EXPECT_EQ(log->scans[0].laser, 2U);
  EXPECT_DOUBLE_EQ(log->scans[0].angle_min.deg(), -90.0);
  EXPECT_DOUBLE_EQ(log->scans[0].angle_step.deg(), 0.5);
  ASSERT_EQ(log->scans[0].ranges_m.size(), 3U);
  EXPECT_EQ(log->scans[0].ranges_m[0], 1.0F);
  EXPECT_TRUE(std::isnan(log->scans[0].ranges_m[1]));
  EXPECT_TRUE(log->odometry.empty());
}

constexpr const char* two_tables = R"(
[[table]]
file = "pose"
columns = [ { column = 1, quantity = "time" }, { column = 2, quantity = "x" }, { column = 3, quantity = "y" },
            { column = 4, quantity = "yaw" } ]
[[table]]
file = "sonar"
columns = [ { column = 1, quantity = "time" }, { column = 2, quantity = "range", sensors = [0] } ]
)";

TEST(Delimited, JoinByTimeKeepsEveryOwnTimeAndOrder) {
  const Result<Log> log = read(two_tables, {{"pose", "0 0 0 0\n1 1 0 0\n"}, {"sonar", "0.5 1\n0.4 2\n0.6 3\n7 4\n"}});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->pings.size(), 4U);
  EXPECT_EQ(log->odometry.size(), 2U);
  EXPECT_EQ(log->pings[1].time_s, 0.4) << "time running backwards is sensing's to count";
  EXPECT_EQ(log->pings[3].time_s, 7.0);
}

TEST(Delimited, JoinByRowTakesTheTimeOfTheFirstTable) {
  const std::string toml = std::string("join = \"row\"\n") + R"(
[[table]]
file = "pose"
columns = [ { column = 1, quantity = "time" }, { column = 2, quantity = "x" }, { column = 3, quantity = "y" },
            { column = 4, quantity = "yaw" } ]
[[table]]
file = "sonar"
columns = [ { column = 1, quantity = "range", sensors = [0] } ]
)";
  const Result<Log> log = read(toml, {{"pose", "5 0 0 0\n6 1 0 0\n"}, {"sonar", "# own comment\n1.5\n2.5\n3.5\n"}});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->pings.size(), 2U);
  EXPECT_EQ(log->pings[0].time_s, 5.0);
  EXPECT_EQ(log->pings[1].time_s, 6.0);
  EXPECT_EQ(log->pings[1].line, 3U);
  ASSERT_EQ(log->report.warnings.size(), 1U);
  EXPECT_NE(log->report.warnings[0].find("different numbers of rows"), std::string::npos);
}

TEST(Delimited, JoinedRowsThatDisagreeOnTheTimeAreBad) {
  const Result<Log> log =
      read(std::string("join = \"row\"\n") + two_tables, {{"pose", "0 0 0 0\n1 1 0 0\n"}, {"sonar", "0 1\n2 2\n"}});
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().where, "sonar:2");
  EXPECT_NE(log.error().message.find("2 s here, 1 s in line 2 of pose"), std::string::npos) << log.error().message;
}

TEST(Delimited, BadRowOfOneTableDoesNotShiftTheJoin) {
  std::string pose;
  std::string sonar;
  for (int i = 0; i < 200; ++i) {
    pose += i == 10 ? "junk\n" : std::to_string(i) + " 0 0 0\n";
    sonar += i == 20 ? std::to_string(i) + " far\n" : std::to_string(i) + " 1.5\n";
  }
  const Result<Log> log = read(std::string("join = \"row\"\n") + two_tables, {{"pose", pose}, {"sonar", sonar}});
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->odometry.size(), 199U);
  EXPECT_EQ(log->pings.size(), 198U) << "without row 11, whose pose is bad, and row 21";
  EXPECT_EQ(log->report.bad_lines, 2U);
  ASSERT_EQ(log->report.first_bad.size(), 2U);
  EXPECT_EQ(log->report.first_bad[0].message, "pose: the line has 1 cells, column 4 is needed");
  EXPECT_EQ(log->report.first_bad[1].message, "sonar: column 2: \"far\" is not a range");
  EXPECT_EQ(log->report.first_bad[1].line, 21U);
}

constexpr const char* wheels = R"(
[[table]]
delimiter = "comma"
rate_hz = 10
metres_per_tick = 0.005
%s
columns = [ { column = 1, quantity = "left_wheel", unit = "ticks" }, { column = 2, quantity = "right_wheel", unit = "ticks" } %s ]
)";

std::string wheel_description(const std::string& keys, const std::string& columns) {
  std::string toml = wheels;
  toml.replace(toml.find("%s"), 2, keys);
  toml.replace(toml.find("%s"), 2, columns);
  return toml;
}

TEST(Delimited, DeadReckoningWithCompass) {
  const std::string toml = wheel_description("", R"(, { column = 3, quantity = "yaw", unit = "deg", scale = -1 })");
  // 1 m ahead at heading 0, then a quarter turn to the left about the wheels' middle, then 0.5 m ahead.
  const Result<Log> log = read(toml, {{"", "0,0,0\n200,200,0\n0,0,-90\n100,100,-90\n"}});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->odometry.size(), 4U);
  const Pose2 end = log->odometry[3].T_world_robot;
  EXPECT_NEAR(end.position.x, 1.0, 1e-12);
  EXPECT_NEAR(end.position.y, 0.5, 1e-12);
  EXPECT_NEAR(end.heading.deg(), 90.0, 1e-12);
}

TEST(Delimited, DeadReckoningAcrossTheCompassSeam) {
  const std::string toml = wheel_description("", R"(, { column = 3, quantity = "yaw", unit = "deg" })");
  const Result<Log> log = read(toml, {{"", "0,0,179\n200,200,-179\n"}});
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_NEAR(log->odometry[1].T_world_robot.position.x, -1.0, 1e-12) << "the mean of 179 and -179 degrees is 180";
}

TEST(Delimited, DeadReckoningWithCountersAndTrack) {
  const std::string toml = wheel_description("track_m = 0.4\nwheel_counters = true", "");
  // A circle of radius 1 m to the left in 1000 steps: the wheels roll 2 pi 0.8 m and 2 pi 1.2 m.
  std::string rows = "1000,5000\n";
  for (int i = 1; i <= 1000; ++i) {
    const double part = i / 1000.0 * 2.0 * std::numbers::pi / 0.005;
    rows += std::to_string(1000 + 0.8 * part) + "," + std::to_string(5000 + 1.2 * part) + "\n";
    if (i == 500) {
      const Result<Log> half = read(toml, {{"", rows}});
      ASSERT_TRUE(half);
      EXPECT_NEAR(half->odometry.back().T_world_robot.position.y, 2.0, 1e-4);
    }
  }
  const Result<Log> log = read(toml, {{"", rows}});
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->odometry.front().T_world_robot.position, Vec2{});
  EXPECT_NEAR(norm(log->odometry.back().T_world_robot.position), 0.0, 1e-4);
  EXPECT_NEAR(log->odometry.back().T_world_robot.heading.deg(), 360.0, 1e-4);
}

TEST(Delimited, TruncatedLastLineIsAWarning) {
  const Result<Log> log = read(pose_and_range, {{"log.txt", "0 0 0 0 10 10\n1 0 0"}});
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->pings.size(), 2U);
  ASSERT_EQ(log->report.warnings.size(), 1U);
  EXPECT_NE(log->report.warnings[0].find("log.txt:2: the last line is cut off"), std::string::npos);
}

TEST(Delimited, HostileCellsFailWithPlaceAndRemedy) {
  for (const char* row : {"nan 0 0 0 1 1", "0 nan 0 0 1 1", "0 inf 0 0 1 1", "0 0 0 1e400 1 1", "0 0 0 0 x 1",
                          "\x01\x02\xff", "0 0", "1e308 0 0 0 1e400 1"}) {
    const Result<Log> log = read(pose_and_range, {{"log.txt", std::string(row) + "\n"}});
    ASSERT_FALSE(log) << row;
    EXPECT_EQ(log.error().where, "log.txt:1") << row;
    EXPECT_FALSE(log.error().remedy.empty());
  }
}

TEST(Delimited, ScaledRangeThatLeavesTheDoublesIsNotNoEcho) {
  const Result<Log> log = read(R"(
[[table]]
rate_hz = 1
columns = [ { column = 1, quantity = "range", unit = "km", sensors = [0] } ]
)",
                               {{"", "1e306\n"}});
  ASSERT_FALSE(log);
  EXPECT_NE(log.error().message.find("too large"), std::string::npos);
}

TEST(Delimited, EmptyFileAndMissingFile) {
  const Result<Log> empty = read(pose_and_range, {{"log.txt", "# nothing\n"}});
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().where, "log.txt");
  EXPECT_EQ(empty.error().message, "the file has no rows");
  const Result<Log> missing = read(pose_and_range, {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::not_found);
}

TEST(Delimited, HeaderWithoutTheNamedColumnSaysWhatThereIs) {
  const Result<Log> log = read(R"(
[[table]]
file = "a.csv"
delimiter = "comma"
header = true
rate_hz = 1
columns = [ { column = "front", quantity = "range", sensors = [0] } ]
)",
                               {{"a.csv", "# comment\nt,left,right\n1,2,3\n"}});
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().where, "a.csv:2");
  EXPECT_EQ(log.error().message, "the header line has no column \"front\"");
  EXPECT_EQ(log.error().remedy, "it has: t, left, right");
}

RC_GTEST_PROP(Delimited, PropertyAnyBytesGiveALogOrAnErrorWithAPlace, (const std::string& bytes)) {
  const Result<Log> log = read(pose_and_range, {{"log.txt", bytes}});
  if (!log) RC_ASSERT(!log.error().where.empty());
}

}  // namespace
}  // namespace echoarc::io
