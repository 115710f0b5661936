// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/sensing.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

Log one_sensor_log(const SensorModel& model = test::model_of(0.2, 4.0)) {
  Log log;
  log.robot.sensors = SensorArray::make({{3, {.x_m = 0.1, .y_m = 0.05, .yaw = degrees(90)}, model}}).value();
  for (int k = 0; k <= 10; ++k) log.odometry.push_back(test::odometry_at(0.5 * k, 1.0 * k));
  return log;
}

TEST(Sensing, FillsEveryFieldOfAReading) {
  Log log = one_sensor_log();
  log.walls = {{.time_s = 0.6, .side = WallSide::left}, {.time_s = 1.3, .side = WallSide::right}};
  log.pings = {test::ping_at(0.25, 3, 1.5), test::ping_at(0.6, 3, 2.5), test::ping_at(1.25, 3, test::inf)};
  const std::vector<Reading> readings = sense(log).readings;
  ASSERT_EQ(readings.size(), 3U);
  const Reading& first = readings[0];
  EXPECT_EQ(first.ping, 0U);
  EXPECT_EQ(first.time_s, 0.25);
  EXPECT_EQ(first.tx, 3U);
  EXPECT_TRUE(first.monostatic());
  EXPECT_NEAR(first.T_world_robot.position.x, 0.5, 1e-12);
  EXPECT_NEAR(first.T_world_tx.position.x, 0.6, 1e-12);
  EXPECT_NEAR(first.T_world_tx.position.y, 0.05, 1e-12);
  EXPECT_NEAR(first.T_world_tx.heading.deg(), 90.0, 1e-12);
  EXPECT_EQ(first.T_world_rx, first.T_world_tx);
  EXPECT_EQ(first.outcome, Outcome{Echo{1.5}});
  EXPECT_EQ(first.beam_width, degrees(25));
  EXPECT_EQ(first.range_min_m, 0.2);
  EXPECT_EQ(first.range_max_m, 4.0);
  EXPECT_EQ(first.trusted_range_m, 2.0);
  EXPECT_EQ(first.wall, WallSide::unknown);
  EXPECT_EQ(readings[1].wall, WallSide::left) << "a note counts from its own time on";
  EXPECT_EQ(readings[2].wall, WallSide::left);
  EXPECT_EQ(readings[2].outcome, Outcome{NoEcho{}});
  EXPECT_EQ(readings[2].scan, 2U);
}

TEST(Sensing, BistaticPingsHaveTwoPosesAndALeastPath) {
  Log log;
  log.robot.sensors = SensorArray::make(row(2, 0.6, 0.0, test::model_of(0.2, 4.0))).value();
  log.odometry = {test::odometry_at(0.0), test::odometry_at(1.0)};
  Ping ping = test::ping_at(0.5, 1, 1.0);
  ping.tx = 0;
  log.pings = {ping, ping};
  log.pings[1].range_m = 0.3;  // a path of 0.6 m between sensors 0.6 m apart
  const SensedLog sensed = sense(log);
  ASSERT_EQ(sensed.readings.size(), 1U);
  EXPECT_FALSE(sensed.readings[0].monostatic());
  EXPECT_NEAR(sensed.readings[0].T_world_tx.position.y, -0.3, 1e-12);
  EXPECT_NEAR(sensed.readings[0].T_world_rx.position.y, 0.3, 1e-12);
  EXPECT_EQ(sensed.report.rejected_pings[Rejection::path_too_short].count, 1U);
}

TEST(Sensing, TemperatureRescalesRangesOrUsesTheFlightTime) {
  Log log = one_sensor_log();
  log.temperature_k = 293.0;
  log.pings = {test::ping_at(1.0, 3, 2.0), test::ping_at(1.5, 3, 2.0), test::ping_at(2.0, 3, 4.0)};
  log.pings[1].time_of_flight_s = 10e-3;
  const std::vector<Reading> readings = sense(log, {.air_temperature_k = 273.0}).readings;
  EXPECT_NEAR(*echo_range_m(readings[0].outcome), 2.0 * 331.4 / 343.3247, 1e-6);
  EXPECT_NEAR(*echo_range_m(readings[1].outcome), 331.4 * 10e-3 / 2, 1e-12);
  EXPECT_TRUE(is_no_echo(readings[2].outcome)) << "codes are numbers of the hardware, whatever the air";
  EXPECT_NEAR(*echo_range_m(sense(log).readings[1].outcome), 2.0, 0.0) << "by default as recorded";
}

TEST(Sensing, BelowTheMinimumIsRejectedOrTooClose) {
  Log log = one_sensor_log();
  log.pings = {test::ping_at(1.0, 3, 0.1), test::ping_at(1.5, 3, -test::inf)};
  const SensedLog rejected = sense(log);
  EXPECT_EQ(rejected.report.rejected_pings[Rejection::below_min_range].count, 1U);
  EXPECT_EQ(rejected.report.too_close, 1U) << "-Inf says it in so many words";
  const SensedLog kept = sense(log, {.below_minimum = BelowMinimum::too_close});
  ASSERT_EQ(kept.readings.size(), 2U);
  EXPECT_EQ(kept.readings[0].outcome, Outcome{TooClose{}});
}

TEST(Sensing, TrustedRangeNeverExceedsTheMaximum) {
  Log log = one_sensor_log();
  log.pings = {test::ping_at(1.0, 3, test::inf)};
  EXPECT_EQ(sense(log, {.trusted_range_m = 1.25}).readings[0].trusted_range_m, 1.25);
  EXPECT_EQ(sense(log, {.trusted_range_m = 100.0}).readings[0].trusted_range_m, 4.0);
}

TEST(Sensing, EveryReasonIsReachable) {
  Log log;
  log.robot.sensors = SensorArray::make(row(2, 0.6, 0.0, test::model_of(0.2, 4.0, {NoEchoRule::Kind::inf, 0}))).value();
  log.odometry = {test::odometry_at(0.0), test::odometry_at(1.0), test::odometry_at(5.0),
                  test::odometry_at(6.0, test::nan)};
  log.pings = {test::ping_at(0.5, 0, 1.0),  test::ping_at(0.4, 0, 1.0),       test::ping_at(0.5, 0, 1.0),
               test::ping_at(3.0, 0, 1.0),  test::ping_at(9.0, 0, 1.0),       test::ping_at(test::nan, 0, 1.0),
               test::ping_at(0.6, 7, 1.0),  test::ping_at(0.7, 0, test::nan), test::ping_at(0.8, 0, 0.1),
               test::ping_at(0.9, 0, 5.0),  test::ping_at(0.95, 0, 50.0),     test::ping_at(0.96, 1, 0.3),
               test::ping_at(0.97, 1, 1.0), test::ping_at(0.98, 0, 3.9),      test::ping_at(0.99, 0, 1.0)};
  log.pings[11].tx = 0;
  log.pings[12].echo_index = 1;
  const SensingReport report = sense(log, {.range_cut_m = 3.81, .jump_filter_m = 0.5}).report;
  EXPECT_EQ(report.accepted(), 1U);
  EXPECT_EQ(report.rejected_odometry[Rejection::bad_pose].count, 1U);
  for (const RejectionInfo& row : rejections()) {
    const bool elsewhere = row.reason == Rejection::bad_pose || row.reason == Rejection::stamp_uncertain;  // of polls
    const std::uint64_t expected = elsewhere ? 0 : 1;
    EXPECT_EQ(report.rejected_pings[row.reason].count, expected) << row.name;
  }
  EXPECT_EQ(report.accepted() + report.rejected_pings.total(), log.pings.size());
}

TEST(Sensing, PerSensorTalliesAddUp) {
  Log log = test::drive(0.0, test::model_of(0.2, 4.0));
  log.pings[5].range_m = 1e300;
  log.pings[6].range_m = test::nan;
  const SensingReport report = sense(log).report;
  std::uint64_t accepted = 0;
  std::uint64_t rejected = 0;
  for (const SensorTally& tally : report.sensors) {
    accepted += tally.accepted();
    for (const std::uint64_t count : tally.rejected) rejected += count;
  }
  EXPECT_EQ(accepted, report.accepted());
  EXPECT_EQ(rejected, report.rejected_pings.total());
  EXPECT_EQ(report.sensors[5 % 4].rejected[std::size_t(Rejection::implausible_range)], 1U);
}

bool same(const Reading& a, const Reading& b) {
  return a.ping == b.ping && a.time_s == b.time_s && a.scan == b.scan && a.tx == b.tx && a.rx == b.rx &&
         a.T_world_robot == b.T_world_robot && a.T_world_tx == b.T_world_tx && a.T_world_rx == b.T_world_rx &&
         a.outcome == b.outcome && a.wall == b.wall;
}

/// A log with everything that goes wrong now and then.
Log troubled_log(std::uint64_t seed) {
  Rng rng(seed);
  Log log = test::drive(0.0, test::model_of(0.2, 4.0), 3, 40);
  for (int k = 0; k < 4; ++k)
    log.walls.push_back({.time_s = 2.0 * k, .side = k % 2 ? WallSide::left : WallSide::right});
  std::erase_if(log.odometry, [&](const Odometry&) { return rng.below(10) == 0; });
  for (Odometry& sample : log.odometry)
    if (rng.below(20) == 0) sample.T_world_robot.position.x = test::nan;
  for (Ping& ping : log.pings) {
    const std::uint64_t fate = rng.below(40);
    if (fate == 0) ping.time_s = test::nan;
    if (fate == 1) ping.time_s -= rng.uniform(0.0, 3.0);
    if (fate == 2) ping.time_s += rng.uniform(0.0, 3.0);
    if (fate == 3) ping.rx = 99;
    if (fate == 4) ping.range_m = test::nan;
    if (fate == 5) ping.echo_index = 1;
  }
  return log;
}

RC_GTEST_PROP(Sensing, StreamedEqualsOffline, (std::uint64_t seed)) {
  const Log log = troubled_log(seed);
  const SensedLog offline = sense(log);
  RC_ASSERT(offline.report.accepted() + offline.report.rejected_pings.total() == log.pings.size());

  Sensing stream(log.robot.sensors, {}, decide_no_echo(log.robot.sensors, log.pings), log.temperature_k);
  for (const WallNote& note : log.walls) stream.push(note);
  std::size_t next_odometry = 0;
  std::vector<Reading> readings;
  Rng rng(seed + 1);
  for (std::size_t i = 0; i < log.pings.size(); ++i) {
    const double due_s = 0.25 * double(i) / 3 + rng.uniform(-0.5, 0.5);  // records arrive early or late
    while (next_odometry < log.odometry.size() && log.odometry[next_odometry].time_s < due_s)
      stream.push(log.odometry[next_odometry++]);
    stream.push(log.pings[i]);
    const SensingReport& report = stream.report();
    RC_ASSERT(report.accepted() + report.rejected_pings.total() + report.waiting == i + 1);
    readings.insert(readings.end(), stream.readings().begin(), stream.readings().end());
    stream.clear_readings();
  }
  while (next_odometry < log.odometry.size()) stream.push(log.odometry[next_odometry++]);
  stream.end_of_odometry();
  readings.insert(readings.end(), stream.readings().begin(), stream.readings().end());

  RC_ASSERT(std::ranges::equal(readings, offline.readings, same));
  RC_ASSERT(stream.report().rejected_pings == offline.report.rejected_pings);
  RC_ASSERT(stream.report().rejected_odometry == offline.report.rejected_odometry);
  RC_ASSERT(stream.report().sensors == offline.report.sensors);
  RC_ASSERT(stream.report().waiting == 0U);
}

TEST(Sensing, APingWaitsForTheOdometryAroundIt) {
  const Log log = one_sensor_log();
  Sensing stream(log.robot.sensors);
  stream.push(test::odometry_at(0.0));
  stream.push(test::ping_at(0.5, 3, 1.0));
  EXPECT_TRUE(stream.readings().empty());
  EXPECT_EQ(stream.report().waiting, 1U);
  stream.push(test::odometry_at(1.0, 2.0));
  ASSERT_EQ(stream.readings().size(), 1U);
  EXPECT_NEAR(stream.readings()[0].T_world_robot.position.x, 1.0, 1e-12);
  EXPECT_EQ(stream.report().waiting, 0U);
}

TEST(Sensing, ALivePingFromTheFutureDoesNotBlockTheRest) {
  const Log log = one_sensor_log();
  Sensing stream(log.robot.sensors);
  stream.push(test::odometry_at(0.0));
  stream.push(test::ping_at(1e6, 3, 1.0));
  stream.push(test::ping_at(0.0, 3, 1.0));
  EXPECT_EQ(stream.readings().size(), 1U);
  EXPECT_EQ(stream.report().rejected_pings[Rejection::no_pose].count, 1U);
}

TEST(Sensing, AWatcherIsShownEveryRejectedPingBetweenTheReadingsAroundIt) {
  const Log log = one_sensor_log();
  Sensing stream(log.robot.sensors);
  struct Shown {
    PingId id;
    Rejection reason;
    std::size_t readings_before;
  };
  std::vector<Shown> shown;
  stream.watch_rejections([&](const Ping& /*ping*/, PingId id, Rejection reason) {
    shown.push_back({id, reason, stream.readings().size()});
  });
  for (const Ping& ping : {test::ping_at(0.1, 3, 1.0), test::ping_at(0.2, 9, 1.0), test::ping_at(0.3, 3, 1.1),
                           test::ping_at(0.2, 3, 1.0), test::ping_at(0.4, 3, test::nan)})
    stream.push(ping);
  EXPECT_TRUE(shown.empty());  // nothing is decided before odometry comes
  for (const Odometry& sample : log.odometry) stream.push(sample);
  ASSERT_EQ(shown.size(), stream.report().rejected_pings.total());
  ASSERT_GE(shown.size(), 2U);
  EXPECT_EQ(shown[0].id, 1U);
  EXPECT_EQ(shown[0].reason, Rejection::unknown_sensor);
  EXPECT_EQ(shown[0].readings_before, 1U);
  EXPECT_EQ(shown[1].id, 3U);
  EXPECT_EQ(shown[1].reason, Rejection::time_backwards);
  EXPECT_EQ(shown[1].readings_before, 2U);
  stream.watch_rejections({});
  stream.push(test::ping_at(0.45, 9, 1.0));
  EXPECT_EQ(shown.size() + 1, stream.report().rejected_pings.total());
}

TEST(Sensing, OptionsAreDeclaredInFull) {
  for (const OptionSpec& spec : option_specs<SensingOptions>()) EXPECT_FALSE(spec.doc.empty()) << spec.name;
  EXPECT_TRUE(validate(SensingOptions{}));
  EXPECT_FALSE(validate(SensingOptions{.air_temperature_k = -1.0}));
}

}  // namespace
}  // namespace echoarc
