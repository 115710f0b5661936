// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/voting.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_readings.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

Voting mapped(std::span<const Reading> readings, VotingOptions options) {
  Voting method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

std::vector<Vec2> occupied(const Voting& method) {
  std::vector<Vec2> positions;
  const Result<MapExport> map = method.export_map();
  for (const MapPoint& point : map->points.points()) positions.push_back(point.position);
  return positions;
}

RC_GTEST_PROP(VotingProperty, ThresholdIsMonotone, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 20);
  std::size_t previous = mapped(readings, {.cell_m = 0.05, .threshold = 1}).export_map()->points.size();
  for (int threshold = 2; threshold <= 6; ++threshold) {
    const Voting method = mapped(readings, {.cell_m = 0.05, .threshold = threshold});
    const std::vector<Vec2> cells = occupied(method);
    RC_ASSERT(cells.size() <= previous);
    for (const Vec2 p : cells) RC_ASSERT(method.map().value(method.map().geometry().cell_of(p)) >= threshold);
    previous = cells.size();
  }
}

RC_GTEST_PROP(VotingProperty, OrderOfReadingsDoesNotMatter, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Reading> readings = test::random_readings(rng, 20);
  const std::vector<std::byte> forward = mapped(readings, {.cell_m = 0.05}).save();
  std::ranges::reverse(readings);
  RC_ASSERT(mapped(readings, {.cell_m = 0.05}).save() == forward);
}

TEST(Voting, AnArcThatReturnsToACellCountsOnce) {
  // It leaves cell (0, 4) through its top and comes back.
  const Reading reading = test::monostatic_reading({{0.005, 0.00001}, degrees(90.0)}, Echo{0.05});
  const Voting method = mapped(std::span(&reading, 1), {.sampling = ArcSampling::exact});
  EXPECT_EQ(method.map().value({0, 4}), 1);
  EXPECT_EQ(method.map().value({0, 5}), 1);
}

TEST(Voting, CountsSaturate) {
  const Reading reading = test::monostatic_reading({{0.005, 0.005}, degrees(90.0)}, Echo{0.05});
  const std::vector<Reading> many(65536 + 10, reading);
  const Voting method = mapped(many, {});
  EXPECT_EQ(method.map().value({0, 5}), 65535);
  EXPECT_EQ(method.counters().used, many.size());
  EXPECT_EQ(method.trace(reading).cells.front().after, 65535.0);
}

TEST(Voting, TraceAndSupportNameTheCellsOfTheArc) {
  const std::vector<Reading> readings = test::v53_readings();
  const Voting method = mapped(std::span(readings).first(10), test::with_v53_grid(VotingOptions{}));
  const Trace trace = method.trace(readings[10]);
  ASSERT_TRUE(trace.arc);
  EXPECT_EQ(trace.cells.size(), 49U);  // V2.1: the same arc elsewhere
  for (const CellChange& change : trace.cells) {
    EXPECT_EQ(change.before, method.map().value(change.cell));
    EXPECT_EQ(change.after, change.before + 1.0);
    EXPECT_TRUE(method.supports(readings[10], change.centre));
  }
  EXPECT_FALSE(method.supports(readings[10], {0.505, 0.5}));
}

TEST(Voting, EveryReadingIsCountedOnce) {
  std::vector<Reading> readings(5, test::monostatic_reading({}, Echo{1.0}));
  readings[1].outcome = NoEcho{};
  readings[2].outcome = TooClose{};
  readings[3].outcome = Invalid{};
  readings[4].rx = 1;
  readings[4].T_world_rx.heading = degrees(120.0);  // axes more than 90 degrees apart
  const Voting method = mapped(readings, {});
  EXPECT_EQ(method.counters(), (InsertCounters{.used = 1, .no_information = 3, .no_arc = 1}));
}

TEST(Voting, AbsurdReadingsAreCountedAndCostNothing) {
  std::vector<Reading> readings(3, test::monostatic_reading({}, Echo{1.0}));
  readings[0].outcome = Echo{1e9};
  readings[1].T_world_tx.position = {1e12, 0.0};
  readings[2].outcome = Echo{1e300};
  const Voting method = mapped(readings, {.max_memory_mib = 1});
  EXPECT_EQ(method.counters(), (InsertCounters{.memory_limit = 3}));
  EXPECT_LE(method.map().memory_bytes(), std::size_t{1} << 20);
}

TEST(Voting, AMapTooWideToDrawSaysSo) {
  std::vector<Reading> readings(2, test::monostatic_reading({}, Echo{1.0}));
  readings[1].T_world_tx.position = {300.0, 300.0};
  const Result<MapExport> map = mapped(readings, {}).export_map();
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, ErrorCode::too_large);
  EXPECT_FALSE(map.error().remedy.empty());
}

TEST(Voting, AnEmptyMapIsNoError) {
  const Result<MapExport> map = Voting().export_map();
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->states.empty());
  EXPECT_TRUE(map->points.empty());
}

}  // namespace
}  // namespace echoarc
