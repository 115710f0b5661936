// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "echoarc/sensing/sensing.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

using test::nan;

/// One sensor that reports these ranges, 0.1 s apart, to a robot that stands still.
SensedLog sensed(const std::vector<double>& ranges_m, const SensingOptions& options, const SensorModel& model) {
  Log log;
  log.robot.sensors = SensorArray::make(ring(2, 0.2, Angle{}, model)).value();
  log.odometry = {test::odometry_at(0.0), test::odometry_at(100.0)};
  for (std::size_t k = 0; k < ranges_m.size(); ++k) log.pings.push_back(test::ping_at(0.1 * double(k), 0, ranges_m[k]));
  SensingOptions with_gap = options;
  with_gap.max_pose_gap_s = 1000.0;
  return sense(log, with_gap);
}

std::vector<double> ranges_of(const SensedLog& sensed) {
  std::vector<double> ranges;
  for (const Reading& reading : sensed.readings) ranges.push_back(echo_range_m(reading.outcome).value_or(test::inf));
  return ranges;
}

const SensorModel model = test::model_of(0.1, 8.0, {.kind = NoEchoRule::Kind::inf});

TEST(JumpFilter, DropsEveryLeapOfV43Once) {
  const std::vector<double> said{1.00, 1.02, 2.50, 2.52, 1.03, 1.01};
  const SensedLog log = sensed(said, {.jump_filter_m = 0.5}, model);
  EXPECT_EQ(ranges_of(log), (std::vector<double>{1.00, 1.02, 2.52, 1.01}));
  EXPECT_EQ(log.report.rejected_pings[Rejection::range_jump].count, 2U);
  EXPECT_EQ(log.report.rejected_pings[Rejection::range_jump].first_value, 2.50);
  EXPECT_EQ(ranges_of(sensed(said, {}, model)), said) << "off by default";
}

TEST(JumpFilter, SilenceAfterAnEchoIsALeap) {
  const SensedLog log = sensed({1.0, test::inf, test::inf, 1.0, 1.0}, {.jump_filter_m = 0.5}, model);
  EXPECT_EQ(ranges_of(log), (std::vector<double>{1.0, test::inf, 1.0}));
  EXPECT_EQ(log.report.rejected_pings[Rejection::range_jump].count, 2U);
}

TEST(JumpFilter, FailedMeasurementsAreNotComparedWith) {
  const SensedLog log = sensed({1.0, nan, 1.1}, {.jump_filter_m = 0.5}, model);
  EXPECT_EQ(ranges_of(log), (std::vector<double>{1.0, 1.1}));
}

TEST(JumpFilter, SensorsHaveTheirOwnPast) {
  JumpFilter filter;
  Reading reading;
  reading.outcome = Echo{1.0};
  EXPECT_FALSE(filter.jumps(reading, 0.5));
  reading.outcome = Echo{3.0};
  reading.rx = 1;
  EXPECT_FALSE(filter.jumps(reading, 0.5));
  reading.rx = 0;
  EXPECT_TRUE(filter.jumps(reading, 0.5));
}

TEST(RangeCut, KeepsTheCutItself) {
  const SensedLog log = sensed({3.80, 3.81, 3.8101, 5.0, test::inf}, {.range_cut_m = 3.81}, model);
  EXPECT_EQ(ranges_of(log), (std::vector<double>{3.80, 3.81, test::inf})) << "silence has no range to cut";
  EXPECT_EQ(log.report.rejected_pings[Rejection::range_cut].count, 2U);
  EXPECT_EQ(log.report.pings, log.report.accepted() + log.report.rejected_pings.total());
}

TEST(RangeCut, WhatIsCutIsStillWhatTheSensorSaid) {
  const SensedLog log = sensed({1.0, 5.0, 1.0, 1.0}, {.range_cut_m = 3.81, .jump_filter_m = 0.5}, model);
  EXPECT_EQ(ranges_of(log), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(log.report.rejected_pings[Rejection::range_cut].count, 1U);
  EXPECT_EQ(log.report.rejected_pings[Rejection::range_jump].count, 1U);
}

TEST(AirTemperature, RecordedRangesAreScaledByTheSpeedsOfSound) {
  // V1.1: c(288.15) = 340.4713, c(303) = 349.1343 m/s.
  Log log;
  log.robot.sensors = SensorArray::make(ring(2, 0.2, Angle{}, model)).value();
  log.temperature_k = 288.15;
  log.odometry = {test::odometry_at(0.0), test::odometry_at(1.0)};
  log.pings = {test::ping_at(0.5, 0, 2.0)};
  const SensedLog warm = sense(log, {.air_temperature_k = 303.0});
  EXPECT_NEAR(*echo_range_m(warm.readings[0].outcome), 2.0 * 349.1343 / 340.4713, 1e-6);
}

}  // namespace
}  // namespace echoarc
