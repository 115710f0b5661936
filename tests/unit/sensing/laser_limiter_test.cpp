// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/laser_limiter.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "sensing/hit_kernels.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

Reading reading_of(double range_m) {
  Reading reading;
  reading.outcome = Echo{range_m};
  return reading;
}

/// Hits as the limiter keeps them.
struct Hits {
  std::vector<double> x, y;

  explicit Hits(const std::vector<Vec2>& points) {
    for (const Vec2 p : points) {
      x.push_back(p.x);
      y.push_back(p.y);
    }
    while (x.size() % kernels::hit_lanes != 0) {
      x.push_back(test::nan);
      y.push_back(test::nan);
    }
  }
};

double limit(const Reading& reading, LaserLimit rule, const std::vector<Vec2>& points) {
  const Hits hits(points);
  return limit_of(reading, rule, hits.x, hits.y);
}

TEST(LaserLimiter, NearestHitInTheBeamIsV39) {
  const std::vector<Vec2> hits{{2.0, 0.1}, {1.8, 1.0}, {2.5, -0.3}};
  EXPECT_NEAR(limit(reading_of(4.2), LaserLimit::cone_min, hits), 2.002498, 5e-7);
  EXPECT_NEAR(limit(reading_of(4.2), LaserLimit::cone_min, {hits[1], hits[2]}), 2.517936, 5e-7);
  EXPECT_EQ(limit(reading_of(4.2), LaserLimit::cone_min, {hits[1]}), test::inf);
  // The axis crosses the line from the second to the third at 1.8 + 0.7 * 1.0 / 1.3.
  EXPECT_NEAR(limit(reading_of(4.2), LaserLimit::axis, {hits[1], hits[2]}), 1.8 + 0.7 / 1.3, 1e-12);
  EXPECT_EQ(limit(reading_of(4.2), LaserLimit::axis, {hits[0], hits[1]}), test::inf);
  EXPECT_EQ(limit(reading_of(4.2), LaserLimit::axis, {{-2, -1}, {-2, 1}}), test::inf) << "behind the sensor";
}

TEST(LaserLimiter, HitsNearerThanTheSonarCanMeasureAreIgnored) {
  for (const LaserLimit rule : {LaserLimit::cone_min, LaserLimit::axis})
    EXPECT_NEAR(limit(reading_of(4.2), rule, {{0.1, -0.001}, {0.1, 0.001}, {3.0, 0.01}, {3.0, -0.01}}), 3.0, 1e-4);
}

RC_GTEST_PROP(LaserLimiterProperty, ConeAgreesWithBearings, (std::uint64_t seed)) {
  Rng rng(seed);
  Reading reading = reading_of(5.0);
  reading.T_world_tx = {{rng.uniform(-3, 3), rng.uniform(-3, 3)}, degrees(rng.uniform(-180, 180))};
  reading.T_world_rx = reading.T_world_tx;
  if (rng.below(2) == 0) {
    reading.rx = 1;
    reading.T_world_rx = reading.T_world_tx * Pose2{{0.05, -0.2}, degrees(rng.uniform(-80, 80))};
  }
  reading.beam_width = degrees(rng.uniform(1, 170));
  const auto arc = arc_of(reading);
  std::vector<Vec2> points;
  double expected = test::inf;
  for (int k = 0; k < 61; ++k) {
    points.push_back({rng.uniform(-5, 5), rng.uniform(-5, 5)});
    if (rng.below(5) == 0) points.back().x = test::nan;
    const bool inside = abs(wrap(bearing(points.back() - arc->centre()) - arc->axis())) <= arc->half_width();
    const double half_path_m = arc->half_path_m(points.back());
    if (inside && half_path_m >= reading.range_min_m) expected = std::min(expected, half_path_m);
  }
  const double found = limit(reading, LaserLimit::cone_min, points);
  RC_ASSERT(found == expected || std::abs(found - expected) < 1e-12);
}

TEST(HitKernels, AllSetsGiveTheSameNumber) {
  Rng rng(4);
  std::vector<Vec2> points;
  for (int k = 0; k < 361; ++k) points.push_back({rng.uniform(-5, 5), rng.uniform(-5, 5)});
  const Hits hits(points);
  const kernels::HitKernels* list[4];
  const std::size_t sets = kernels::available_hit_kernels(list, 4);
  for (int k = 0; k < 100; ++k) {
    const Vec2 axis = unit(radians(rng.uniform(-3, 3)));
    const double focal = k % 2 == 0 ? 0.0 : 0.1;
    const kernels::BeamCone cone{0.3, -0.2, axis.x, axis.y, rng.uniform(0.01, 1.0), focal, 0.0, 0.15};
    const double plain = list[0]->nearest(cone, hits.x.data(), hits.y.data(), hits.x.size());
    for (std::size_t set = 1; set < sets; ++set)
      EXPECT_EQ(list[set]->nearest(cone, hits.x.data(), hits.y.data(), hits.x.size()), plain);
  }
}

/// A robot with four sonars of a 6 m range and a laser 0.1 m before its middle that sees a wall at x = `wall_x_m`.
Log log_with_laser(double wall_x_m, double scan_offset_s = 0.0) {
  Log log;
  log.robot.sensors =
      SensorArray::make(ring(4, 0.2, Angle{}, test::model_of(0.15, 6.0, {.kind = NoEchoRule::Kind::inf}))).value();
  log.robot.lasers = {{.id = 3, .mount = {.x_m = 0.1}, .range_max_m = 8.0}};
  for (int k = 0; k <= 40; ++k) {
    const double time_s = 0.1 * k;
    log.odometry.push_back(test::odometry_at(time_s, 0.02 * k));
    Scan scan{.time_s = time_s + scan_offset_s, .laser = 3, .angle_min = degrees(-90.0), .angle_step = degrees(0.5)};
    const double from_x_m = 0.02 * k + 0.1 + 0.2 * scan_offset_s;
    for (int beam = 0; beam <= 360; ++beam) {
      const double range_m = (wall_x_m - from_x_m) / cos(degrees(-90.0 + 0.5 * beam));
      scan.ranges_m.push_back(range_m < 8.0 ? float(range_m) : NAN);
    }
    log.scans.push_back(scan);
    for (SensorId sensor = 0; sensor < 4; ++sensor)
      log.pings.push_back(test::ping_at(time_s, sensor, k % 3 == 0 ? test::inf : 4.5 + 0.001 * k + 0.0001 * sensor));
  }
  return log;
}

TEST(LaserLimiter, ShortensWhatTheLaserSawNearerInALog) {
  const Log log = log_with_laser(3.0);
  const SensedLog plain = sense(log);
  const SensedLog limited = sense(log, {.laser_limit = LaserLimit::cone_min});
  ASSERT_EQ(limited.readings.size(), plain.readings.size());
  for (std::size_t k = 0; k < plain.readings.size(); ++k) {
    const Reading& reading = limited.readings[k];
    EXPECT_EQ(reading.laser_limited, reading.rx == 0) << "the sensors beside and behind see no laser return nearer";
    if (reading.rx == 0) {
      EXPECT_NEAR(*echo_range_m(reading.outcome), 3.0 - reading.T_world_rx.position.x, 1e-5);
    } else {
      EXPECT_EQ(reading.outcome, plain.readings[k].outcome);
    }
  }
  EXPECT_EQ(limited.report.laser_limited, 41U);
  EXPECT_EQ(limited.report.scans, 41U);
  EXPECT_EQ(plain.report.scans, 0U);
}

TEST(LaserLimiter, WallsBehindTheEchoLimitNothing) {
  for (const Reading& reading : sense(log_with_laser(6.5), {.laser_limit = LaserLimit::axis}).readings) {
    const bool silent_and_near = reading.rx == 0 && 6.5 - reading.T_world_rx.position.x < 6.0 + 1e-5;
    EXPECT_EQ(reading.laser_limited, reading.laser_limited && silent_and_near);
    if (reading.laser_limited) {
      EXPECT_GT(*echo_range_m(reading.outcome), 5.0) << "silence counts as 6 m";
    }
  }
}

TEST(LaserLimiter, ScansAreUsedWithinTheirAgeAndWhereTheyWereTaken) {
  const Log late = log_with_laser(3.0, 0.03);
  const SensedLog limited = sense(late, {.laser_limit = LaserLimit::cone_min});
  for (const Reading& reading : limited.readings)
    if (reading.rx == 0 && reading.laser_limited) {
      EXPECT_NEAR(*echo_range_m(reading.outcome), 3.0 - reading.T_world_rx.position.x, 1e-5);
    }
  EXPECT_GE(limited.report.laser_limited, 40U) << "the last scan lies after the odometry";
  EXPECT_EQ(sense(late, {.laser_limit = LaserLimit::cone_min, .laser_max_age_s = 0.01}).report.laser_limited, 0U);
}

TEST(LaserLimiter, ReadingsAreTheSameWhenRecordsArriveOneByOne) {
  const Log log = log_with_laser(3.0, 0.03);
  const SensedLog whole = sense(log, {.laser_limit = LaserLimit::cone_min});
  Sensing live(log.robot.sensors, {.laser_limit = LaserLimit::cone_min});
  live.use_lasers(log.robot.lasers);
  for (std::size_t k = 0; k < log.odometry.size(); ++k) {
    live.push(log.odometry[k]);
    for (std::size_t sensor = 0; sensor < 4; ++sensor) live.push(log.pings[4 * k + sensor]);
    live.push(log.scans[k]);
  }
  live.end_of_odometry();
  ASSERT_EQ(live.readings().size(), whole.readings.size());
  for (std::size_t k = 0; k < whole.readings.size(); ++k) {
    EXPECT_EQ(live.readings()[k].outcome, whole.readings[k].outcome) << k;
    EXPECT_EQ(live.readings()[k].laser_limited, whole.readings[k].laser_limited) << k;
  }
}

TEST(LaserLimiter, BadScansAreCountedWithAReason) {
  Log log = log_with_laser(3.0);
  log.scans[5].laser = 9;
  log.scans[6].time_s = test::nan;
  log.scans[8].time_s = 0.0;
  log.scans[9].ranges_m = {-1.0F, INFINITY, 0.0F, NAN, 1e30F};
  log.scans[10].ranges_m.clear();
  const SensingReport report = sense(log, {.laser_limit = LaserLimit::axis}).report;
  EXPECT_EQ(report.rejected_scans[Rejection::unknown_sensor].count, 1U);
  EXPECT_EQ(report.rejected_scans[Rejection::bad_time].count, 1U);
  EXPECT_EQ(report.rejected_scans[Rejection::time_backwards].count, 1U);
  EXPECT_GT(report.laser_limited, 30U);
}

TEST(LaserLimiter, BothKindsOfReadingsInOnePass) {
  const Log log = log_with_laser(3.0);
  Sensing both = sensing_for(log, {}, true);
  for (const Ping& ping : log.pings) both.push(ping);
  ASSERT_EQ(both.readings().size(), both.limited_readings().size());
  const SensedLog plain = sense(log);
  const SensedLog limited = sense(log, {.laser_limit = LaserLimit::cone_min});
  for (std::size_t k = 0; k < both.readings().size(); ++k) {
    EXPECT_EQ(both.readings()[k].outcome, plain.readings[k].outcome);
    EXPECT_EQ(both.limited_readings()[k].outcome, limited.readings[k].outcome);
  }
}

}  // namespace
}  // namespace echoarc
