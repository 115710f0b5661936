// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/replay_source.hpp"
#include "echoarc/sensing/no_echo.hpp"
#include "echoarc/sim/simulate.hpp"
#include "robot_fixture.hpp"

namespace echoarc::live {
namespace {

struct Time {
  double operator()(const Truth& truth) const { return truth.pose.time_s; }
  template <class Of>
  double operator()(const Of& record) const {
    return record.time_s;
  }
};

Log drive_of(double begin_s) {
  sim::Scene scene = plain_room();
  scene.drive.legs = {{.to = Vec2{2.0, 2.0}}};
  Log log = sim::simulate(scene, 1).value().log;
  for (Odometry& record : log.odometry) record.time_s += begin_s;
  for (Odometry& record : log.truth) record.time_s += begin_s;
  for (Ping& record : log.pings) record.time_s += begin_s;
  return log;
}

TEST(Replay, SaysEverythingInTheOrderOfTime) {
  const Log log = drive_of(1000.0);
  const auto source = ReplaySource::make(log).value();
  EXPECT_EQ(source->time_s(), 1000.0);
  EXPECT_EQ(source->description().begin_s, 1000.0);
  EXPECT_TRUE(source->description().has_truth);
  EXPECT_EQ(source->drivable(), nullptr);
  std::vector<Record> records;
  for (double until_s = 1000.0; !source->ended(); until_s += 0.0173) ASSERT_TRUE(source->advance(until_s, records));
  EXPECT_EQ(records.size(), log.odometry.size() + log.truth.size() + log.pings.size());
  EXPECT_TRUE(std::ranges::is_sorted(records, {}, [](const Record& record) { return std::visit(Time{}, record); }));
  EXPECT_EQ(source->time_s(), *source->description().end_s);
  const auto decided = decide_no_echo(log.robot.sensors, log.pings);
  ASSERT_EQ(source->description().no_echo.size(), decided.size());
  for (std::size_t k = 0; k < decided.size(); ++k)
    EXPECT_EQ(source->description().no_echo[k].sentence, decided[k].sentence);
}

TEST(Replay, IsHeardAgainFromAnyMoment) {
  const auto source = ReplaySource::make(drive_of(0.0)).value();
  std::vector<Record> whole;
  ASSERT_TRUE(source->advance(1e6, whole));
  EXPECT_TRUE(source->ended());
  const double from_s = 1.0;
  source->seekable()->seek(from_s);
  EXPECT_FALSE(source->ended());
  EXPECT_EQ(source->time_s(), from_s);
  std::vector<Record> rest;
  ASSERT_TRUE(source->advance(1e6, rest));
  ASSERT_FALSE(rest.empty());
  EXPECT_GT(std::visit(Time{}, rest.front()), from_s);
  const auto later = [&](const Record& record) { return std::visit(Time{}, record) > from_s; };
  EXPECT_EQ(rest.size(), static_cast<std::size_t>(std::ranges::count_if(whole, later)));
  source->seek(-5.0);
  rest.clear();
  ASSERT_TRUE(source->advance(1e6, rest));
  EXPECT_EQ(rest.size(), whole.size());
}

TEST(Replay, RefusesALogWithoutRecords) {
  EXPECT_FALSE(ReplaySource::make(Log{}));
}

}  // namespace
}  // namespace echoarc::live
