// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/sensing/poll_stamper.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "echoarc/sensing/stamp_bound.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

constexpr double air_k = 293.0;

TEST(PollStamper, AChangeDatesItsFiringAsV41) {
  PollStamper stamper({.time_out_s = {0.0222, 0.0222}});
  const double flight_s = flight_time_of_range_s(1.5, air_k);
  stamper.push({.time_s = 0.110, .ranges_m = {1.0, 2.0}}, std::vector{flight_s, flight_s});
  stamper.push({.time_s = 0.120, .ranges_m = {1.0, 2.0}}, std::vector{flight_s, flight_s});
  stamper.push({.time_s = 0.130, .ranges_m = {1.5, 2.0}}, std::vector{flight_s, flight_s});
  stamper.finish();
  ASSERT_EQ(stamper.firings().size(), 1U) << "nothing is known before the first change";
  const StampedFiring& firing = stamper.firings()[0];
  EXPECT_EQ(firing.sensor, 0U);
  EXPECT_EQ(firing.register_m, 1.5);
  EXPECT_NEAR(firing.fired.lo_s, 0.1112619, 5e-8);
  EXPECT_NEAR(firing.fired.hi_s, 0.1212619, 5e-8);
  EXPECT_NEAR(firing.fired.middle_s(), 0.1162619, 5e-8);
}

TEST(PollStamper, PoseBoundIsV41) {
  const TimeInterval fired{0.1112619, 0.1212619};
  const std::vector<Odometry> samples{test::odometry_at(0.0), test::odometry_at(0.1, 0.1 * 0.05),
                                      test::odometry_at(0.2, 0.1 * 0.05 + 0.1 * 0.127, degrees(3.0)),
                                      test::odometry_at(0.3, 5.0)};
  const StampBound bound = stamp_bound(samples, fired, 0.0);
  EXPECT_NEAR(bound.position_m, 0.000635, 5e-7);
  EXPECT_NEAR(bound.turn.deg(), 0.15, 1e-9);
  EXPECT_NEAR(stamp_bound(samples, fired, 0.2).position_m, 0.000635 + 0.2 * degrees(0.15).rad(), 1e-9);
  EXPECT_EQ(stamp_bound({}, fired, 0.2).position_m, 0.0);
}

TEST(PollStamper, SensorsBetweenTwoKnownOnesAreV42) {
  const FiringTiming timing{.gap_min_s = 0.038, .gap_max_s = 0.042, .time_out_s = std::vector<double>(16, 0.0222)};
  const StampedFiring before{.sequence = 3, .sensor = 3, .fired = {0.0100, 0.0120}};
  const StampedFiring after{.sequence = 7, .sensor = 7, .fired = {0.1700, 0.1720}};
  const double expected[][2] = {{0.0480, 0.0540}, {0.0860, 0.0960}, {0.1280, 0.1340}};
  for (std::uint64_t m = 4; m <= 6; ++m) {
    const TimeInterval fired = firing_between(before, after, m, timing);
    EXPECT_NEAR(fired.lo_s, expected[m - 4][0], 1e-12) << m;
    EXPECT_NEAR(fired.hi_s, expected[m - 4][1], 1e-12) << m;
  }
}

/// An array of 16 that fires with gaps of 38 to 42 ms and is polled every 5 ms.
struct Drive {
  std::vector<double> fired_s;
  std::vector<double> value_m;
  std::vector<Poll> polls;
  double range_max_m;

  Drive(Rng& rng, std::size_t firings, double unchanged, double max_m) : range_max_m(max_m) {
    constexpr std::size_t n = 16;
    std::vector<double> registers(n, 1.0);
    struct Update {
      double time_s;
      std::size_t sensor;
      double value_m;
    };
    std::vector<Update> updates;
    double time_s = 0.2;
    for (std::size_t m = 0; m < firings; ++m) {
      fired_s.push_back(time_s);
      const bool same = m > 0 && rng.uniform(0.0, 1.0) < unchanged;
      if (!same) registers[m % n] = std::round(rng.uniform(0.2, max_m - 0.01) * 1e4) / 1e4;
      value_m.push_back(registers[m % n]);
      updates.push_back({time_s + flight_time_of_range_s(registers[m % n], air_k), m % n, registers[m % n]});
      time_s += rng.uniform(0.038, 0.042);
    }
    std::ranges::sort(updates, {}, &Update::time_s);
    std::vector<double> shown(n, 1.0);
    std::size_t next = 0;
    for (double t = 0.0; t < time_s + 0.3; t += 0.005) {
      for (; next < updates.size() && updates[next].time_s <= t; ++next)
        shown[updates[next].sensor] = updates[next].value_m;
      polls.push_back({.time_s = t, .ranges_m = shown});
    }
  }
  [[nodiscard]] std::vector<StampedFiring> stamped(PollStamper& stamper) const {
    for (const Poll& poll : polls) {
      std::vector<double> flight_s;
      for (const double range_m : poll.ranges_m) flight_s.push_back(flight_time_of_range_s(range_m, air_k));
      stamper.push(poll, flight_s);
    }
    stamper.finish();
    return {stamper.firings().begin(), stamper.firings().end()};
  }
  [[nodiscard]] PollStamper stamper() const {
    return PollStamper({.time_out_s = std::vector<double>(16, flight_time_of_range_s(range_max_m, air_k))});
  }
};

TEST(PollStamper, EveryIntervalHoldsTheTrueFiringTime) {
  for (const double range_max_m : {3.81, 10.7})
    for (const double unchanged : {0.0, 0.5, 0.9}) {
      SCOPED_TRACE(std::to_string(range_max_m) + " m, " + std::to_string(unchanged));
      Rng rng(7);
      const Drive drive(rng, 500, unchanged, range_max_m);
      PollStamper stamper = drive.stamper();
      const std::vector<StampedFiring> firings = drive.stamped(stamper);
      ASSERT_GE(firings.size(), 450U);
      double mean_s = 0.0;
      std::uint64_t first = 0;
      for (const StampedFiring& firing : firings) {
        if (&firing == firings.data() || firing.sequence < first) first = firing.sequence - firing.sensor;
        const std::uint64_t m = firing.sequence - first;
        if (m >= drive.fired_s.size()) continue;  // the array stopped; polls went on
        EXPECT_LE(firing.fired.lo_s, drive.fired_s[m] + 1e-9) << m;
        EXPECT_GE(firing.fired.hi_s, drive.fired_s[m] - 1e-9) << m;
        EXPECT_EQ(firing.register_m, drive.value_m[m]) << m;
        mean_s += firing.fired.half_width_s() / double(firings.size());
      }
      EXPECT_LT(mean_s, unchanged == 0.9 ? 0.025 : 0.0065);
      EXPECT_EQ(stamper.counters().anomalies, 0U);
    }
}

TEST(PollStamper, LongSilenceEndsAndStartsAfresh) {
  PollStamper stamper({.time_out_s = std::vector<double>(16, 0.0222)});
  const std::vector<double> flight_s(16, flight_time_of_range_s(1.0, air_k));
  std::vector<double> registers(16, 2.0);
  double t = 0.0;
  const auto poll_for = [&](double seconds) {
    for (const double until = t + seconds; t < until; t += 0.005)
      stamper.push({.time_s = t, .ranges_m = registers}, flight_s);
  };
  poll_for(0.1);
  registers[4] = 1.0;
  poll_for(3600.0);  // a robot that stands still for an hour
  const std::size_t before = stamper.firings().size();
  EXPECT_LT(before, 100U);
  registers[9] = 1.0;
  poll_for(1.0);
  stamper.finish();
  EXPECT_GT(stamper.firings().size(), before);
  EXPECT_EQ(stamper.counters().fresh_starts, 2U);
  for (std::size_t k = 1; k < stamper.firings().size(); ++k)
    EXPECT_GT(stamper.firings()[k].sequence, stamper.firings()[k - 1].sequence);
}

TEST(PollStamper, BadPollsAreCounted) {
  PollStamper stamper({.time_out_s = {0.02, 0.02}});
  const std::vector<double> flight_s{0.01, test::nan};
  stamper.push({.time_s = 0.0, .ranges_m = {1.0, test::nan}}, flight_s);
  stamper.push({.time_s = 0.0, .ranges_m = {1.0, 2.0}}, flight_s);
  stamper.push({.time_s = test::nan, .ranges_m = {1.0, 2.0}}, flight_s);
  stamper.push({.time_s = 1.0, .ranges_m = {1.0}}, std::vector{0.01});
  stamper.push({.time_s = 1.0, .ranges_m = {1.0, test::nan}}, flight_s);
  stamper.push({.time_s = 1e300, .ranges_m = {2.0, 3.0}}, flight_s);
  stamper.push({.time_s = 1e10, .ranges_m = {3.0, test::inf}}, flight_s);
  stamper.finish();
  EXPECT_EQ(stamper.counters().polls, 7U);
  EXPECT_EQ(stamper.counters().bad_polls, 4U);
}

TEST(PollStamper, ASteadyArrayIsNotFollowedForEver) {
  PollStamper stamper({.gap_min_s = 0.04, .gap_max_s = 0.04, .time_out_s = {0.02, 0.02}});
  const std::vector<double> flight_s{0.01, 0.01};
  stamper.push({.time_s = 0.0, .ranges_m = {1.0, 1.0}}, flight_s);
  stamper.push({.time_s = 0.005, .ranges_m = {2.0, 1.0}}, flight_s);
  stamper.push({.time_s = 1e10, .ranges_m = {2.0, 1.0}}, flight_s);
  stamper.push({.time_s = 1e10 + 1.0, .ranges_m = {2.0, 2.0}}, flight_s);
  stamper.finish();
  EXPECT_LT(stamper.firings().size(), 200U);
}

RC_GTEST_PROP(PollStamperProperty, AnythingIsSurvived, (std::uint64_t seed)) {
  Rng rng(seed);
  PollStamper stamper({.time_out_s = std::vector<double>(5, 0.0222)});
  double t = 0.0;
  for (int k = 0; k < 300; ++k) {
    t += rng.below(20) == 0 ? rng.uniform(0.0, 1000.0) : rng.uniform(0.0, 0.05);
    std::vector<double> registers(5);
    std::vector<double> flight_s(5);
    for (std::size_t s = 0; s < 5; ++s) {
      registers[s] = double(rng.below(3));
      flight_s[s] = rng.below(5) == 0 ? test::nan : rng.uniform(0.0, 0.06);
    }
    stamper.push({.time_s = t, .ranges_m = registers}, flight_s);
  }
  stamper.finish();
  for (std::size_t k = 0; k < stamper.firings().size(); ++k) {
    RC_ASSERT(!stamper.firings()[k].fired.empty());
    RC_ASSERT(stamper.firings()[k].sequence % 5 == stamper.firings()[k].sensor);
  }
}

/// The drive as a log of a robot that moves at `speed_m_s`.
Log polled_log(double speed_m_s) {
  Rng rng(3);
  const Drive drive(rng, 200, 0.2, 3.81);
  Log log;
  log.robot.sensors =
      SensorArray::make(ring(16, 0.23, Angle{}, test::model_of(0.1, 3.81, {.kind = NoEchoRule::Kind::inf}))).value();
  for (int k = 0; k <= 100; ++k) log.odometry.push_back(test::odometry_at(0.1 * k, 0.1 * k * speed_m_s));
  log.polls = drive.polls;
  return log;
}

TEST(Polling, StampsAreNearerToTheTruthThanNaiveOnes) {
  const Log log = polled_log(0.5);
  Rng rng(3);
  const Drive drive(rng, 200, 0.2, 3.81);
  const auto mean_error_s = [&](const SensingOptions& options) {
    const SensedLog sensed = sense(log, options);
    EXPECT_GT(sensed.readings.size(), 100U);
    EXPECT_EQ(sensed.report.pings, sensed.report.accepted() + sensed.report.rejected_pings.total());
    double sum = 0.0;
    for (const Reading& reading : sensed.readings) {
      if (reading.time_s > drive.fired_s.back()) continue;  // the array stopped; polls went on
      double nearest_s = 1e9;
      for (std::size_t m = 0; m < drive.fired_s.size(); ++m)
        if (m % 16 == reading.rx) nearest_s = std::min(nearest_s, std::abs(drive.fired_s[m] - reading.time_s));
      sum += nearest_s;
    }
    return sum / double(sensed.readings.size());
  };
  const double interval_s = mean_error_s({});
  EXPECT_LT(interval_s, 0.005);
  EXPECT_GT(mean_error_s({.polling = Polling::naive}), 2.0 * interval_s);
}

TEST(Polling, PingsOfAFastRobotAreLeftOutWithAReason) {
  EXPECT_EQ(sense(polled_log(0.2)).report.rejected_pings[Rejection::stamp_uncertain].count, 0U);
  const SensingReport fast = sense(polled_log(30.0)).report;
  EXPECT_GT(fast.rejected_pings[Rejection::stamp_uncertain].count, 50U);
  EXPECT_EQ(sense(polled_log(30.0), {.max_stamp_error_m = 10.0}).report.rejected_pings.total(), 0U);
}

TEST(Polling, ReadingsAreTheSameWhenRecordsArriveOneByOne) {
  const Log log = polled_log(0.5);
  const SensedLog whole = sense(log);
  Sensing live(log.robot.sensors);
  std::size_t next = 0;
  for (const Odometry& sample : log.odometry) {
    live.push(sample);
    for (; next < log.polls.size() && log.polls[next].time_s <= sample.time_s; ++next) live.push(log.polls[next]);
  }
  live.end_of_polls();
  live.end_of_odometry();
  ASSERT_EQ(live.readings().size(), whole.readings.size());
  for (std::size_t k = 0; k < whole.readings.size(); ++k) {
    EXPECT_EQ(live.readings()[k].time_s, whole.readings[k].time_s);
    EXPECT_EQ(live.readings()[k].outcome, whole.readings[k].outcome);
  }
}

TEST(Polling, PollsOfALogWithPingsAreLeftAlone) {
  Log log = polled_log(0.2);
  log.pings = {test::ping_at(1.0, 0, 1.0)};
  EXPECT_EQ(sense(log).report.pings, 1U);
}

}  // namespace
}  // namespace echoarc
