// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/numakura.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mapping/numakura_judge.hpp"
#include "mapping/numakura_kernels.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

InlineExecutor here;

Numakura mapped(std::span<const Reading> readings, NumakuraOptions options = {}) {
  Numakura method(options);
  method.insert(readings, here);
  method.finish(here);
  return method;
}

Reading reading_at(Vec2 sensor, double heading_deg, double range_m, std::uint32_t scan) {
  Reading reading = test::monostatic_reading({sensor, degrees(heading_deg)}, Echo{range_m});
  reading.scan = scan;
  return reading;
}

double angle_deg(double los_deg, double before_m, double now_m) {
  const Vec2 u = unit(degrees(los_deg));
  return radians(surface_angle({{0, 0}, u, before_m}, {{0.1, 0}, u, now_m}, 0.0254)).deg();
}

TEST(Numakura, AngleBetweenBeamAndSurfaceIsV38) {
  EXPECT_NEAR(angle_deg(90.0, 1.50, 1.51), 84.289407, 1e-6);
  EXPECT_NEAR(angle_deg(90.0, 1.50, 1.90), 14.036243, 1e-6);
  EXPECT_NEAR(angle_deg(67.5, 1.50, 1.47), 84.885887, 1e-6);
  EXPECT_TRUE(std::isnan(radians(surface_angle({{0, 0}, {1, 0}, 1.5}, {{0.1, 0}, {1, 0}, 1.4}, 0.0254)).deg()))
      << "a front sensor that closes on a wall has no baseline";
}

TEST(Numakura, RangeWeightIsV38) {
  EXPECT_EQ(range_weight(1.5, 3.0), 1.0);
  EXPECT_EQ(range_weight(3.0, 3.0), 1.0);
  EXPECT_EQ(range_weight(4.0, 3.0), 0.75);
  EXPECT_EQ(range_weight(6.0, 3.0), 0.5);
}

TEST(Numakura, OneReadingRaisesItsSectorAndLowersItsArc) {
  const Reading reading = reading_at({0.011, 0.013}, 90.0, 4.0, 0);
  const Numakura method = mapped(std::span(&reading, 1));
  ArcRaster arcs(method.map().geometry());
  std::set<Cell> arc;
  for (const Cell cell : arcs.cells(*arc_of(reading))) {
    arc.insert(cell);
    EXPECT_NEAR(method.cell_value(cell), -3.0 * 0.75, 1e-6);
  }
  std::size_t inside = 0;
  for (std::int32_t j = -5; j < 100; ++j)
    for (std::int32_t i = -50; i < 50; ++i) {
      const Vec2 offset = method.map().geometry().centre({i, j}) - Vec2{0.011, 0.013};
      const bool free = norm(offset) < 3.95 && abs(wrap(bearing(offset) - degrees(90.0))) <= degrees(12.5);
      if (arc.contains({i, j})) continue;
      EXPECT_NEAR(method.cell_value({i, j}), free ? 0.75 : 0.0, 1e-6) << i << " " << j;
      inside += free ? 1 : 0;
    }
  EXPECT_GT(inside, 1000U);
}

TEST(Numakura, AnOutlierCountsATenth) {
  // V3.8: an outlier at d = 4: C_f = 0.0750, C_o = 0.2250. Test 1 sees the surface come 0.5 m nearer over 0.1 m.
  const std::vector<Reading> readings{reading_at({0, 0}, 90.0, 4.5, 0), reading_at({0.1, 0}, 90.0, 4.0, 1)};
  const Numakura both = mapped(readings);
  const Numakura first = mapped(std::span(readings).first(1));
  EXPECT_EQ(both.outliers(), (OutlierCounters{.geometry = 1}));
  ArcRaster arcs(both.map().geometry());
  const Cell on_arc = arcs.cells(*arc_of(readings[1]))[5];
  EXPECT_NEAR(both.cell_value(on_arc) - first.cell_value(on_arc), -0.2250, 1e-5);
  const Cell inside = both.map().geometry().cell_of({0.1, 2.0});
  EXPECT_NEAR(both.cell_value(inside) - first.cell_value(inside), 0.0750, 1e-5);
  EXPECT_EQ(mapped(readings, {.geometry_test = false}).outliers(), OutlierCounters{});
}

TEST(Numakura, TestOneNeedsTheScanBefore) {
  std::vector<Reading> readings{reading_at({0, 0}, 90.0, 1.5, 3), reading_at({0.1, 0}, 90.0, 1.9, 5)};
  EXPECT_EQ(mapped(readings).outliers().geometry, 0U);
  readings[1].scan = 4;
  EXPECT_EQ(mapped(readings).outliers().geometry, 1U);
  readings[1].tx = readings[1].rx = 7;
  EXPECT_EQ(mapped(readings).outliers().geometry, 0U);
}

/// A sensor that sees a wall at 1 m in `wall_scans` scans, then suddenly 2.5 m.
std::vector<Reading> leap(std::uint32_t wall_scans) {
  std::vector<Reading> readings;
  for (std::uint32_t scan = 0; scan < wall_scans; ++scan) readings.push_back(reading_at({0, 0}, 0.0, 1.0, scan));
  for (std::uint32_t k = 0; k < 3; ++k) readings.push_back(reading_at({0, 0}, 0.0, 2.5, wall_scans + k));
  return readings;
}

TEST(Numakura, TestTwoRefusesToLookThroughAMappedWall) {
  const NumakuraOptions only_second{.geometry_test = false};
  // The first leap is a jump; the readings after it follow an outlier.
  EXPECT_EQ(mapped(leap(12), only_second).outliers(), (OutlierCounters{.consistency = 3}));
  EXPECT_EQ(mapped(leap(5), only_second).outliers().consistency, 0U) << "not in the beginning";
  EXPECT_EQ(mapped(leap(12), {.geometry_test = false, .consistency_test = false}).outliers(), OutlierCounters{});
  EXPECT_EQ(mapped(leap(12), {.geometry_test = false, .jump_m = 2.0}).outliers().consistency, 0U);
  // Nearer readings end before the wall: their own wall is no obstacle in their way.
  std::vector<Reading> nearer = leap(12);
  for (std::size_t k = 12; k < nearer.size(); ++k) nearer[k].outcome = Echo{0.6};
  EXPECT_EQ(mapped(nearer, only_second).outliers().consistency, 0U);
}

TEST(Numakura, AScanIsJudgedByTheMapBeforeIt) {
  // Ten scans look the other way. The wall then appears within one scan: what follows in that scan looks through it.
  std::vector<Reading> readings;
  for (std::uint32_t scan = 0; scan < 12; ++scan) {
    readings.push_back(reading_at({0, 0}, 180.0, 1.0, scan));
    readings.back().tx = readings.back().rx = 1;
    if (scan == 11)
      for (SensorId other = 2; other < 12; ++other) {
        readings.push_back(reading_at({0, 0}, 0.0, 1.0, scan));
        readings.back().tx = readings.back().rx = other;
      }
    readings.push_back(reading_at({0, 0}, 0.0, scan == 11 ? 1.6 : 2.0, scan));
  }
  const NumakuraOptions only_second{.geometry_test = false};
  EXPECT_EQ(mapped(readings, only_second).outliers().consistency, 0U);
  Numakura pieces(only_second);
  for (const Reading& reading : readings) {
    pieces.insert(std::span(&reading, 1), here);
    pieces.finish(here);  // showing the scan early must not change how the rest of it is judged
  }
  EXPECT_EQ(pieces.save(), mapped(readings, only_second).save());
  readings.push_back(reading_at({0, 0}, 0.0, 2.0, 12));
  EXPECT_EQ(mapped(readings, only_second).outliers().consistency, 1U) << "the next scan sees the wall";
}

TEST(Numakura, SilenceClearsToTheTrustedRange) {
  Reading silent = reading_at({0.011, 0.013}, 90.0, 1.0, 0);
  silent.outcome = NoEcho{};
  const Numakura method = mapped(std::span(&silent, 1));
  EXPECT_EQ(method.cell_value(method.map().geometry().cell_of({0.0, 2.9})), 0.5);
  EXPECT_EQ(method.cell_value(method.map().geometry().cell_of({0.0, 3.2})), 0.0);
  EXPECT_TRUE(method.export_map()->points.empty());
  EXPECT_EQ(mapped(std::span(&silent, 1), {.no_echo_weight = 0.0}).counters(), (InsertCounters{.no_information = 1}));
}

TEST(Numakura, BistaticReadingsUseTheirEllipse) {
  Reading reading = reading_at({-0.1, 0.0}, 90.0, 1.0, 0);
  reading.rx = 1;
  reading.T_world_rx.position = {0.1, 0.0};
  const Numakura method = mapped(std::span(&reading, 1));
  ArcRaster arcs(method.map().geometry());
  for (const Cell cell : arcs.cells(*arc_of(reading))) EXPECT_EQ(method.cell_value(cell), -3.0);
  EXPECT_EQ(method.cell_value(method.map().geometry().cell_of({0.001, 0.51})), 1.0);
}

TEST(Numakura, ValuesStopAtTheClampAndComeBack) {
  const std::vector<Reading> wall(2000, reading_at({0.011, 0.013}, 90.0, 1.0, 0));
  const std::vector<Reading> air(2000, reading_at({0.011, 0.013}, 90.0, 2.0, 0));
  const Cell cell = Numakura().map().geometry().cell_of({0.011, 1.013});
  EXPECT_EQ(mapped(wall).cell_value(cell), -1000.0);
  std::vector<Reading> both = wall;
  both.insert(both.end(), air.begin(), air.end());
  EXPECT_EQ(mapped(both).cell_value(cell), 1000.0);
}

TEST(Numakura, OneScanForEverTakesBoundedMemory) {
  Numakura method({.max_memory_mib = 8});
  const Reading reading = reading_at({0.011, 0.013}, 90.0, 1.0, 0);
  for (int k = 0; k < 20000; ++k) method.insert(std::span(&reading, 1), here);
  EXPECT_EQ(method.counters().used, 20000U);
  EXPECT_LT(method.save().size(), std::size_t{8} << 20);
}

TEST(Numakura, AbsurdReadingsAreCountedAndCostNothing) {
  std::vector<Reading> readings(9, reading_at({0, 0}, 0.0, 1.0, 0));
  readings[0].outcome = Echo{1e9};
  readings[1].T_world_tx.position = {1e12, 0.0};
  readings[2].outcome = Echo{1e300};
  readings[3].outcome = Echo{0.0};
  readings[4].beam_width = degrees(180.0);
  readings[5].outcome = Echo{INFINITY};
  readings[6].T_world_tx.heading = radians(NAN);
  readings[7].outcome = Echo{0.01};  // nearer than a cell: an arc without an inside
  const Numakura method = mapped(readings, {.max_memory_mib = 1});
  EXPECT_EQ(method.counters(), (InsertCounters{.used = 2, .no_arc = 4, .memory_limit = 3}));
}

TEST(Numakura, ARobotThatStandsStillOrJumpsIsHandled) {
  std::vector<Reading> readings;
  for (std::uint32_t scan = 0; scan < 500; ++scan) readings.push_back(reading_at({0, 0}, 30.0, 1.5, scan));
  EXPECT_EQ(mapped(readings).outliers(), OutlierCounters{}) << "no baseline, no jump";
  for (std::uint32_t scan = 0; scan < 500; ++scan) readings[scan].T_world_tx.position = {100.0 * (scan % 7), 0.0};
  EXPECT_EQ(mapped(readings).counters().used, 500U);
}

TEST(Numakura, TraceTellsWhatInsertingDoes) {
  Rng rng(5);
  std::vector<Reading> readings = test::wall_drive(rng, 14);
  const Reading next = readings.back();
  readings.pop_back();
  const Numakura before = mapped(readings);
  readings.push_back(next);
  const Numakura after = mapped(readings);
  const Trace trace = before.trace(next);
  ASSERT_TRUE(trace.arc);
  ASSERT_FALSE(trace.cells.empty());
  for (const CellChange& change : trace.cells) {
    EXPECT_EQ(change.before, before.cell_value(change.cell));
    EXPECT_NEAR(change.after, after.cell_value(change.cell), 1e-5);
  }
}

RC_GTEST_PROP(NumakuraProperty, TestsOnlyReduceUpdates, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::wall_drive(rng, 14);
  const auto sum = [&](bool first, bool second) {
    double total = 0.0;
    mapped(readings, {.geometry_test = first, .consistency_test = second})
        .map()
        .for_each_nonzero([&](Cell, std::int32_t value) { total += std::abs(value * numakura_unit); });
    return total;
  };
  RC_ASSERT(sum(true, true) <= sum(false, false) + 1e-6);
}

RC_GTEST_PROP(NumakuraProperty, HostileBytesAreRefusedOrHarmless, (std::uint64_t seed)) {
  Rng rng(seed);
  const Numakura method = mapped(test::random_readings(rng, 6), {.max_memory_mib = 16});
  std::vector<std::byte> bytes = method.save();
  for (int k = 0; k < 4; ++k) bytes[rng.below(bytes.size())] = static_cast<std::byte>(rng.below(256));
  if (rng.below(2) == 0) bytes.resize(rng.below(bytes.size()));
  auto restored = Numakura::restore(bytes);
  if (!restored) return;
  restored->insert(test::random_readings(rng, 6), here);
  restored->finish(here);
  RC_ASSERT(restored->map().memory_bytes() <= std::size_t{1} << 34);
}

TEST(NumakuraKernels, AllSetsGiveTheSameCells) {
  Rng rng(3);
  alignas(64) std::int32_t start[4][64];
  constexpr std::int32_t ceiling = 1000;
  for (auto& row : start)
    for (std::int32_t& value : row) value = std::int32_t(rng.below(2 * ceiling)) - ceiling;
  std::vector<std::array<std::int32_t, 3>> runs;
  for (int k = 0; k < 200; ++k) {
    const auto begin = std::int32_t(rng.below(65));
    runs.push_back({std::int32_t(rng.below(4)), begin, begin + std::int32_t(rng.below(std::uint64_t(65 - begin)))});
  }
  std::int32_t expected[4][64];
  std::memcpy(expected, start, sizeof start);
  for (const auto& [row, begin, end] : runs)
    for (std::int32_t l = begin; l < end; ++l) expected[row][l] = std::min(expected[row][l] + 37, ceiling);
  const kernels::AccumulationKernels* list[4];
  const std::size_t count = kernels::available_accumulation_kernels(list, 4);
  for (std::size_t k = 0; k < count; ++k) {
    alignas(64) std::int32_t cells[4][64];
    std::memcpy(cells, start, sizeof start);
    std::vector<kernels::TileRun> tile_runs;
    tile_runs.reserve(runs.size());
    for (const auto& [row, begin, end] : runs) tile_runs.push_back({cells[row], begin, end});
    list[k]->raise(tile_runs.data(), tile_runs.size(), 37, ceiling);
    EXPECT_EQ(std::memcmp(cells, expected, sizeof cells), 0) << list[k]->instruction_set;
  }
}

}  // namespace
}  // namespace echoarc
