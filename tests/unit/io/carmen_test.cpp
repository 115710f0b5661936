// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/carmen.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/io/byte_source.hpp"

namespace echoarc::io {
namespace {

Result<Log> read(std::string_view text) {
  MemorySource source(text, "drive.clf");
  return read_carmen(source);
}

Result<Log> read_fixture() {
  auto source = FileSource::open(ECHOARC_SOURCE_DIR "/tests/fixtures/logs/drive.clf");
  return source ? read_carmen(**source) : Result<Log>(source.error());
}

TEST(Carmen, PosesAndTimes) {
  const Result<Log> log = read_fixture();
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->odometry.size(), 2U);
  EXPECT_EQ(log->odometry[0].time_s, 10.0) << "the message's own time stamp, not the logger's";
  EXPECT_EQ(log->odometry[0].T_world_robot, (Pose2{{1.0, 2.0}, radians(0.5)}));
  EXPECT_EQ(log->odometry[1].line, 8U);
  ASSERT_EQ(log->truth.size(), 1U);
  EXPECT_EQ(log->truth[0].T_world_robot, (Pose2{{1.1, 2.1}, radians(0.6)}));
  EXPECT_EQ(log->truth[0].time_s, 10.05);
}

TEST(Carmen, SonarDescribesItsSensors) {
  const Result<Log> log = read_fixture();
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->robot.sensors.size(), 2U);
  const Sensor& right = log->robot.sensors.sensors()[1];
  EXPECT_EQ(right.mount.T_robot_sensor(), (Pose2{{0.2, -0.1}, radians(-0.3)}));
  EXPECT_EQ(right.model.beam_width, radians(0.4363));
  ASSERT_EQ(log->pings.size(), 4U);
  EXPECT_EQ(log->pings[1].tx, 1U);
  EXPECT_EQ(log->pings[1].rx, 1U);
  EXPECT_EQ(log->pings[1].range_m, 5.0);
  EXPECT_EQ(log->pings[2].time_s, 10.4);
  EXPECT_EQ(log->pings[2].line, 9U);
}

TEST(Carmen, LaserWithItsMountAndSilentBeams) {
  const Result<Log> log = read_fixture();
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->scans.size(), 1U);
  const Scan& scan = log->scans[0];
  EXPECT_EQ(scan.time_s, 10.2);
  EXPECT_EQ(scan.angle_min, radians(-1.0));
  EXPECT_EQ(scan.angle_step, radians(0.5));
  ASSERT_EQ(scan.ranges_m.size(), 5U);
  EXPECT_EQ(scan.ranges_m[0], 1.0F);
  EXPECT_TRUE(std::isnan(scan.ranges_m[1])) << "the maximum range is no return";
  EXPECT_TRUE(std::isnan(scan.ranges_m[3]));
  ASSERT_EQ(log->robot.lasers.size(), 1U);
  EXPECT_NEAR(log->robot.lasers[0].mount.x_m, 0.2, 1e-12);
  EXPECT_EQ(log->robot.lasers[0].range_max_m, 8.0);
}

TEST(Carmen, OtherMessagesAreNamedInOneWarning) {
  const Result<Log> log = read_fixture();
  ASSERT_TRUE(log);
  ASSERT_EQ(log->report.warnings.size(), 1U);
  EXPECT_NE(log->report.warnings[0].find("messages passed over: PARAM, SYNC"), std::string::npos);
  EXPECT_EQ(log->report.bad_lines, 0U);
  EXPECT_EQ(log->report.lines, 8U);
}

std::string old_laser(const std::string& name, int readings, const char* poses) {
  std::string line = name + " " + std::to_string(readings);
  for (int i = 0; i < readings; ++i) line += " 1.5";
  return line + " " + poses + " 3.0 host 0.1\n";
}

TEST(Carmen, OldLasersGuessTheStepAndServeAsOdometry) {
  const Result<Log> log =
      read(old_laser("FLASER", 180, "1.3 2 0 1 2 0") + old_laser("FLASER", 361, "1.3 2 0 1 2 0") +
           old_laser("RLASER", 401, "0.7 2 3.14159265 1 2 0") + old_laser("FLASER", 91, "1.3 2 0 1 2 0"));
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->scans.size(), 4U);
  EXPECT_DOUBLE_EQ(log->scans[0].angle_min.deg(), -90.0);
  EXPECT_DOUBLE_EQ(log->scans[0].angle_step.deg(), 1.0);
  EXPECT_DOUBLE_EQ(log->scans[1].angle_step.deg(), 0.5);
  EXPECT_DOUBLE_EQ(log->scans[2].angle_step.deg(), 0.25);
  EXPECT_DOUBLE_EQ(log->scans[3].angle_step.deg(), 2.0);
  EXPECT_EQ(log->scans[2].laser, 1U);
  ASSERT_EQ(log->robot.lasers.size(), 2U);
  EXPECT_NEAR(log->robot.lasers[0].mount.x_m, 0.3, 1e-12);
  EXPECT_NEAR(log->robot.lasers[1].mount.x_m, -0.3, 1e-12);
  ASSERT_EQ(log->odometry.size(), 4U) << "without ODOM the laser's robot poses are the odometry";
  EXPECT_EQ(log->odometry[0].T_world_robot.position, (Vec2{1.0, 2.0}));
}

TEST(Carmen, ConeAngleInDegreesIsUnderstood) {
  const Result<Log> log = read("SONAR 15 1 2.5 0 0 0 1.0 host\n");
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_DOUBLE_EQ(log->robot.sensors.sensors()[0].model.beam_width.deg(), 15.0);
}

struct BadMessage {
  std::string_view line;
  const char* cause;
};
class BadMessages : public testing::TestWithParam<BadMessage> {};

TEST_P(BadMessages, FailWithLineAndCause) {
  const Result<Log> log = read("ODOM 0 0 0 0 0 0 1.0 host 0\n" + std::string(GetParam().line) + "\n");
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().where, "drive.clf:2");
  EXPECT_NE(log.error().message.find(GetParam().cause), std::string::npos) << log.error().message;
  EXPECT_FALSE(log.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Carmen, BadMessages,
    testing::Values(BadMessage{"ODOM nan 0 0 0 0 0 1.0 host 0", "ODOM needs"}, BadMessage{"ODOM 0 0", "ODOM needs"},
                    BadMessage{"TRUEPOS 0 0 0 0 0 0 inf host", "TRUEPOS needs"},
                    BadMessage{"FLASER 4000000000 1 2 3", "a laser message needs"},
                    BadMessage{"FLASER 3 1 2 3 0 0 0 0 0", "a laser message needs"},
                    BadMessage{"ROBOTLASER1 0 -1 2 0.5 8 0 0 2 1 1 9999999 0 0 0 0 0 0 0 0 0 0 0 1 h 1", "ROBOTLASER1"},
                    BadMessage{"FLASER 1 1 1.7e308 0 0 -1.7e308 0 0 1.0 h", "infinitely far"},
                    BadMessage{"SONAR 0.4 -1 1.0 host", "SONAR needs"},
                    BadMessage{"SONAR 0.4 2 1 1 0 0 0 0 0", "SONAR needs"},
                    BadMessage{"SONAR 1e9 1 2.5 0 0 0 1.0 host", "beam"},
                    BadMessage{"hello world", "not a CARMEN message"},
                    BadMessage{"\x01\xff\xfe", "not a CARMEN message"}));

TEST(Carmen, TruncatedLastLineIsAWarning) {
  const Result<Log> log = read("ODOM 0 0 0 0 0 0 1.0 host 0\nODOM 0 0 0 0");
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->odometry.size(), 1U);
  EXPECT_EQ(log->report.warnings.size(), 1U);
}

TEST(Carmen, FileWithoutMessages) {
  const Result<Log> log = read("# only a comment\n\n");
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().message, "the file holds no message");
}

}  // namespace
}  // namespace echoarc::io
