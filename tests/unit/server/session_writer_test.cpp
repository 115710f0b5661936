// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/session_writer.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::server {
namespace {

Log robot() {
  Log log;
  log.robot.name = "two ears";
  return log;
}

io::SessionLog created(const std::filesystem::path& folder, const io::SessionLogLimits& limits = {}) {
  Result<io::SessionLog> log = io::SessionLog::create(folder, robot(), limits);
  if (!log) throw std::runtime_error(log.error().message);
  return std::move(log).value();
}

std::vector<io::SessionLine> lines_of(const std::filesystem::path& folder) {
  std::vector<io::SessionLine> lines;
  const Result<Log> log = io::read_session(folder, [&](io::SessionLine line) { lines.push_back(std::move(line)); });
  EXPECT_TRUE(log) << log.error().message;
  return lines;
}

Odometry pose(double time_s) {
  return {.time_s = time_s, .T_world_robot = {{0.5 * time_s, 0.25}, radians(0.125)}};
}

TEST(SessionWriter, KeepsRecordsInTheirOrder) {
  const test::TempFolder temporary;
  const std::filesystem::path folder = temporary.path() / "session";
  {
    SessionWriter writer(created(folder));
    writer.add(pose(1.0));
    writer.add(live::Truth{pose(1.0)});
    writer.add(live::CommandNote{1.0, "drive", {0.25, radians(0.5)}});
    writer.add(Ping{.time_s = 1.5, .tx = 1, .rx = 1, .range_m = 2.25});
    writer.add_setup(R"({"type":"setup","method_add":"evidence"})");
  }
  const auto lines = lines_of(folder);
  ASSERT_EQ(lines.size(), 5U);
  const auto first = record_of(lines[0]);
  ASSERT_TRUE(first && std::holds_alternative<Odometry>(*first));
  EXPECT_EQ(std::get<Odometry>(*first).T_world_robot, pose(1.0).T_world_robot);
  const auto second = record_of(lines[1]);
  EXPECT_TRUE(second && std::holds_alternative<live::Truth>(*second));
  ASSERT_TRUE(std::holds_alternative<io::OtherLine>(lines[2]));
  EXPECT_NE(std::get<io::OtherLine>(lines[2]).json.find(R"("mode":"drive")"), std::string::npos);
  EXPECT_FALSE(record_of(lines[2])) << "commands map nothing";
  const auto fourth = record_of(lines[3]);
  ASSERT_TRUE(fourth && std::holds_alternative<Ping>(*fourth));
  EXPECT_EQ(std::get<Ping>(*fourth).range_m, 2.25);
  EXPECT_TRUE(std::holds_alternative<io::OtherLine>(lines[4]));
}

TEST(SessionWriter, IsOnTheDiskSoonWithoutBeingAsked) {
  const test::TempFolder temporary;
  const std::filesystem::path folder = temporary.path() / "session";
  SessionWriter writer(created(folder));
  writer.add(pose(1.0));
  for (int i = 0; i < 100 && lines_of(folder).empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(lines_of(folder).size(), 1U);
}

TEST(SessionWriter, GoesOnBehindALineThatWasCutShort) {
  const test::TempFolder temporary;
  const std::filesystem::path folder = temporary.path() / "session";
  {
    SessionWriter writer(created(folder));
    writer.add(pose(1.0));
    writer.add(pose(2.0));
  }
  std::ofstream(folder / "session.jsonl", std::ios::app) << R"({"type":"odometry","t":3.0,"x)";
  EXPECT_EQ(lines_of(folder).size(), 2U);
  {
    Result<io::SessionLog> again = io::SessionLog::resume(folder, robot());
    ASSERT_TRUE(again) << again.error().message;
    SessionWriter writer(std::move(again).value());
    writer.add(pose(4.0));
  }
  const auto lines = lines_of(folder);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(std::get<Odometry>(lines[2]).time_s, 4.0);
}

TEST(SessionWriter, LimitEndsTheLogAndIsSaid) {
  const test::TempFolder temporary;
  const std::filesystem::path folder = temporary.path() / "session";
  SessionWriter writer(created(folder, {.part_bytes = 2000, .total_bytes = 5000}));
  for (int i = 0; i < 400; ++i) {
    writer.add(pose(i));
    if (i % 20 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(60));
    if (writer.status().state != io::SessionLog::State::on) break;
  }
  const SessionWriter::Status status = writer.status();
  EXPECT_EQ(status.state, io::SessionLog::State::limit);
  EXPECT_FALSE(status.message.empty());
  EXPECT_LE(status.bytes, 5000U);
  EXPECT_GT(io::session_parts(folder).size(), 1U);
  const auto lines = lines_of(folder);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(std::get<Odometry>(lines[i]).time_s, static_cast<double>(i));
}

}  // namespace
}  // namespace echoarc::server
