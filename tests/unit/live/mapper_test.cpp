// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/mapper.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "echoarc/live/scores.hpp"
#include "echoarc/live/simulated_source.hpp"
#include "echoarc/pipeline/pipeline.hpp"
#include "unit/live/mapper_fixture.hpp"

namespace echoarc::live {
namespace {

const std::vector<MethodChoice> choices{
    {"evidence", {}}, {"atm_org", {}}, {"carve", {}}, {"numakura", {}}, {"consensus", {}}};

using test::demo_log_until;
using test::play;
using test::Played;

Mapper mapper_of(const Played& played, const std::vector<MethodChoice>& methods, Executor& executor) {
  auto mapper = Mapper::make(played.description, {}, methods, executor);
  return std::move(mapper).value();
}

/// Newest maps of all methods.
std::vector<MapExport> maps_of(Mapper& mapper) {
  (void)mapper.refresh();
  std::vector<MapExport> maps;
  for (const RunningMethod& method : mapper.methods()) maps.push_back(method.map ? *method.map : MapExport{});
  return maps;
}

bool all_same(const std::vector<MapExport>& a, const std::vector<MapExport>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), test::same_map);
}

TEST(Mapper, PushedRecordByRecordItEndsWithTheMapOfABatch) {
  const Log log = demo_log_until(40.0);
  const Played played = play(log);
  InlineExecutor executor;
  Mapper mapper = mapper_of(played, choices, executor);
  for (const Record& record : played.records) {
    mapper.push(record);
    if (std::holds_alternative<Ping>(record) && mapper.readings().size() % 100 == 0) (void)mapper.refresh();
  }
  mapper.end_of_records();
  for (const MethodChoice& choice : choices) {
    std::vector<AnyMethod> batch;
    batch.push_back(std::move(*make_method(choice.name)));
    (void)run_log(log, {}, batch, executor);
    const auto final_map = mapper.final_map(choice.name);
    ASSERT_TRUE(final_map);
    ASSERT_GT(final_map->points.size(), 10U) << choice.name;
    EXPECT_TRUE(test::same_map(*final_map, *batch[0].export_map())) << choice.name;
  }
}

TEST(Mapper, TheFinalMapLeavesTheLiveStateAsItIs) {
  const Played played = play(demo_log_until(12.0));
  InlineExecutor executor;
  Mapper asked = mapper_of(played, choices, executor);
  Mapper left_alone = mapper_of(played, choices, executor);
  for (std::size_t k = 0; k < played.records.size(); ++k) {
    asked.push(played.records[k]);
    left_alone.push(played.records[k]);
    if (k != played.records.size() / 2) continue;
    for (const MethodChoice& choice : choices) {
      ASSERT_TRUE(asked.final_map(choice.name));
    }
  }
  EXPECT_TRUE(all_same(maps_of(asked), maps_of(left_alone)));
}

TEST(Mapper, TheSameRecordsGiveTheSameMapsAtAnyMomentHoweverOftenItIsLookedAt) {
  const Played played = play(demo_log_until(12.0));
  InlineExecutor executor;
  Mapper watched = mapper_of(played, choices, executor);
  for (std::size_t k = 0; k < played.records.size(); ++k) {
    watched.push(played.records[k]);
    if (k % 7 == 0) (void)watched.refresh();
    if (k % 400 != 399) continue;
    Mapper resumed = mapper_of(played, choices, executor);
    for (std::size_t i = 0; i <= k; ++i) resumed.push(played.records[i]);
    ASSERT_TRUE(all_same(maps_of(watched), maps_of(resumed))) << k;
  }
}

TEST(Mapper, NewOptionsEndInTheMapOfAMapperThatHadThemFromTheStart) {
  const Played played = play(demo_log_until(12.0));
  InlineExecutor executor;
  const OptionMap wide{{"cell_m", 0.1}};
  Mapper changed = mapper_of(played, {{"evidence", {}}, {"consensus", {}}}, executor);
  Mapper fresh = mapper_of(played, {{"evidence", wide}, {"consensus", {}}}, executor);
  for (std::size_t k = 0; k < played.records.size(); ++k) {
    changed.push(played.records[k]);
    fresh.push(played.records[k]);
    if (k == played.records.size() / 2) {
      ASSERT_TRUE(changed.set_options("evidence", {{"cell_m", 0.2}}));
      ASSERT_TRUE(changed.work(10));
      EXPECT_EQ(changed.methods()[0].state, RunningMethod::State::recomputing);
      ASSERT_TRUE(changed.set_options("evidence", wide));  // cancels the one before
    }
    if (k % 5 == 0) (void)changed.work(20);
  }
  while (changed.work(50)) {
  }
  EXPECT_EQ(changed.methods()[0].state, RunningMethod::State::ok);
  EXPECT_TRUE(all_same(maps_of(changed), maps_of(fresh)));
  EXPECT_FALSE(changed.set_options("evidence", {{"cell_m", -1.0}}));
  EXPECT_FALSE(changed.set_options("evidence", {{"no_such_option", 1.0}}));
}

TEST(Mapper, ASensorThatIsTurnedOffLeavesNoTraceUntilItIsTurnedOnAgain) {
  const Played played = play(demo_log_until(12.0));
  InlineExecutor executor;
  Mapper all = mapper_of(played, choices, executor);
  Mapper off = mapper_of(played, choices, executor);
  for (const Record& record : played.records) {
    all.push(record);
    off.push(record);
  }
  const SensorId sensor = played.description.robot.sensors.sensors()[0].id;
  ASSERT_TRUE(off.use_sensor(sensor, false));
  while (off.work(100)) {
  }
  (void)off.refresh();
  const auto from_it = [&](const MapPoint& p) {
    return off.readings()[*off.readings().find(p.ping)].reading.rx == sensor;
  };
  for (const RunningMethod& method : off.methods()) {
    if (!method.point_method) continue;
    EXPECT_TRUE(std::ranges::none_of(method.map->points.points(), from_it)) << method.choice.name;
  }
  EXPECT_FALSE(all_same(maps_of(all), maps_of(off)));
  ASSERT_TRUE(off.use_sensor(sensor, true));
  while (off.work(100)) {
  }
  EXPECT_TRUE(all_same(maps_of(all), maps_of(off)));
  EXPECT_FALSE(off.use_sensor(4711, false));
}

TEST(Mapper, HostileRecordsAreJudgedAndCounted) {
  const Played played = play(demo_log_until(3.0));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  InlineExecutor executor;
  Mapper mapper = mapper_of(played, choices, executor);
  for (const Record& record : played.records) mapper.push(record);
  const SensorId sensor = played.description.robot.sensors.sensors()[0].id;
  mapper.push(Odometry{nan, {}});
  mapper.push(Odometry{0.5, {}});
  mapper.push(Odometry{4.0, {{nan, 0.0}, {}}});
  mapper.push(Ping{.time_s = nan, .tx = sensor, .rx = sensor, .range_m = 1.0});
  mapper.push(Ping{.time_s = 0.1, .tx = sensor, .rx = sensor, .range_m = 1.0});
  mapper.push(Ping{.time_s = 2.9, .tx = 999, .rx = 999, .range_m = 1.0});
  mapper.push(Ping{.time_s = 1e300, .tx = sensor, .rx = sensor, .range_m = nan});
  mapper.end_of_records();
  const SensingReport& report = mapper.report();
  EXPECT_EQ(report.waiting, 0U);
  EXPECT_EQ(mapper.readings().size(), report.pings);
  EXPECT_EQ(report.rejected_pings[Rejection::unknown_sensor].count, 1U);
  EXPECT_EQ(report.rejected_pings[Rejection::bad_time].count, 1U);
  std::uint64_t rejected = 0;
  std::uint64_t in_timeline = 0;
  for (std::size_t k = 0; k < mapper.readings().size(); ++k) {
    rejected += mapper.readings()[k].rejected ? 1 : 0;
    EXPECT_EQ(mapper.readings().find(mapper.readings()[k].reading.ping), k);
    EXPECT_TRUE(is_finite(mapper.readings()[k].reading.T_world_robot.position));
  }
  for (const TimelineBin& bin : mapper.timeline()) in_timeline += bin.echoes + bin.no_echoes + bin.rejected;
  EXPECT_EQ(rejected, report.rejected_pings.total());
  EXPECT_EQ(in_timeline, report.pings);
  EXPECT_LE(mapper.timeline().size(), 5U);
}

TEST(Mapper, AMapTooLargeForItsMemoryIsTheTroubleOfThatMethodAlone) {
  const Played played = play(demo_log_until(20.0));
  InlineExecutor executor;
  Mapper mapper = mapper_of(
      played, {{"evidence", {{"cell_m", 0.002}, {"max_memory_mib", std::int64_t{1}}}}, {"carve", {}}}, executor);
  for (const Record& record : played.records) mapper.push(record);
  (void)mapper.refresh();
  EXPECT_EQ(mapper.methods()[0].state, RunningMethod::State::failed);
  EXPECT_NE(mapper.methods()[0].reason.find("max_memory_mib"), std::string::npos);
  EXPECT_EQ(mapper.methods()[1].state, RunningMethod::State::ok);
}

TEST(Mapper, AfterARestartItIsAsNew) {
  const Played played = play(demo_log_until(6.0));
  InlineExecutor executor;
  Mapper mapper = mapper_of(played, choices, executor);
  for (const Record& record : played.records) mapper.push(record);
  const std::vector<MapExport> first = maps_of(mapper);
  mapper.restart();
  EXPECT_EQ(mapper.readings().size(), 0U);
  EXPECT_EQ(mapper.path().size(), 0U);
  for (const Record& record : played.records) mapper.push(record);
  EXPECT_TRUE(all_same(first, maps_of(mapper)));
}

TEST(Scores, AMapOnTheWallsScoresWellAndGrowsOnlyWithWhatWasFound) {
  const Played played = play(demo_log_until(20.0));
  // A log knows no walls; the scene that it was simulated in does.
  auto scene = io::read_scene_file(std::filesystem::path(ECHOARC_SOURCE_DIR) / "scenes/demo.toml");
  const auto source = SimulatedSource::make(scene.value().scene, 1);
  InlineExecutor executor;
  Mapper mapper = mapper_of(played, {{"centerline", {}}, {"consensus", {}}}, executor);
  ScoreKeeper scores((*source)->description());
  for (const Record& record : played.records) {
    mapper.push(record);
    scores.push(record);
    if (!scores.due()) continue;
    (void)mapper.refresh();
    (void)scores.update(mapper);
  }
  ASSERT_GE(scores.history().size(), 19U);
  ASSERT_LE(scores.history().size(), 22U);
  const Scores& last = scores.history().back();
  ASSERT_EQ(last.reason, "");
  for (const MethodScore& score : last.methods) {
    ASSERT_TRUE(score.mae_m && score.p95_m && score.found);
    EXPECT_GT(*score.mae_m, 0.0);
    EXPECT_LT(*score.mae_m, *score.p95_m);
    EXPECT_LE(*score.found, 1.0);
  }
  EXPECT_LT(*last.methods[1].mae_m, *last.methods[0].mae_m);
}

}  // namespace
}  // namespace echoarc::live
