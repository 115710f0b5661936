// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/log_statistics.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

LogStatistics statistics_of(const Log& log) {
  return log_statistics(log, decide_no_echo(log.robot.sensors, log.pings));
}

TEST(LogStatistics, CountsEveryPingOfASensorOnce) {
  Log log;
  log.robot.sensors = SensorArray::make(ring(2, 0.2, Angle{}, test::model_of(0.2, 4.0))).value();
  for (const double range_m : {1.0, 3.0, 2.0, 2.5, test::inf, -test::inf, test::nan, 0.1, 20.0})
    log.pings.push_back(test::ping_at(0.5 * static_cast<double>(log.pings.size()), 1, range_m));
  log.pings.push_back(test::ping_at(9.0, 7, 1.0));
  const LogStatistics statistics = statistics_of(log);
  ASSERT_EQ(statistics.sensors.size(), 2U);
  EXPECT_EQ(statistics.sensors[0].pings, 0U);
  EXPECT_TRUE(std::isnan(statistics.sensors[0].rate_hz));
  EXPECT_TRUE(std::isnan(statistics.sensors[0].range_median_m));
  const SensorStatistics& sensor = statistics.sensors[1];
  EXPECT_EQ(sensor.pings, 9U);
  EXPECT_EQ(sensor.echoes, 4U);
  EXPECT_EQ(sensor.no_echoes, 1U);
  EXPECT_EQ(sensor.too_close, 1U);
  EXPECT_EQ(sensor.unusable, 3U);
  EXPECT_DOUBLE_EQ(sensor.rate_hz, 2.0);
  EXPECT_EQ(sensor.range_min_m, 1.0);
  EXPECT_EQ(sensor.range_median_m, 2.0);
  EXPECT_EQ(sensor.range_max_m, 3.0);
  EXPECT_EQ(statistics.unknown_sensor_pings, 1U);
}

TEST(LogStatistics, MeasuresTheWayThroughUsablePoses) {
  Log log;
  for (const double x_m : {0.0, 3.0, test::nan, 3.0, 1.0})
    log.odometry.push_back(test::odometry_at(static_cast<double>(log.odometry.size()), x_m));
  log.odometry.push_back(test::odometry_at(2.0, 50.0));  // back in time: no part of the way
  const LogStatistics statistics = statistics_of(log);
  EXPECT_DOUBLE_EQ(statistics.path_m, 5.0);
  EXPECT_DOUBLE_EQ(statistics.duration_s(), 4.0);
}

TEST(LogStatistics, AnEmptyLogHasNoDuration) {
  const LogStatistics statistics = statistics_of({});
  EXPECT_TRUE(std::isnan(statistics.duration_s()));
  EXPECT_EQ(statistics.path_m, 0.0);
}

}  // namespace
}  // namespace echoarc
