// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

Sensing small_robot() {
  return Sensing(SensorArray::make(row(2, 0.1, 0.0, test::model_of(0.2, 4.0))).value());
}

TEST(SensingHostile, AMillionPingsOfAnUnknownSensor) {
  Sensing sensing = small_robot();
  sensing.push(test::odometry_at(0.0));
  for (std::uint32_t k = 0; k < 1'000'000; ++k) sensing.push(test::ping_at(0.0, 100 + k, 1.0));
  EXPECT_EQ(sensing.report().rejected_pings[Rejection::unknown_sensor].count, 1'000'000U);
  EXPECT_EQ(sensing.report().sensors.size(), 2U) << "ids of a hostile log take no memory";
}

TEST(SensingHostile, AMillionPingsWithoutOdometryWaitInBoundedMemory) {
  Sensing sensing = small_robot();
  for (int k = 0; k < 1'000'000; ++k) sensing.push(test::ping_at(0.001 * k, 0, 1.0));
  EXPECT_EQ(sensing.report().waiting, Sensing::max_waiting);
  sensing.end_of_odometry();
  EXPECT_EQ(sensing.report().waiting, 0U);
  EXPECT_EQ(sensing.report().rejected_pings[Rejection::no_pose].count, 1'000'000U);
  EXPECT_EQ(sensing.report().rejected_pings[Rejection::no_pose].first_index, Sensing::max_waiting)
      << "the first that was given up was the first for which there was no room";
}

TEST(SensingHostile, ARobotWithoutSensors) {
  Log log;
  log.odometry = {test::odometry_at(0.0)};
  log.pings = {test::ping_at(0.0, 0, 1.0)};
  const SensingReport report = sense(log).report;
  EXPECT_EQ(report.rejected_pings[Rejection::unknown_sensor].count, 1U);
  EXPECT_TRUE(report.no_echo.empty());
}

TEST(SensingHostile, AnEmptyLog) {
  const SensedLog sensed = sense(Log{});
  EXPECT_TRUE(sensed.readings.empty());
  EXPECT_EQ(sensed.report.pings, 0U);
}

TEST(SensingHostile, TimeRunningBackwardsThroughout) {
  Log log = test::drive(0.0, test::model_of(0.2, 4.0));
  std::ranges::reverse(log.odometry);
  std::ranges::reverse(log.pings);
  const SensingReport report = sense(log).report;
  EXPECT_EQ(report.rejected_odometry[Rejection::time_backwards].count, log.odometry.size() - 1);
  EXPECT_EQ(report.accepted() + report.rejected_pings.total(), log.pings.size());
  EXPECT_EQ(report.accepted(), 0U);
}

TEST(SensingHostile, NumbersOfEveryKindNeverReachAReading) {
  constexpr std::array evil{test::nan, test::inf, -test::inf, 1e300, -1e300, 5e-324, -0.0, 1e19, 0.5, 2.0};
  Rng rng(7);
  const auto any = [&] { return evil[rng.below(evil.size())]; };
  Sensing sensing = small_robot();
  for (int k = 0; k < 100'000; ++k) {
    sensing.push(Odometry{.time_s = k % 3 ? 0.01 * k : any(), .T_world_robot = {{any(), any()}, radians(any())}});
    sensing.push(test::odometry_at(0.01 * k + 0.001));
    Ping ping = test::ping_at(k % 3 ? 0.01 * k : any(), SensorId(rng.below(3)), any());
    ping.tx = SensorId(rng.below(3));
    ping.time_of_flight_s = any();
    sensing.push(ping);
    sensing.push(WallNote{.time_s = any(), .side = WallSide::left});
  }
  sensing.end_of_odometry();
  const SensingReport& report = sensing.report();
  EXPECT_EQ(report.accepted() + report.rejected_pings.total(), 100'000U);
  EXPECT_GT(report.accepted(), 1000U);
  for (const Reading& reading : sensing.readings()) {
    ASSERT_TRUE(std::isfinite(reading.time_s) && is_finite(reading.T_world_tx) && is_finite(reading.T_world_rx));
    const double range_m = echo_range_m(reading.outcome).value_or(1.0);
    ASSERT_TRUE(range_m >= 0.19 && range_m <= 4.0);
  }
}

}  // namespace
}  // namespace echoarc
