// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/arc_history.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

Arc random_arc(Rng& rng, double spread_m) {
  const Vec2 sensor{rng.uniform(-spread_m, spread_m), rng.uniform(-spread_m, spread_m)};
  const double range_m = rng.below(50) == 0 ? rng.uniform(10.0, 200.0) : rng.uniform(0.2, 4.0);
  return Arc::circular(sensor, degrees(rng.uniform(-180, 180)), range_m, degrees(rng.uniform(5, 60)));
}

/// What `candidates` has to give, arc by arc.
std::vector<ArcSlot> naive_candidates(const ArcHistory& history, const Box& box) {
  std::vector<ArcSlot> found;
  for (const ArcSlot slot : history.in_time_order())
    if (overlap(box, history.box(slot))) found.push_back(slot);
  return found;
}

void drive(ArcHistory& history, std::uint64_t seed, int arcs, double spread_m) {
  Rng rng(seed);
  std::vector<ArcSlot> found;
  for (int k = 0; k < arcs; ++k) {
    const ArcSource source{PingId(k), 0.1 * k, SensorId(rng.below(7))};
    if (const auto old = history.leaving(source.sensor)) history.evict(*old);
    const ArcSlot slot = history.insert(random_arc(rng, spread_m), source);
    ASSERT_TRUE(history.is_live(slot));
    ASSERT_EQ(history.sequence(slot), std::uint64_t(k));
    if (k % 5 != 0) continue;
    const Box box = k % 3 == 0 ? random_arc(rng, spread_m).bounds() : history.box(slot);
    history.candidates(box, found);
    ASSERT_EQ(found, naive_candidates(history, box)) << k;
  }
}

TEST(ArcHistory, KeepsEveryArc) {
  ArcHistory history;
  drive(history, 1, 3000, 8.0);
  EXPECT_EQ(history.size(), 3000U);
  EXPECT_EQ(history.slot_count(), 3000U);
}

TEST(ArcHistory, KeepsTheNewestOfEachSensor) {
  ArcHistory history(HistoryScope::per_sensor, 10);
  drive(history, 2, 500, 4.0);
  EXPECT_EQ(history.size(), 70U);
  EXPECT_EQ(history.slot_count(), 70U);
  std::vector<int> count(7);
  for (const ArcSlot slot : history.in_time_order()) ++count[history.source(slot).sensor];
  EXPECT_EQ(count, std::vector<int>(7, 10));
}

TEST(ArcHistory, KeepsTheNewestInTotalThroughTheHashAndWithoutIt) {
  for (const std::size_t capacity : {1U, 250U, 1000U}) {
    ArcHistory history(HistoryScope::total, capacity);
    drive(history, 3, 4000, 10.0);
    EXPECT_EQ(history.size(), capacity);
    std::uint64_t expected = 4000 - capacity;
    for (const ArcSlot slot : history.in_time_order()) EXPECT_EQ(history.sequence(slot), expected++);
  }
}

TEST(ArcHistory, MemoryDoesNotGrowWithTheAreaVisited) {
  ArcHistory history(HistoryScope::total, 1000);
  std::size_t early = 0;
  for (int k = 0; k < 40000; ++k) {
    if (const auto old = history.leaving(0)) history.evict(*old);
    history.insert(Arc::circular({0.1 * k, 0.0}, degrees(90.0), 2.0, degrees(25.0)), {});
    if (k == 4000) early = history.memory_bytes();
  }
  EXPECT_EQ(history.memory_bytes(), early);
}

TEST(ArcHistory, ArcsWithoutBoundsOrFarAwayCostNoMore) {
  ArcHistory history;
  for (int k = 0; k < 2000; ++k)
    history.insert(Arc::circular({1e12 * (k % 3), 0.0}, degrees(k), k % 2 == 0 ? 1e12 : 1.0, degrees(170.0)), {});
  EXPECT_LT(history.memory_bytes(), std::size_t{4} << 20);
  std::vector<ArcSlot> found;
  for (const ArcSlot slot : {0U, 1U, 777U, 1998U}) {
    history.candidates(history.box(slot), found);
    EXPECT_EQ(found, naive_candidates(history, history.box(slot)));
  }
  EXPECT_FALSE(ArcHistory::is_storable(Arc::circular({0, 0}, degrees(0.0), 1e300, degrees(25.0))));
  EXPECT_FALSE(ArcHistory::is_storable(Arc::circular({1e300, 0}, degrees(0.0), 1.0, degrees(25.0))));
}

}  // namespace
}  // namespace echoarc
