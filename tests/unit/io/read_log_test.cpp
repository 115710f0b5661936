// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/read_log.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/jsonl.hpp"
#include "echoarc/io/plain_csv.hpp"
#include "echoarc/io/robot_toml.hpp"

namespace echoarc::io {
namespace {

const std::filesystem::path fixtures = std::filesystem::path(ECHOARC_SOURCE_DIR) / "tests/fixtures/logs";

/// A folder of its own for every test.
class ReadLog : public testing::Test {
 protected:
  ReadLog() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::path(testing::TempDir()) / ("echoarc_read_log_" + std::string(test->name()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~ReadLog() override { std::filesystem::remove_all(folder); }

  std::filesystem::path write(const std::string& name, std::string_view bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  }
  static RobotDescription robot() { return read_robot_toml(fixtures / "plain/robot.toml").value(); }
  /// The error of reading `path`, which must name a place and a remedy.
  static Error error_of(const std::filesystem::path& path, const ReadOptions& options = {}) {
    const Result<Log> log = read_log(path, options);
    EXPECT_FALSE(log);
    if (log) return {};
    EXPECT_TRUE(log.error().where.starts_with(path.string())) << log.error().where;
    EXPECT_FALSE(log.error().remedy.empty());
    return log.error();
  }

  std::filesystem::path folder;
};

TEST_F(ReadLog, JsonLinesByContentWhateverTheName) {
  const Result<Log> log = read_log(fixtures / "every_record.jsonl");
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->pings.size(), 5U);
  EXPECT_EQ(log->source, (fixtures / "every_record.jsonl").string());
  std::filesystem::copy_file(fixtures / "every_record.jsonl", folder / "drive.log");
  EXPECT_TRUE(read_log(folder / "drive.log"));
}

TEST_F(ReadLog, CarmenByContentWhateverTheName) {
  const Result<Log> log = read_log(fixtures / "drive.clf");
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->pings.size(), 4U);
  std::filesystem::copy_file(fixtures / "drive.clf", folder / "drive.txt");
  EXPECT_TRUE(read_log(folder / "drive.txt"));
}

TEST_F(ReadLog, DescribedFolderAndFileInIt) {
  const ReadOptions options{.description = fixtures / "described/log.toml"};
  for (const char* input : {"described", "described/pose.txt"}) {
    const Result<Log> log = read_log(fixtures / input, options);
    ASSERT_TRUE(log) << log.error().message;
    EXPECT_EQ(log->odometry.size(), 3U);
    ASSERT_EQ(log->pings.size(), 6U);
    EXPECT_EQ(log->pings[1].range_m, std::numeric_limits<double>::infinity());
    EXPECT_DOUBLE_EQ(log->pings[5].time_s, 0.3);
  }
}

TEST_F(ReadLog, GivenRobotReplacesTheOneOfTheLog) {
  const Result<Log> log = read_log(fixtures / "every_record.jsonl", {.robot = robot()});
  ASSERT_TRUE(log);
  EXPECT_EQ(log->robot.name, "two sonars");
}

TEST_F(ReadLog, PlainCsvWithOdometryBesideIt) {
  const Result<Log> log = read_log(fixtures / "plain/ranges.csv", {.robot = robot()});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->odometry.size(), 3U);
  EXPECT_DOUBLE_EQ(log->odometry[2].T_world_robot.heading.deg(), 2.0);
  ASSERT_EQ(log->pings.size(), 3U);
  EXPECT_EQ(log->pings[0].time_s, 0.05);
  EXPECT_DOUBLE_EQ(log->pings[0].range_m, 1.5);
  EXPECT_EQ(log->pings[1].tx, 1U);
  EXPECT_EQ(log->pings[1].range_m, std::numeric_limits<double>::infinity());
  EXPECT_EQ(log->pings[2].line, 5U);
  EXPECT_EQ(log->robot.sensors.size(), 2U);
}

TEST_F(ReadLog, PlainCsvOdometryIsFoundByItsNames) {
  const std::string odometry = "t,x,y,yaw\n0,0,0,0\n1,1,0,0\n";
  const auto ranges = write("run7.csv", "t,sensor_id,range_m\n0.5,0,1.5\n");
  for (const char* name : {"odom.csv", "odometry.csv", "run7.odom.csv"}) {
    write(name, odometry + (std::string(name) == "run7.odom.csv" ? "2,2,0,0\n" : ""));
    const Result<Log> log = read_log(ranges, {.robot = robot()});
    ASSERT_TRUE(log) << name << ": " << log.error().message;
    EXPECT_EQ(log->odometry.size(), std::string(name) == "run7.odom.csv" ? 3U : 2U) << "the log's own name comes first";
  }
  const auto elsewhere = write("poses.txt", "yaw t y x\n0 0 0 0\n");
  const Result<Log> log = read_log(ranges, {.robot = robot(), .odometry = elsewhere});
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_EQ(log->odometry.size(), 1U);
}

TEST_F(ReadLog, PlainCsvMayHoldThePosesItself) {
  const Result<Log> log = read_log(fixtures / "plain/posed.csv", {.robot = robot()});
  ASSERT_TRUE(log) << log.error().message;
  ASSERT_EQ(log->odometry.size(), 2U);
  EXPECT_DOUBLE_EQ(log->odometry[1].time_s, 0.06);
  EXPECT_EQ(log->odometry[1].T_world_robot.heading, radians(0.2));
}

TEST_F(ReadLog, PlainCsvNeedsARobotAndOdometry) {
  const auto ranges = write("run.csv", "t,sensor_id,range_m\n0.5,0,1.5\n");
  EXPECT_NE(error_of(ranges).remedy.find("--robot"), std::string::npos);
  const Error no_odometry = error_of(ranges, {.robot = robot()});
  EXPECT_EQ(no_odometry.code, ErrorCode::not_found);
  EXPECT_NE(no_odometry.remedy.find("run.odom.csv"), std::string::npos);
  EXPECT_NE(no_odometry.remedy.find("--odometry"), std::string::npos);
  write("odometry.csv", "a,b\n1,2\n");
  const Result<Log> bad = read_log(ranges, {.robot = robot()});
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().where, (folder / "odometry.csv").string());
  EXPECT_EQ(bad.error().message, "the header line does not name t, x, y and yaw");
}

TEST_F(ReadLog, MissingFile) {
  const Error error = error_of(folder / "absent.jsonl");
  EXPECT_EQ(error.code, ErrorCode::not_found);
  EXPECT_EQ(error_of(folder / "absent", {.description = fixtures / "described/log.toml"}).code, ErrorCode::not_found);
}

TEST_F(ReadLog, MissingDescription) {
  const Result<Log> log = read_log(fixtures / "described", {.description = folder / "absent.toml"});
  ASSERT_FALSE(log);
  EXPECT_EQ(log.error().where, (folder / "absent.toml").string());
}

TEST_F(ReadLog, FolderWithoutDescription) {
  EXPECT_NE(error_of(folder).remedy.find("--describe"), std::string::npos);
}

TEST_F(ReadLog, FolderThatLacksADescribedFile) {
  const Error error = error_of(folder, {.description = fixtures / "described/log.toml"});
  EXPECT_EQ(error.code, ErrorCode::not_found);
  EXPECT_EQ(error.where, (folder / "pose.txt").string());
  EXPECT_NE(error.remedy.find("log.toml"), std::string::npos);
}

TEST_F(ReadLog, EmptyFile) {
  for (const char* name : {"empty.jsonl", "empty.clf", "empty.csv", "empty"})
    EXPECT_EQ(error_of(write(name, "")).message, "the file is empty");
}

TEST_F(ReadLog, BinaryJunk) {
  std::string junk;
  for (int i = 0; i < 5000; ++i) junk += static_cast<char>((i * 193 + 7) % 251);
  for (const char* name : {"junk.jsonl", "junk.clf", "junk.csv", "junk"}) {
    const Error error = error_of(write(name, junk));
    EXPECT_EQ(error.code, ErrorCode::bad_format);
    EXPECT_NE(error.message.find("not text"), std::string::npos);
  }
  EXPECT_NE(error_of(write("log.gz", "\x1f\x8b\x08 packed")).remedy.find("gunzip"), std::string::npos);
  EXPECT_EQ(error_of(write("a.bag", "#ROSBAG V2.0\n")).code, ErrorCode::unsupported);
}

TEST_F(ReadLog, UnknownTextSaysWhatWasTried) {
  const Error error = error_of(write("notes.txt", "dear diary\n1 2 3\n"));
  EXPECT_EQ(error.code, ErrorCode::unsupported);
  for (const char* tried : {"JSON Lines", "CARMEN", "CSV"}) EXPECT_NE(error.message.find(tried), std::string::npos);
  EXPECT_NE(error.remedy.find("--describe"), std::string::npos);
}

TEST_F(ReadLog, ExtensionDecidesWhatContentCannot) {
  EXPECT_EQ(error_of(write("broken.jsonl", "not json\n")).message.find("the first line is not the header"), 0U);
  EXPECT_NE(error_of(write("broken.clf", "hello\n")).message.find("not a CARMEN message"), std::string::npos);
}

TEST_F(ReadLog, EndlessInputStopsAtTheLimit) {
  std::string text = R"({"type":"header","format":"echoarc-log","version":1})"
                     "\n";
  for (int i = 0; i < 10'000; ++i) text += "{\"type\":\"ping\",\"t\":1,\"tx\":0,\"rx\":0,\"range\":1}\n";
  const Error error = error_of(write("long.jsonl", text), {.limits = {.input_bytes = 100'000}});
  EXPECT_EQ(error.code, ErrorCode::too_large);
}

TEST_F(ReadLog, WrittenFileReadsBack) {
  const Result<Log> log = read_log(fixtures / "drive.clf");
  ASSERT_TRUE(log);
  auto sink = FileSink::create(folder / "drive.jsonl");
  ASSERT_TRUE(sink);
  ASSERT_TRUE(write_jsonl(*log, **sink));
  EXPECT_FALSE(std::filesystem::exists(folder / "drive.jsonl")) << "nothing under the final name before commit";
  ASSERT_TRUE((*sink)->commit());
  EXPECT_FALSE(std::filesystem::exists(folder / "drive.jsonl.part"));
  const Result<Log> back = read_log(folder / "drive.jsonl");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->pings.size(), log->pings.size());
  EXPECT_EQ(back->robot, log->robot);
}

TEST_F(ReadLog, AbandonedSinkLeavesNothing) {
  {
    auto sink = FileSink::create(folder / "half.jsonl");
    ASSERT_TRUE(sink);
    ASSERT_TRUE((*sink)->write("half a log"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  const auto nowhere = FileSink::create(folder / "no/such/folder/log.jsonl");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::unwritable);
}

TEST(PlainCsv, HeaderNamesAreRecognised) {
  for (const char* header :
       {"t,sensor_id,range_m", "range_cm;sensor;timestamp_ms", "id distance time", "T, Sensor_ID, Range"})
    EXPECT_TRUE(is_plain_csv_header(header)) << header;
  for (const char* header : {"t,x,y,yaw", "t,range_m", "t,sensor_id,range_kg", "", "1,2,3", "SONAR 0.4 1"})
    EXPECT_FALSE(is_plain_csv_header(header)) << header;
}

}  // namespace
}  // namespace echoarc::io
