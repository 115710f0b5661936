// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/io/jsonl.hpp"
#include "log_text.hpp"

namespace echoarc::io {
namespace {

Result<Log> read_fixture(const std::string& name) {
  auto source = FileSource::open(std::string(ECHOARC_SOURCE_DIR "/tests/fixtures/logs/") + name);
  if (!source) return source.error();
  return read_jsonl(**source);
}

TEST(ReadJsonl, HeaderDescribesTheRobot) {
  const Result<Log> log = read_fixture("every_record.jsonl");
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->frame, "map");
  EXPECT_EQ(log->temperature_k, 288.5);
  EXPECT_EQ(log->robot.name, "two ears");
  EXPECT_EQ(log->robot.radius_m, 0.3);
  ASSERT_EQ(log->robot.sensors.size(), 2U);
  const Sensor* sensor = log->robot.sensors.find(4);
  ASSERT_NE(sensor, nullptr);
  EXPECT_EQ(sensor->mount, (Mount{0.2, -0.1, 0.6, radians(0.1), radians(-0.2), radians(1.5)}));
  EXPECT_EQ(sensor->model.beam_width, radians(0.4));
  EXPECT_EQ(sensor->model.range_min_m, 0.1);
  EXPECT_EQ(sensor->model.range_max_m, 6.5);
  EXPECT_EQ(sensor->model.trusted_range_m, 2.5);
  EXPECT_EQ(sensor->model.no_echo, (NoEchoRule{NoEchoRule::Kind::above, 6.4}));
  ASSERT_EQ(log->robot.lasers.size(), 1U);
  EXPECT_EQ(log->robot.lasers[0].mount.x_m, 0.125);
}

TEST(ReadJsonl, PingsKeepWhatTheHardwareSaid) {
  const Result<Log> log = read_fixture("every_record.jsonl");
  ASSERT_TRUE(log);
  ASSERT_EQ(log->pings.size(), 5U);
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(log->pings[0].range_m, 1.234);
  EXPECT_TRUE(std::isnan(log->pings[0].time_of_flight_s));
  EXPECT_EQ(log->pings[0].line, 5U);
  EXPECT_EQ(log->pings[1].range_m, inf);
  EXPECT_EQ(log->pings[1].tx, 1U);
  EXPECT_EQ(log->pings[1].rx, 4U);
  EXPECT_EQ(log->pings[1].time_of_flight_s, 0.0072);
  EXPECT_EQ(log->pings[1].echo_index, 2U);
  EXPECT_EQ(log->pings[2].range_m, -inf);
  EXPECT_TRUE(std::isnan(log->pings[3].range_m));
  EXPECT_EQ(log->pings[3].rx, 4U) << "a ping without rx is heard by its transmitter";
  EXPECT_EQ(log->pings[4].tx, 99U) << "an unknown sensor is for sensing to count";
  EXPECT_EQ(log->pings[4].range_m, -1.0);
}

TEST(ReadJsonl, CausesOfEchoes) {
  const Result<Log> log =
      read_text(std::string(one_sensor_header) + R"({"type":"ping","t":0,"tx":0,"rx":0,"range":1,"cause":"wall_edge"})"
                                                 "\n"
                                                 R"({"type":"ping","t":1,"tx":0,"rx":0,"range":1,"cause":"gravity"})"
                                                 "\n");
  ASSERT_TRUE(log);
  ASSERT_EQ(log->pings.size(), 2U);
  EXPECT_EQ(log->pings[0].cause, EchoCause::wall_edge);
  EXPECT_EQ(log->pings[1].cause, EchoCause::unknown) << "a word of a later version";
}

TEST(ReadJsonl, OtherRecords) {
  const Result<Log> log = read_fixture("every_record.jsonl");
  ASSERT_TRUE(log);
  ASSERT_EQ(log->odometry.size(), 3U);
  EXPECT_EQ(log->odometry[1].T_world_robot, (Pose2{{1.5, -0.25}, radians(0.1)}));
  EXPECT_EQ(log->odometry[2].time_s, 0.4) << "time running backwards stays in file order";
  EXPECT_EQ(log->odometry[2].line, 15U);
  ASSERT_EQ(log->truth.size(), 1U);
  EXPECT_EQ(log->truth[0].T_world_robot.heading, radians(0.003));
  ASSERT_EQ(log->walls.size(), 1U);
  EXPECT_EQ(log->walls[0].side, WallSide::left);
  ASSERT_EQ(log->polls.size(), 1U);
  ASSERT_EQ(log->polls[0].ranges_m.size(), 4U);
  EXPECT_EQ(log->polls[0].ranges_m[2], std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(log->polls[0].ranges_m[3]));
  ASSERT_EQ(log->scans.size(), 1U);
  EXPECT_EQ(log->scans[0].angle_min, radians(-1.57));
  ASSERT_EQ(log->scans[0].ranges_m.size(), 3U);
  EXPECT_TRUE(std::isnan(log->scans[0].ranges_m[1]));
  EXPECT_EQ(log->scans[0].ranges_m[2], 3.5F);
}

TEST(ReadJsonl, UnknownTypesAreKeptAndNamedOnce) {
  const std::string bumper = R"({"type":"bumper","pressed":[1,{"deep":true}]})";
  const Result<Log> log = read_text(std::string(one_sensor_header) + bumper + "\n" + bumper + "\n");
  ASSERT_TRUE(log);
  EXPECT_EQ(log->unknown_lines, (std::vector<std::string>{bumper, bumper}));
  ASSERT_EQ(log->report.warnings.size(), 1U);
  EXPECT_NE(log->report.warnings[0].find("log.jsonl:2: records of type \"bumper\""), std::string::npos);
  EXPECT_EQ(log->report.bad_lines, 0U);
  EXPECT_EQ(log->report.lines, 3U);
}

struct BadRecord {
  const char* line;
  const char* cause;
};
class BadRecords : public testing::TestWithParam<BadRecord> {};

TEST_P(BadRecords, AreCountedWithNumberAndCause) {
  const Result<Log> log = read_among_good(GetParam().line);
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->report.bad_lines, 1U);
  ASSERT_EQ(log->report.first_bad.size(), 1U);
  EXPECT_EQ(log->report.first_bad[0].line, 2U);
  EXPECT_NE(log->report.first_bad[0].message.find(GetParam().cause), std::string::npos)
      << log->report.first_bad[0].message;
  EXPECT_EQ(log->pings.size(), 199U);
  EXPECT_TRUE(log->odometry.empty() && log->scans.empty() && log->polls.empty() && log->walls.empty());
}

INSTANTIATE_TEST_SUITE_P(
    ReadJsonl, BadRecords,
    testing::Values(
        BadRecord{R"({"type":"odom","t":0,"x":NaN,"y":0,"yaw":0})", "x is not a finite number"},
        BadRecord{R"({"type":"odom","t":0,"x":null,"y":0,"yaw":0})", "x is not a finite number"},
        BadRecord{R"({"type":"odom","t":0,"x":1e400,"y":0,"yaw":0})", "x is not a finite number"},
        BadRecord{R"({"type":"odom","t":0,"x":0,"y":0})", "yaw of the pose is missing"},
        BadRecord{R"({"type":"ping","t":"now","tx":0,"rx":0,"range":1})", "t is not a finite number"},
        BadRecord{R"({"type":"ping","tx":0,"rx":0,"range":1})", "t of the ping is missing"},
        BadRecord{R"({"type":"ping","t":0,"rx":0,"range":1})", "tx of the ping is missing"},
        BadRecord{R"({"type":"ping","t":0,"tx":0,"rx":0})", "range of the ping is missing"},
        BadRecord{R"({"type":"ping","t":0,"tx":-1,"rx":0,"range":1})", "tx is not a whole number"},
        BadRecord{R"({"type":"ping","t":0,"tx":4294967296,"rx":0,"range":1})", "tx is not a whole number"},
        BadRecord{R"({"type":"ping","t":0,"tx":0,"rx":0,"range":"far"})", "\"no_echo\", \"too_close\", \"invalid\""},
        BadRecord{R"({"type":"ping","t":0,"tx":0,"rx":0,"range":Infinity})", "range is neither"},
        BadRecord{R"({"type":"ping","t":0,"tx":0,"rx":0,"range":1,"cause":3})", "cause is not a string"},
        BadRecord{R"({"type":"ping","t":0,"tx":0,"rx":0,"range":1.5)", "not a JSON object"},
        BadRecord{R"({"type":"scan","t":0,"angle_min":0,"angle_step":1,"ranges":[1e39]})", "too large"},
        BadRecord{R"({"type":"scan","t":0,"angle_min":0,"angle_step":1,"ranges":7})", "ranges is not a list"},
        BadRecord{R"({"type":"scan","t":0,"angle_min":0,"angle_step":1,"ranges":[nul]})", "a range is not"},
        BadRecord{R"({"type":"poll","t":0,"ranges":[nul]})", "a range is neither"},
        BadRecord{R"({"type":"scan","t":0,"ranges":[1]})", "angle_min"},
        BadRecord{R"({"type":"poll","t":0})", "ranges of the poll is missing"},
        BadRecord{R"({"type":"wall","t":0,"side":"up"})", "side is none of"},
        BadRecord{R"({"type":"header","format":"echoarc-log","version":1})", "a second header"},
        BadRecord{R"({"t":0})", "type is missing"}, BadRecord{R"([1,2])", "not a JSON object"},
        BadRecord{"\x01\x02\xff\xfe binary", "not JSON"}, BadRecord{"ping 0 0 1.5", "not a JSON object"}));

TEST(ReadJsonl, TrailingTextAfterARecordIsBad) {
  const Result<Log> log = read_among_good(R"({"type":"bumper"} {"type":"bumper"})");
  ASSERT_TRUE(log);
  EXPECT_EQ(log->report.bad_lines, 1U);
  EXPECT_TRUE(log->unknown_lines.empty());
}

TEST(ReadJsonl, TruncatedLastLineIsAWarning) {
  const Result<Log> log = read_text(std::string(one_sensor_header) + std::string(good_ping) +
                                    R"({"type":"ping","t":1.1,"tx":0,"rx":0,"ra)");
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->pings.size(), 1U);
  EXPECT_EQ(log->report.bad_lines, 0U);
  ASSERT_EQ(log->report.warnings.size(), 1U);
  EXPECT_NE(log->report.warnings[0].find("log.jsonl:3: the last line is cut off"), std::string::npos);
}

TEST(ReadJsonl, CompleteLastLineNeedsNoLineFeed) {
  std::string text = std::string(one_sensor_header) + std::string(good_ping);
  text.pop_back();
  const Result<Log> log = read_text(text);
  ASSERT_TRUE(log);
  EXPECT_EQ(log->pings.size(), 1U);
  EXPECT_TRUE(log->report.warnings.empty());
}

TEST(ReadJsonl, MoreThanOnePercentBadFails) {
  const auto read = [](int bad, int good) {
    std::string text(one_sensor_header);
    for (int i = 0; i < good; ++i) text += good_ping;
    for (int i = 0; i < bad; ++i) text += "{bad\n";
    return read_text(text);
  };
  EXPECT_TRUE(read(2, 197)) << "2 of 200 lines are 1 %";
  const Result<Log> log = read(3, 197);
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().code, ErrorCode::bad_format);
  EXPECT_EQ(log.error().where, "log.jsonl:199");
  EXPECT_NE(log.error().message.find("3 of 201 lines are bad, more than 1 %"), std::string::npos);
  EXPECT_FALSE(log.error().remedy.empty());
}

TEST(ReadJsonl, MoreThanAHundredBadLinesFailAtOnce) {
  std::string text(one_sensor_header);
  for (int i = 0; i < 100'000; ++i) text += good_ping;
  for (int i = 0; i < 101; ++i) text += "{bad\n";
  const Result<Log> log = read_text(text);
  ASSERT_FALSE(log);
  EXPECT_NE(log.error().message.find("more than 100"), std::string::npos) << log.error().message;
  EXPECT_EQ(log.error().where, "log.jsonl:100002");
}

TEST(ReadJsonl, LineOverTheLimitIsBadAndNotKept) {
  std::string text = std::string(one_sensor_header) + R"({"type":"bumper","x":")" + std::string(5000, 'x') + "\"}\n";
  for (int i = 0; i < 199; ++i) text += good_ping;
  const Result<Log> log = read_text(text, {.line_bytes = 1000});
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->report.bad_lines, 1U);
  EXPECT_EQ(log->report.first_bad[0].message, "the line is too long");
  EXPECT_EQ(log->pings.size(), 199U);
}

TEST(ReadJsonl, NewerMinorVersionIsReadNewerMajorRefused) {
  const auto header = [](const char* version) {
    return read_text(std::string(R"({"type":"header","format":"echoarc-log","version":)") + version + "}\n");
  };
  EXPECT_TRUE(header("1"));
  EXPECT_TRUE(header("1.7"));
  const Result<Log> newer = header("2");
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().code, ErrorCode::unsupported);
  EXPECT_EQ(newer.error().where, "log.jsonl:1");
  EXPECT_NE(newer.error().message.find("version 2"), std::string::npos);
  EXPECT_FALSE(header("0"));
  EXPECT_FALSE(header("\"1\""));
}

class BadHeaders : public testing::TestWithParam<BadRecord> {};

TEST_P(BadHeaders, FailWithPlaceAndRemedy) {
  const Result<Log> log = read_text(std::string(GetParam().line) + "\n" + std::string(good_ping));
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().code, ErrorCode::bad_format);
  EXPECT_EQ(log.error().where, "log.jsonl:1");
  EXPECT_NE(log.error().message.find(GetParam().cause), std::string::npos) << log.error().message;
  EXPECT_FALSE(log.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    ReadJsonl, BadHeaders,
    testing::Values(
        BadRecord{R"({"type":"ping","t":0,"tx":0,"rx":0,"range":1})", "not the header"},
        BadRecord{R"({"type":"header","format":"other","version":1})", "not the header"},
        BadRecord{R"({"type":"header","format":"echoarc-log","ver)", "not a JSON object"},
        BadRecord{"\x7f"
                  "ELF\x02\x01",
                  "not a JSON object"},
        BadRecord{R"({"type":"header","format":"echoarc-log"})", "version of the header is missing"},
        BadRecord{R"({"type":"header","format":"echoarc-log","version":1,"temperature_k":"warm"})", "temperature_k"},
        BadRecord{R"({"type":"header","format":"echoarc-log","version":1,"robot":7})", "robot is not an object"},
        BadRecord{R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":{}}})", "sensors of robot"},
        BadRecord{R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":[{"x":1}]}})",
                  "id of a sensor is missing"},
        BadRecord{R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":[{"id":3},{"id":3}]}})",
                  "3"},
        BadRecord{
            R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":[{"id":0,"beam_width":1e9}]}})",
            "beam"},
        BadRecord{
            R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":[{"id":0,"no_echo":"no"}]}})",
            "no_echo of a sensor"}));

TEST(ReadJsonl, EmptyFileIsSaidToBeEmpty) {
  for (const char* text : {"", "\n", "  \n\n"}) {
    const Result<Log> log = read_text(text);
    ASSERT_FALSE(log);
    EXPECT_EQ(log.error().message, "the file is empty");
    EXPECT_EQ(log.error().where, "log.jsonl");
  }
}

TEST(ReadJsonl, AMillionSensorsAreRefused) {
  std::string text = R"({"type":"header","format":"echoarc-log","version":1,"robot":{"sensors":[)";
  for (int i = 0; i < 1'000'000; ++i) text += i == 0 ? "{}" : ",{}";
  const Result<Log> log = read_text(text + "]}}\n");
  ASSERT_FALSE(log);
  EXPECT_NE(log.error().message.find("sensors of robot is not a list of at most"), std::string::npos);
}

}  // namespace
}  // namespace echoarc::io
