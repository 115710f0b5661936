// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/carve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "echoarc/mapping/centerline.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

constexpr Angle beam = degrees(22.5);

Carve mapped(std::span<const Reading> readings, CarveOptions options = {}) {
  Carve method(options);
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);
  return method;
}

Reading up_from(Vec2 sensor, double range_m, PingId ping, Angle width = beam) {
  Reading reading = test::monostatic_reading({sensor, degrees(90.0)}, Echo{range_m}, width);
  reading.ping = ping;
  reading.time_s = 0.1 * double(ping);
  return reading;
}

std::uint64_t tally(const Carve& method, std::string_view name) {
  for (const Tally& t : method.tallies())
    if (t.name == name) return t.count;
  ADD_FAILURE() << "no tally " << name;
  return 0;
}

// V3.20 of the method specification: a specular wall at 2 m, twelve stops 0.1 m apart.
std::vector<Reading> wall_stops() {
  std::vector<Reading> readings;
  for (int k = 0; k < 12; ++k) readings.push_back(up_from({0.1 * k, 0.0}, 2.0, PingId(k)));
  return readings;
}

TEST(Carve, WorkedWall) {
  const Carve method = mapped(wall_stops());
  const auto points = method.map().points();
  ASSERT_EQ(points.size(), 12U);
  const double middle = degrees(90.0 + 0.5 * (11.25 - 1.43254)).rad();
  for (std::size_t k = 0; k < 11; ++k) {
    EXPECT_EQ(points[k].label, PointLabel::carved);
    EXPECT_NEAR(points[k].position.x, 0.1 * double(k) + 2.0 * std::cos(middle), 1e-6);
    EXPECT_NEAR(points[k].position.y, 2.0 * std::sin(middle), 1e-6);
    EXPECT_NEAR(points[k].bound_m, 4.0 * std::sin(0.25 * degrees(11.25 + 1.43254).rad()), 1e-6);
    const auto support = method.map().support(points[k]);
    ASSERT_EQ(support.size(), 2U);
    EXPECT_EQ(support[0], k);
    EXPECT_EQ(support[1], k + 1) << "the next stop cuts deepest";
    EXPECT_EQ(points[k].ping, k + 1) << "the newest of its pings";
  }
  EXPECT_EQ(points[11].label, PointLabel::centerline);
  EXPECT_EQ(method.map().support(points[11]).size(), 1U);
  EXPECT_EQ(tally(method, "carved"), 11U);
}

TEST(Carve, RemovedArcsAreCountedApart) {
  const std::vector<Reading> covered{up_from({0, 0}, 2.0, 0), up_from({0, -0.001}, 3.0, 1, degrees(24.0))};
  const Carve full = mapped(covered);
  EXPECT_EQ(full.map().size(), 1U);
  EXPECT_EQ(tally(full, "removed_full"), 1U);
  EXPECT_EQ(tally(full, "removed_split"), 0U);
  const std::vector<Reading> closer{up_from({0, 0}, 2.0, 0), up_from({0, 1.5}, 0.8, 1)};
  const Carve split = mapped(closer);
  EXPECT_EQ(split.map().size(), 1U);
  EXPECT_EQ(tally(split, "removed_full"), 0U);
  EXPECT_EQ(tally(split, "removed_split"), 1U);
}

TEST(Carve, OnlyNewerReadingsCarve) {
  std::vector<Reading> readings{up_from({0, 0}, 2.0, 0), up_from({0, -0.001}, 3.0, 1, degrees(24.0))};
  EXPECT_EQ(mapped(readings).map().size(), 1U);
  std::ranges::reverse(readings);
  EXPECT_EQ(mapped(readings).map().size(), 2U) << "the result depends on the order of time, as it must";
}

TEST(Carve, HistoryNoneAndOneCarveNothing) {
  const std::vector<Reading> readings = wall_stops();
  Centerline centerline;
  InlineExecutor here;
  centerline.insert(readings, here);
  for (const int history : {0, 1}) {
    const Carve method = mapped(readings, {.history = history});
    ASSERT_EQ(method.map().size(), readings.size());
    for (std::size_t k = 0; k < readings.size(); ++k)
      EXPECT_EQ(method.map().points()[k].position, centerline.map().points()[k].position);
    EXPECT_EQ(tally(method, "carved"), 0U);
  }
  EXPECT_EQ(tally(mapped(readings, {.history = 2}), "carved"), 11U);
}

TEST(Carve, ArchiveHoldsWhatHasLeftTheRing) {
  const std::vector<Reading> readings = wall_stops();
  EXPECT_EQ(mapped(readings, {.history = 4}).map().size(), 12U);
  const Carve local = mapped(readings, {.history = 4, .archive = false});
  EXPECT_EQ(local.map().size(), 4U);
  EXPECT_EQ(local.map().support(local.map().points()[0])[0], 8U);
  EXPECT_EQ(tally(local, "left_history"), 8U);
}

TEST(Carve, ErrorThresholdKeepsWellCarvedPointsAlone) {
  const Carve method = mapped(wall_stops(), {.error_threshold = true, .max_error_m = 0.25});
  EXPECT_EQ(method.map().size(), 11U) << "the uncarved one has 0.39 m";
  for (const MapPoint& point : method.map().points()) EXPECT_LE(point.bound_m, 0.25);
}

TEST(Carve, RangesOutOfUseAreCountedAndDoNotCarve) {
  std::vector<Reading> readings{up_from({0, 0}, 2.0, 0)};
  for (const double range_m : {3.82, 1e300, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    readings.push_back(up_from({0, -0.001}, range_m, readings.size(), degrees(24.0)));
  for (const Angle width : {degrees(0.0), degrees(180.0), degrees(1e9)})
    readings.push_back(up_from({0, -0.001}, 3.0, readings.size(), width));
  const Carve method = mapped(readings);
  EXPECT_EQ(method.map().size(), 1U);
  EXPECT_EQ(method.map().points()[0].label, PointLabel::centerline);
  EXPECT_EQ(method.counters().used, 1U);
  EXPECT_EQ(method.counters().no_information, 2U);
  EXPECT_EQ(method.counters().no_arc, 6U);
}

TEST(Carve, SilenceCarvesOnRequestToTheTrustedRange) {
  std::vector<Reading> readings{up_from({0, 0}, 2.0, 0), up_from({0, -0.001}, 0.0, 1, degrees(24.0))};
  readings[1].outcome = NoEcho{};
  EXPECT_EQ(mapped(readings).map().size(), 1U);
  EXPECT_EQ(mapped(readings).counters().no_information, 1U);
  EXPECT_EQ(mapped(readings, {.carve_with_timeouts = true}).map().size(), 0U);
  readings[1].trusted_range_m = 1.9;
  EXPECT_EQ(mapped(readings, {.carve_with_timeouts = true}).map().size(), 1U);
}

TEST(Carve, AnHourOfStandingStillChangesNothing) {
  const std::vector<Reading> readings(90'000, up_from({0, 0}, 2.0, 7));
  const Carve method = mapped(readings, {.archive = false});
  EXPECT_EQ(method.map().size(), 250U);
  for (const MapPoint& point : method.map().points()) EXPECT_EQ(point.position, method.map().points()[0].position);
  EXPECT_EQ(tally(method, "carved") + tally(method, "removed_full"), 0U);
  const Carve global = mapped(readings, {.max_memory_mib = 1});
  EXPECT_GT(global.counters().memory_limit, 0U);
  EXPECT_EQ(global.counters().used + global.counters().memory_limit, readings.size());
}

TEST(Carve, AMillionArcsOfHistory) {
  Rng rng(1);
  std::vector<Reading> readings;
  for (int k = 0; k < 20'000; ++k)
    readings.push_back(up_from({rng.uniform(-50, 50), rng.uniform(-50, 50)}, rng.uniform(0.2, 3.0), PingId(k)));
  const Carve method = mapped(readings, {.history = 1'000'000});
  EXPECT_EQ(method.counters().used, readings.size());
  EXPECT_EQ(method.map().size() + tally(method, "removed_full") + tally(method, "removed_split"), readings.size());
}

TEST(Carve, PosesThatJump) {
  Rng rng(2);
  std::vector<Reading> readings;
  for (int k = 0; k < 2'000; ++k) {
    const Vec2 far{100.0 * double(rng.below(5)), -100.0 * double(rng.below(5))};
    readings.push_back(up_from(far + Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)}, rng.uniform(0.2, 3.0), PingId(k)));
  }
  EXPECT_EQ(mapped(readings).counters().used, readings.size());
  readings.push_back(up_from({1e300, 0}, 1.0, 2'000));
  readings.push_back(up_from({std::numeric_limits<double>::quiet_NaN(), 0}, 1.0, 2'001));
  const Carve method = mapped(readings);
  EXPECT_EQ(method.counters().memory_limit, 2U) << "nothing so far away can be stored";
  for (const MapPoint& point : method.map().points()) EXPECT_TRUE(is_finite(point.position));
}

TEST(Carve, DamagedStatesAreRefused) {
  Rng rng(3);
  const std::vector<Reading> readings = test::random_readings(rng, 24);
  const std::vector<std::byte> bytes = mapped(readings, {.history = 12}).save();
  for (std::size_t size = 0; size < bytes.size(); size += 13)
    EXPECT_FALSE(Carve::restore(std::span(bytes).first(size))) << size;
  for (int k = 0; k < 3'000; ++k) {  // flipped bytes: refused, or a method that works on
    std::vector<std::byte> damaged = bytes;
    damaged[rng.below(damaged.size())] = std::byte(rng.below(256));
    if (Result<Carve> method = Carve::restore(damaged)) {
      InlineExecutor here;
      method->insert(std::span(readings).first(12), here);
      method->finish(here);
    }
  }
}

TEST(Carve, SupportsWhatLiesOnTheArc) {
  const Carve method;
  const Reading reading = up_from({1, 0}, 2.0, 0);
  EXPECT_TRUE(method.supports(reading, Vec2{1, 0} + 2.0 * unit(degrees(95.0))));
  EXPECT_FALSE(method.supports(reading, Vec2{1, 0} + 2.0 * unit(degrees(105.0))));
  EXPECT_FALSE(method.supports(reading, Vec2{1, 0} + 1.9 * unit(degrees(95.0))));
}

}  // namespace
}  // namespace echoarc
