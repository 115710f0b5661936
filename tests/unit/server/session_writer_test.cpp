// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/session_writer.hpp"

#include <chrono>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"
#include "unit/server/room_fixture.hpp"

namespace echoarc::server::test {
namespace {

using echoarc::test::TempFolder;

Log header() {
  Log log;
  log.robot = live::plain_room().robot;
  return log;
}
std::string text_of(const io::SessionLine& line) {
  std::string text;
  EXPECT_TRUE(io::append_line(line, text));
  return text;
}
std::vector<io::SessionLine> lines_in(const std::filesystem::path& folder) {
  std::vector<io::SessionLine> lines;
  const auto read = io::read_session(folder, [&](io::SessionLine line) { lines.push_back(std::move(line)); });
  EXPECT_TRUE(read) << read.error().message;
  return lines;
}
std::vector<live::Record> every_kind() {
  return {Odometry{1.0, {{2.0, 3.0}, radians(0.5)}},
          live::Truth{{1.5, {{2.5, 3.5}, radians(0.25)}}},
          Ping{.time_s = 2.0, .tx = 1, .rx = 2, .range_m = 1.25},
          Scan{.time_s = 2.5, .angle_step = radians(0.5), .ranges_m = {1.0F, 2.0F}},
          Poll{.time_s = 3.0, .ranges_m = {0.5, 0.25}},
          WallNote{.time_s = 3.5, .side = WallSide::right}};
}

TEST(SessionWriter, KeepsEveryKindInOrder) {
  const TempFolder folder;
  {
    SessionWriter writer(io::SessionLog::create(folder.path(), header()).value());
    writer.add_setup(R"({"type":"setup","scene":"room"})");
    for (const live::Record& record : every_kind()) writer.add(record);
    writer.add(live::CommandNote{4.0, "drive", {0.25, radians(-0.5)}});
  }
  const std::vector<io::SessionLine> lines = lines_in(folder.path());
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(std::get<io::OtherLine>(lines[0]).json, R"({"type":"setup","scene":"room"})");
  EXPECT_FALSE(record_of(lines[0]));
  for (std::size_t i = 0; i < every_kind().size(); ++i) {
    const auto record = record_of(lines[i + 1]);
    ASSERT_TRUE(record) << i;
    EXPECT_EQ(record->index(), every_kind()[i].index()) << i;
    EXPECT_EQ(text_of(line_of(*record)), text_of(line_of(every_kind()[i])));
  }
  const Value command = Value::parse(std::get<io::OtherLine>(lines[7]).json);
  EXPECT_EQ(command, (Value{{"type", "command"}, {"t", 4.0}, {"mode", "drive"}, {"v", 0.25}, {"w", -0.5}}));
  EXPECT_FALSE(record_of(lines[7])) << "commands are not for maps";
}

TEST(SessionWriter, WhatIsNotFiniteIsLeftOut) {
  const TempFolder folder;
  {
    SessionWriter writer(io::SessionLog::create(folder.path(), header()).value());
    writer.add(Odometry{std::numeric_limits<double>::quiet_NaN(), {}});
    writer.add(Odometry{1.0, {}});
  }
  EXPECT_EQ(lines_in(folder.path()).size(), 1U);
}

TEST(SessionWriter, SaysWhenItsLimitIsReachedAndGoesOnWithoutWriting) {
  const TempFolder folder;
  io::SessionLog log = io::SessionLog::create(folder.path(), header(), {.total_bytes = 4000}).value();
  const std::uint64_t header_bytes = log.bytes();
  std::uint64_t bytes = 0;
  {
    SessionWriter writer(std::move(log));
    EXPECT_EQ(writer.status().state, io::SessionLog::State::on);
    EXPECT_EQ(writer.status().bytes, header_bytes);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (writer.status().state == io::SessionLog::State::on && std::chrono::steady_clock::now() < end) {
      for (const live::Record& record : every_kind()) writer.add(record);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const SessionWriter::Status status = writer.status();
    EXPECT_EQ(status.state, io::SessionLog::State::limit);
    EXPECT_NE(status.message.find("4000"), std::string::npos) << status.message;
    bytes = status.bytes;
    EXPECT_LE(bytes, 4000U);
    for (int i = 0; i < 1000; ++i) writer.add(Odometry{1.0, {}});
  }
  EXPECT_EQ(std::filesystem::file_size(folder / "session.jsonl"), bytes);
  EXPECT_EQ(lines_in(folder.path()).size() % every_kind().size(), 0U);
}

TEST(SessionWriter, WhatIsAddedIsOnDiskSoonAfter) {
  const TempFolder folder;
  SessionWriter writer(io::SessionLog::create(folder.path(), header()).value());
  writer.add(Odometry{1.0, {}});
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (lines_in(folder.path()).empty() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(lines_in(folder.path()).size(), 1U) << "while it is still open";
}

}  // namespace
}  // namespace echoarc::server::test
