// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/combined.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/atm.hpp"
#include "echoarc/mapping/carve.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options = {}) {
  Method method(options);
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);
  return method;
}

/// Echo and position of the points of some labels.
std::multimap<PingId, Vec2> points_of(const PointMap& map, bool atm) {
  std::multimap<PingId, Vec2> points;
  for (const MapPoint& point : map.points())
    if ((point.label == PointLabel::atm) == atm) points.emplace(map.support(point)[0], point.position);
  return points;
}

std::vector<Reading> drive(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Reading> readings = test::wall_drive(rng, 60);
  for (int k = 0; k < 60; ++k) readings.push_back(test::random_reading(rng, readings.size()));
  return readings;
}

TEST(Combined, BothMethodsWorkAsIfAlone) {
  const std::vector<Reading> readings = drive(1);
  const auto combined = mapped<Combined>(readings, {.history = 100});
  const auto carve = mapped<Carve>(readings, {.history = 100});
  const auto atm = mapped<AtmSilver>(readings, {.history_arcs = 100});
  const auto medians = points_of(combined.map(), true);
  EXPECT_EQ(medians, points_of(atm.map(), true));
  EXPECT_GT(medians.size(), 20U);
  std::size_t carved = 0;
  for (const MapPoint& point : carve.map().points()) {
    const PingId echo = carve.map().support(point)[0];
    const auto others = points_of(combined.map(), false);
    const auto found = others.find(echo);
    const bool expected = point.label == PointLabel::carved || !medians.contains(echo);
    ASSERT_EQ(found != others.end(), expected) << echo;
    if (found == others.end()) continue;
    EXPECT_EQ(found->second, point.position);
    ++carved;
  }
  EXPECT_EQ(carved + medians.size(), combined.map().size());
  EXPECT_EQ(combined.tallies()[1], carve.tallies()[1]);
  EXPECT_EQ(combined.tallies()[2], carve.tallies()[2]);
}

TEST(Combined, PreferAtmShowsOnePointPerEcho) {
  const std::vector<Reading> readings = drive(2);
  const auto both = mapped<Combined>(readings);
  const auto one = mapped<Combined>(readings, {.combine = Combine::prefer_atm});
  EXPECT_LT(one.map().size(), both.map().size());
  EXPECT_EQ(points_of(one.map(), true), points_of(both.map(), true));
  std::map<PingId, int> count;
  for (const MapPoint& point : one.map().points()) EXPECT_EQ(++count[one.map().support(point)[0]], 1);
}

TEST(Combined, RemovedArcsKeepTheirMedian) {
  // Two arcs that cross at 60 degrees in (0, 2), then a reading that looks through both.
  std::vector<Reading> readings;
  for (const double axis_deg : {60.0, 120.0}) {
    const Vec2 sensor = Vec2{0, 2} - 2.0 * unit(degrees(axis_deg));
    readings.push_back(test::monostatic_reading({sensor, degrees(axis_deg)}, Echo{2.0}));
    readings.back().ping = readings.size() - 1;
  }
  readings.push_back(test::monostatic_reading({{0, 0.2}, degrees(90.0)}, Echo{3.0}, degrees(90.0)));
  readings.back().ping = 2;
  EXPECT_EQ(mapped<Carve>(readings).map().size(), 1U);
  const auto combined = mapped<Combined>(readings);
  const auto medians = points_of(combined.map(), true);
  ASSERT_EQ(medians.size(), 2U);
  for (const auto& [echo, position] : medians) EXPECT_LT(norm(position - Vec2{0, 2}), 1e-9);
  EXPECT_EQ(combined.tallies()[1].count, 2U) << "removed_full";
}

TEST(Combined, ErrorThresholdSparesMedians) {
  const std::vector<Reading> readings = drive(3);
  const auto all = mapped<Combined>(readings);
  const auto few = mapped<Combined>(readings, {.error_threshold = true, .max_error_m = 0.05});
  EXPECT_EQ(points_of(few.map(), true), points_of(all.map(), true));
  EXPECT_LT(few.map().size(), all.map().size());
  for (const MapPoint& point : few.map().points()) EXPECT_LE(point.bound_m, 0.05);  // w(30 deg)/2 is 4.7 cm
}

TEST(Combined, HostileHistoriesAndRanges) {
  std::vector<Reading> readings = drive(4);
  const std::size_t sound = readings.size();
  for (const double range_m : {0.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    readings.push_back(readings[0]);
    readings.back().outcome = Echo{range_m};
  }
  readings.push_back(readings[0]);
  readings.back().T_world_tx.position.x = readings.back().T_world_rx.position.x = 1e300;
  for (const int history : {0, 1, 1'000'000}) {
    const auto method = mapped<Combined>(readings, {.history = history});
    EXPECT_EQ(method.counters().used, sound);
    EXPECT_GE(method.map().size(), history == 0 ? sound : 1U);
    for (const MapPoint& point : method.map().points()) EXPECT_TRUE(is_finite(point.position));
  }
}

TEST(Combined, StandingStillAndJumping) {
  std::vector<Reading> readings(20'000, test::monostatic_reading({{0, 0}, degrees(90.0)}, Echo{2.0}));
  for (std::size_t k = 0; k < readings.size(); k += 100) readings[k].T_world_tx.position.x = 100.0 * double(k % 7);
  for (Reading& reading : readings) reading.T_world_rx = reading.T_world_tx;
  const auto method = mapped<Combined>(readings, {.archive = false});
  EXPECT_EQ(method.counters().used, readings.size());
  EXPECT_LE(method.map().size(), 500U);
}

TEST(Combined, DamagedStatesAreRefused) {
  Rng rng(5);
  const std::vector<Reading> readings = drive(5);
  const std::vector<std::byte> bytes = mapped<Combined>(std::span(readings).subspan(280, 40), {.history = 12}).save();
  for (std::size_t size = 0; size < bytes.size(); size += 31)
    EXPECT_FALSE(Combined::restore(std::span(bytes).first(size))) << size;
  for (int k = 0; k < 2'000; ++k) {
    std::vector<std::byte> damaged = bytes;
    damaged[rng.below(damaged.size())] = std::byte(rng.below(256));
    if (Result<Combined> method = Combined::restore(damaged)) {
      InlineExecutor here;
      method->insert(std::span(readings).first(12), here);
      method->finish(here);
    }
  }
}

}  // namespace
}  // namespace echoarc
