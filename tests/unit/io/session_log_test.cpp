// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/session_log.hpp"

#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::put;
using test::TempFolder;

Log robot_of(int sensors) {
  Log log;
  log.robot.name = "tester";
  log.robot.sensors = SensorArray::make(ring(sensors, 0.1, Angle{}, SensorModel{})).value();
  return log;
}

/// One of each kind, hard numbers among them.
std::vector<SessionLine> every_kind() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Ping heard{.time_s = 0.1, .tx = 1, .rx = 2, .range_m = 1.0 / 3.0, .time_of_flight_s = 5e-324};
  heard.echo_index = 2;
  heard.cause = EchoCause::wall;
  Ping silent{.time_s = 0.2, .tx = 0, .rx = 0, .range_m = inf};
  Ping failed{.time_s = 0.25, .tx = 0, .rx = 0, .range_m = std::numeric_limits<double>::quiet_NaN()};
  Scan scan{.time_s = 0.3, .laser = 4, .angle_min = radians(-1.5), .angle_step = radians(0.1)};
  scan.ranges_m = {1.0F, std::numeric_limits<float>::quiet_NaN(), 0.1F};
  return {Odometry{-0.0, {{1e300, -1e-300}, radians(0.1 + 0.2)}},
          TruthLine{{1.0, {{2.0, 3.0}, radians(-4.0)}}},
          heard,
          silent,
          failed,
          scan,
          Poll{.time_s = 0.4, .ranges_m = {0.5, inf, -inf}},
          WallNote{.time_s = 0.5, .side = WallSide::left},
          OtherLine{R"({"type":"command","t":1,"mode":"stop"})"}};
}

std::string text_of(const std::vector<SessionLine>& lines) {
  std::string text;
  for (const SessionLine& line : lines) EXPECT_TRUE(append_line(line, text));
  return text;
}

/// Pings that can be told apart.
std::string pings(int first, int count) {
  std::string text;
  for (int i = first; i < first + count; ++i)
    EXPECT_TRUE(append_line(Ping{.time_s = 0.01 * i, .tx = 0, .rx = 0, .range_m = 1.0 + i}, text));
  return text;
}

struct Heard {
  Result<Log> log;
  std::vector<SessionLine> lines;
};
Heard read(const fs::path& folder) {
  std::vector<SessionLine> lines;
  Result<Log> log = read_session(folder, [&](SessionLine line) { lines.push_back(std::move(line)); });
  return {std::move(log), std::move(lines)};
}

std::string all_parts(const fs::path& folder) {
  std::string text;
  for (const fs::path& part : session_parts(folder)) text += contents(part);
  return text;
}

TEST(SessionLog, EveryKindComesBackInOrder) {
  const TempFolder folder;
  const Log robot = robot_of(3);
  {
    SessionLog log = SessionLog::create(folder / "session", robot).value();
    log.write(text_of(every_kind()));
    log.sync();
    EXPECT_EQ(log.state(), SessionLog::State::on);
    EXPECT_EQ(log.bytes(), contents(folder / "session/session.jsonl").size());
  }
  const Heard heard = read(folder / "session");
  ASSERT_TRUE(heard.log) << heard.log.error().message;
  EXPECT_TRUE(heard.log->robot == robot.robot);
  EXPECT_TRUE(heard.log->pings.empty()) << "records are handed over, not kept";
  const std::vector<SessionLine> written = every_kind();
  ASSERT_EQ(heard.lines.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) EXPECT_EQ(heard.lines[i].index(), written[i].index()) << i;
  EXPECT_EQ(text_of(heard.lines), text_of(written));
  const auto& ping = std::get<Ping>(heard.lines[2]);
  EXPECT_EQ(ping.range_m, 1.0 / 3.0);
  EXPECT_EQ(ping.tx, 1U);
  EXPECT_EQ(ping.cause, EchoCause::wall);
  EXPECT_TRUE(std::isinf(std::get<Ping>(heard.lines[3]).range_m));
  EXPECT_TRUE(std::isnan(std::get<Ping>(heard.lines[4]).range_m));
  EXPECT_EQ(std::get<TruthLine>(heard.lines[1]).pose.T_world_robot.position, (Vec2{2.0, 3.0}));
}

TEST(SessionLog, OrderOfWritingIsKeptAgainstTimes) {
  const TempFolder folder;
  {
    SessionLog log = SessionLog::create(folder.path(), robot_of(1)).value();
    log.write(text_of({Odometry{5.0, {}}, Ping{.time_s = 1.0}, Odometry{0.5, {}}}));
  }
  const Heard heard = read(folder.path());
  ASSERT_EQ(heard.lines.size(), 3U);
  EXPECT_EQ(std::get<Odometry>(heard.lines[0]).time_s, 5.0);
  EXPECT_EQ(std::get<Odometry>(heard.lines[2]).time_s, 0.5);
}

TEST(SessionLog, WhatIsNotFiniteHasNoLine) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::string text = "before";
  for (const SessionLine& line :
       {SessionLine(Odometry{nan, {}}), SessionLine(TruthLine{{0.0, {{0.0, nan}, {}}}}),
        SessionLine(Ping{.time_s = nan}), SessionLine(Scan{.time_s = 0.0, .angle_min = radians(nan)}),
        SessionLine(WallNote{.time_s = nan})})
    EXPECT_FALSE(append_line(line, text)) << line.index();
  EXPECT_EQ(text, "before");
}

TEST(SessionLog, LineThatWasBeingWrittenIsCutOffWhenItGoesOn) {
  const TempFolder folder;
  const Log robot = robot_of(1);
  {
    SessionLog::create(folder / "whole", robot).value().write(pings(0, 20));
  }
  {
    SessionLog::create(folder / "killed", robot).value().write(pings(0, 10));
  }
  const std::string sound = contents(folder / "killed/session.jsonl");
  // Cut anywhere in the eleventh line, and much longer than what is looked through at once.
  for (const std::string& torn : {std::string("{"), pings(10, 1).substr(0, 20),
                                  pings(10, 1).substr(0, pings(10, 1).size() - 1), std::string(10'000, 'x')}) {
    put(folder / "killed/session.jsonl", sound + torn);
    {
      SessionLog log = SessionLog::resume(folder / "killed", robot).value();
      EXPECT_EQ(log.bytes(), sound.size());
      log.write(pings(10, 10));
    }
    EXPECT_EQ(contents(folder / "killed/session.jsonl"), contents(folder / "whole/session.jsonl"))
        << "byte for byte, as if nothing had happened";
  }
}

TEST(SessionLog, TornLastLineIsPassedOverByReading) {
  const TempFolder folder;
  {
    SessionLog::create(folder.path(), robot_of(1)).value().write(pings(0, 3));
  }
  put(folder / "session.jsonl", contents(folder / "session.jsonl") + R"({"type":"ping","t":0.0)");
  const Heard heard = read(folder.path());
  ASSERT_TRUE(heard.log) << heard.log.error().message;
  EXPECT_EQ(heard.lines.size(), 3U);
  EXPECT_EQ(heard.log->report.warnings.size(), 1U) << "but it is told";
}

TEST(SessionLog, PartsFollowEachOther) {
  const TempFolder folder;
  const Log robot = robot_of(1);
  const SessionLogLimits limits{.part_bytes = 700};
  {
    SessionLog log = SessionLog::create(folder.path(), robot, limits).value();
    for (int i = 0; i < 30; ++i) log.write(pings(i, 1));
    EXPECT_EQ(log.bytes(), all_parts(folder.path()).size());
  }
  const std::vector<fs::path> parts = session_parts(folder.path());
  ASSERT_GT(parts.size(), 3U);
  EXPECT_EQ(parts[0].filename(), "session.jsonl");
  EXPECT_EQ(parts[1].filename(), "session-2.jsonl");
  for (const fs::path& part : parts) {
    EXPECT_LE(fs::file_size(part), 700U);
    EXPECT_TRUE(contents(part).starts_with(R"({"type":"header")")) << "each is a log of its own";
    EXPECT_TRUE(contents(part).ends_with("}\n"));
  }
  const Heard heard = read(folder.path());
  ASSERT_TRUE(heard.log);
  EXPECT_EQ(text_of(heard.lines), pings(0, 30));
  // Going on in the middle of a part gives what would have been written at once.
  {
    SessionLog log = SessionLog::resume(folder.path(), robot, limits).value();
    for (int i = 30; i < 60; ++i) log.write(pings(i, 1));
    EXPECT_EQ(log.bytes(), all_parts(folder.path()).size());
  }
  const TempFolder once;
  {
    SessionLog log = SessionLog::create(once.path(), robot, limits).value();
    for (int i = 0; i < 60; ++i) log.write(pings(i, 1));
  }
  EXPECT_EQ(all_parts(folder.path()), all_parts(once.path()));
}

TEST(SessionLog, PartWithoutOrWithHalfAHeaderGetsOneWhenItGoesOn) {
  const Log robot = robot_of(1);
  for (const std::string_view begun : {"", R"({"type":"hea)"}) {
    const TempFolder folder;
    {
      SessionLog::create(folder.path(), robot).value().write(pings(0, 2));
    }
    put(folder / "session-2.jsonl", begun);
    {
      SessionLog::resume(folder.path(), robot).value().write(pings(2, 2));
    }
    const Heard heard = read(folder.path());
    ASSERT_TRUE(heard.log) << heard.log.error().message;
    EXPECT_EQ(text_of(heard.lines), pings(0, 4));
  }
}

TEST(SessionLog, GroupLargerThanAPartIsWrittenWhole) {
  const TempFolder folder;
  SessionLog log = SessionLog::create(folder.path(), robot_of(1), {.part_bytes = 1}).value();
  log.write(pings(0, 5));
  log.write(pings(5, 5));
  EXPECT_EQ(session_parts(folder.path()).size(), 2U);
  EXPECT_EQ(text_of(read(folder.path()).lines), pings(0, 10));
}

TEST(SessionLog, LimitEndsIt) {
  const TempFolder folder;
  const std::uint64_t limit = 1500;
  SessionLog log = SessionLog::create(folder.path(), robot_of(1), {.part_bytes = 600, .total_bytes = limit}).value();
  int written = 0;
  for (int i = 0; i < 100 && log.state() == SessionLog::State::on; ++i) {
    log.write(pings(i, 1));
    if (log.state() == SessionLog::State::on) ++written;
  }
  EXPECT_EQ(log.state(), SessionLog::State::limit);
  EXPECT_FALSE(log.message().empty());
  EXPECT_LE(all_parts(folder.path()).size(), limit);
  EXPECT_GT(all_parts(folder.path()).size(), limit - 400);
  const std::string before = all_parts(folder.path());
  log.write(pings(1, 1));
  EXPECT_EQ(all_parts(folder.path()), before) << "nothing is written after it";
  const Heard heard = read(folder.path());
  ASSERT_TRUE(heard.log) << heard.log.error().message;
  EXPECT_EQ(text_of(heard.lines), pings(0, written));
}

/// In a process of its own, whose files may not grow beyond `bytes`: how the log's state was when it took no more.
int state_on_a_full_disk(const fs::path& folder, rlim_t bytes) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(100);
    auto log = SessionLog::create(folder, robot_of(1));
    if (!log) _exit(101);
    for (int i = 0; i < 200; ++i) log->write(pings(3 * i, 3));
    _exit(log->message().empty() ? 102 : static_cast<int>(log->state()));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(SessionLog, FullDiskEndsItWithWholeGroups) {
  const TempFolder folder;
  // The write that does not fit ends in different places of a line.
  for (const rlim_t bytes : {4000U, 4013U, 4027U}) {
    const fs::path session = folder / std::to_string(bytes);
    ASSERT_EQ(state_on_a_full_disk(session, bytes), static_cast<int>(SessionLog::State::full));
    const Heard heard = read(session);
    ASSERT_TRUE(heard.log) << heard.log.error().message;
    EXPECT_TRUE(heard.log->report.warnings.empty()) << "no line is torn";
    EXPECT_GT(heard.lines.size(), 30U);
    EXPECT_EQ(heard.lines.size() % 3, 0U) << "all lines of a group or none";
    EXPECT_EQ(text_of(heard.lines), pings(0, static_cast<int>(heard.lines.size())));
    EXPECT_LE(fs::file_size(session / "session.jsonl"), bytes);
  }
}

TEST(SessionLog, FullDiskAtTheStartIsAnError) {
  const TempFolder folder;
  EXPECT_EQ(state_on_a_full_disk(folder / "session", 10), 101);
}

TEST(SessionLog, PartsOfDifferentRobotsAreNoSession) {
  const TempFolder folder;
  {
    SessionLog::create(folder / "a", robot_of(1)).value().write(pings(0, 2));
  }
  {
    SessionLog::create(folder / "b", robot_of(2)).value().write(pings(0, 2));
  }
  fs::copy_file(folder / "b/session.jsonl", folder / "a/session-2.jsonl");
  const Heard heard = read(folder / "a");
  ASSERT_FALSE(heard.log);
  EXPECT_EQ(heard.log.error().code, ErrorCode::bad_format);
  EXPECT_NE(heard.log.error().where.find("session-2.jsonl"), std::string::npos);
  EXPECT_FALSE(heard.log.error().remedy.empty());
}

TEST(SessionLog, NothingIsOverwrittenAndNothingInvented) {
  const TempFolder folder;
  const Log robot = robot_of(1);
  {
    SessionLog::create(folder / "a", robot).value().write(pings(0, 2));
  }
  const std::string before = contents(folder / "a/session.jsonl");
  const auto again = SessionLog::create(folder / "a", robot);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::unwritable);
  EXPECT_EQ(contents(folder / "a/session.jsonl"), before);
  EXPECT_EQ(SessionLog::resume(folder / "none", robot).error().code, ErrorCode::not_found);
  EXPECT_EQ(read(folder / "none").log.error().code, ErrorCode::not_found);
  put(folder / "file", "");
  EXPECT_FALSE(SessionLog::create(folder / "file", robot));
  EXPECT_TRUE(session_parts(folder / "none").empty());
}

TEST(SessionLog, HeaderNumberThatIsNotFiniteIsRefused) {
  const TempFolder folder;
  Log robot = robot_of(1);
  robot.temperature_k = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(SessionLog::create(folder / "a", robot));
  EXPECT_TRUE(session_parts(folder / "a").empty());
}

TEST(SessionLog, BadLinesAreCountedAndTooManyRefused) {
  const TempFolder folder;
  {
    SessionLog::create(folder.path(), robot_of(1)).value().write(pings(0, 300));
  }
  const std::string sound = contents(folder / "session.jsonl");
  put(folder / "session.jsonl", sound + "{\"type\":\"ping\"}\n" + pings(300, 1));
  const Heard heard = read(folder.path());
  ASSERT_TRUE(heard.log) << heard.log.error().message;
  EXPECT_EQ(heard.lines.size(), 301U);
  EXPECT_EQ(heard.log->report.bad_lines, 1U);
  std::string rubbish = sound;
  for (int i = 0; i < 100; ++i) rubbish += "rubbish\n";
  put(folder / "session.jsonl", rubbish);
  EXPECT_FALSE(read(folder.path()).log);
}

TEST(SessionLog, IsMovedWithItsFile) {
  const TempFolder folder;
  SessionLog log = SessionLog::create(folder / "a", robot_of(1)).value();
  log.write(pings(0, 1));
  SessionLog moved = std::move(log);
  moved.write(pings(1, 1));
  SessionLog other = SessionLog::create(folder / "b", robot_of(1)).value();
  other = std::move(moved);
  other.write(pings(2, 1));
  EXPECT_EQ(text_of(read(folder / "a").lines), pings(0, 3));
  EXPECT_TRUE(read(folder / "b").lines.empty());
}

}  // namespace
}  // namespace echoarc::io
