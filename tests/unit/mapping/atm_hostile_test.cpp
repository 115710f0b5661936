// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The arc-transversal median under input that no honest drive gives.

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/mapping/atm.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

using test::monostatic_reading;

template <class Method>
Method mapped(const std::vector<Reading>& readings, typename Method::Options options = {}) {
  Method method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

TEST(AtmHostile, EqualReadingsForEverNeverCross) {
  const std::vector<Reading> readings(2000, monostatic_reading({{1.0, 2.0}, degrees(30.0)}, Echo{1.5}));
  AtmOrg::Options options;
  options.history = HistoryScope::all;
  const auto org = mapped<AtmOrg>(readings, options);
  EXPECT_EQ(org.map().size(), readings.size());
  for (const MapPoint& point : org.map().points()) EXPECT_EQ(point.label, PointLabel::centerline);
  EXPECT_TRUE(mapped<AtmMod>(readings).map().empty());
}

TEST(AtmHostile, ConcentricArcsNeverCross) {
  std::vector<Reading> readings;
  for (int k = 0; k < 1000; ++k)
    readings.push_back(monostatic_reading({{1.0, 2.0}, degrees(0.36 * k)}, Echo{0.5 + 0.001 * (k % 700)}));
  EXPECT_TRUE(mapped<AtmMod>(readings,
                             [] {
                               AtmMod::Options o;
                               o.theta_t = Angle{};
                               return o;
                             }())
                  .map()
                  .empty());
}

/// Sixteen sonars on one spot: neighbours cross at the edges of their beams, again and again.
std::vector<Reading> standing_still(std::size_t count) {
  Rng rng(5);
  std::vector<Reading> readings(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Angle yaw = degrees(22.5 * double(k % 16));
    readings[k] = monostatic_reading({0.23 * unit(yaw), yaw}, Echo{1.5 + rng.normal(0.0, 0.005)}, degrees(40.0));
    readings[k].ping = k;
    readings[k].tx = readings[k].rx = SensorId(k % 16);
  }
  return readings;
}

TEST(AtmHostile, AnHourOnOneSpotStaysBounded) {
  const std::vector<Reading> readings = standing_still(90'000);  // one every 40 ms
  AtmSilver::Options ring;
  ring.theta_t = Angle{};
  ring.archive = false;
  const auto online = mapped<AtmSilver>(readings, ring);
  EXPECT_EQ(online.map().size(), 250U);
  EXPECT_LT(online.memory_bytes(), std::size_t{2} << 20);
  AtmMod::Options all;
  all.theta_t = Angle{};
  all.max_memory_mib = 16;
  const auto batch = mapped<AtmMod>(readings, all);
  EXPECT_GT(batch.counters().memory_limit, 0U);
  EXPECT_LT(batch.memory_bytes(), std::size_t{17} << 20);
}

TEST(AtmHostile, AnArcKeepsSoManyCrossingsAndNoMore) {
  // One arc crossed by thousands of others in the same place.
  std::vector<Reading> readings = {monostatic_reading({{0, 0}, Angle{}}, Echo{1.0})};
  const std::size_t limit = TransversalMedians::max_crossings_per_arc;
  for (std::size_t k = 0; k < limit + 100; ++k)
    readings.push_back(monostatic_reading({{1.0, -1.0}, degrees(90.0)}, Echo{1.0}));
  const auto method = mapped<AtmMod>(readings);
  EXPECT_EQ(method.medians().median(method.history(), 0).count, limit);
  EXPECT_EQ(method.medians().pairs_left_out(), 100U);
  EXPECT_EQ(method.map().size(), limit + 1) << "those left out have no crossing";
}

TEST(AtmHostile, RangesOfNoSenseAreCountedOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Reading> readings;
  for (const double range_m : {1e16, 1e200, 1e308}) readings.push_back(monostatic_reading({}, Echo{range_m}));
  for (const Vec2 place : {Vec2{nan, 0.0}, Vec2{1e300, 0.0}})
    readings.push_back(monostatic_reading({place, {}}, Echo{1.0}));
  readings.push_back(monostatic_reading({{0, 0}, radians(nan)}, Echo{1.0}));
  const auto method = mapped<AtmOrg>(readings);
  EXPECT_EQ(method.counters().no_arc, readings.size());
  EXPECT_TRUE(method.map().empty());
  EXPECT_TRUE(method.trace(readings[0]).points.empty());
  const auto tiny = mapped<AtmOrg>({monostatic_reading({}, Echo{1e-12}), monostatic_reading({}, Echo{1e6})});
  EXPECT_EQ(tiny.map().size(), 2U);
}

TEST(AtmHostile, PosesThatJumpCostNoMore) {
  Rng rng(6);
  std::vector<Reading> readings = test::random_readings(rng, 3000);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const Vec2 jump{100.0 * double(rng.below(1000)), -100.0 * double(rng.below(1000))};
    for (Pose2* T : {&readings[k].T_world_tx, &readings[k].T_world_rx}) T->position = T->position + jump;
  }
  const auto method = mapped<AtmMod>(readings);
  EXPECT_EQ(method.counters().used, readings.size());
  EXPECT_LT(method.memory_bytes(), readings.size() * 1500);
}

TEST(AtmHostile, AHistoryOfOneArcCrossesNothing) {
  Rng rng(7);
  AtmOrg::Options options;
  options.history = HistoryScope::total;
  options.history_arcs = 1;
  const auto method = mapped<AtmOrg>(test::random_readings(rng, 100), options);
  EXPECT_EQ(method.map().size(), 100U);
  for (const MapPoint& point : method.map().points()) EXPECT_EQ(point.label, PointLabel::centerline);
  EXPECT_FALSE(make_options<AtmOrg::Options>({{"history_arcs", std::int64_t{0}}})) << "a history of none is refused";
}

TEST(AtmHostile, DamagedStatesAreRefused) {
  Rng rng(8);
  std::vector<Reading> readings = test::random_readings(rng, 120);
  AtmSilver::Options options;
  options.history_arcs = 50;
  options.theta_t = degrees(5.0);
  const std::vector<std::byte> bytes = mapped<AtmSilver>(readings, options).save();
  ASSERT_TRUE(AtmSilver::restore(bytes));
  for (std::size_t length = 0; length < bytes.size(); length += 97)
    EXPECT_FALSE(AtmSilver::restore(std::span(bytes).first(length)));
  InlineExecutor executor;
  for (int k = 0; k < 3000; ++k) {
    std::vector<std::byte> damaged = bytes;
    for (int n = 0; n < 3; ++n) damaged[rng.below(damaged.size())] = std::byte(rng.below(256));
    auto method = AtmSilver::restore(damaged);
    if (!method) continue;
    method->insert(readings, executor);  // whatever was read back, it goes on
    method->finish(executor);
    EXPECT_LE(method->history().size(), readings.size() + 50);
  }
}

}  // namespace
}  // namespace echoarc
