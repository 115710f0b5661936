// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/himm.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "support/random_readings.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

/// A sensor in the middle of cell (0, 0) that looks along the row and hears something in the middle of cell (n, 0).
Reading echo_in(int n) {
  return test::monostatic_reading({{0.05, 0.05}, Angle{}}, Echo{0.1 * n});
}

void insert(Himm& method, const Reading& reading) {
  InlineExecutor executor;
  method.insert(std::span(&reading, 1), executor);
}

int certainty(const Himm& method, Cell cell) {
  return method.map().value(cell).certainty;
}

// V3.7
TEST(Himm, CertaintiesWorkedNumbers) {
  Himm method;
  const auto cells = [&] {
    return std::array{certainty(method, {5, 0}), certainty(method, {6, 0}), certainty(method, {9, 0})};
  };
  const std::array expected{std::array{0, 3, 0},  std::array{0, 6, 0},  std::array{3, 6, 0},  std::array{2, 9, 0},
                            std::array{1, 12, 0}, std::array{0, 15, 0}, std::array{0, 14, 3}, std::array{0, 13, 6}};
  const int ends[] = {6, 6, 5, 6, 6, 6, 9, 9};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    insert(method, echo_in(ends[k]));
    EXPECT_EQ(cells(), expected[k]) << "after " << k + 1;
  }
  EXPECT_EQ(method.counters().used, 8U);
}

// The same with the growth rate operator: half the neighbours' sum, rounded down, on top of every increment.
TEST(Himm, NeighboursSpeedUpGrowth) {
  Himm method({.growth_rate = true});
  insert(method, echo_in(6));
  insert(method, echo_in(6));
  EXPECT_EQ(certainty(method, {6, 0}), 6) << "no neighbours yet";
  insert(method, echo_in(5));
  EXPECT_EQ(certainty(method, {5, 0}), 6) << "3 and half of 6";
  insert(method, echo_in(6));
  EXPECT_EQ(certainty(method, {5, 0}), 5);
  EXPECT_EQ(certainty(method, {6, 0}), 12) << "6 and 3 and half of the 6 before it";
}

TEST(Himm, PassedCellsReachFromTheSensorToBeforeTheEcho) {
  Himm method;
  insert(method, echo_in(6));
  for (int i = 0; i <= 6; ++i) EXPECT_EQ(method.map().value({i, 0}).visited, 1) << i;
  EXPECT_EQ(method.map().value({7, 0}).visited, 0);
  const auto map = method.export_map();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->states.at({0, 0}), CellState::free);
  EXPECT_EQ(map->states.at({6, 0}), CellState::unknown) << "certainty 3 is neither";
}

TEST(Himm, EchoesBeyondTheLimitAndSilenceOnlyLower) {
  Himm method;
  for (int k = 0; k < 5; ++k) insert(method, echo_in(6));
  ASSERT_EQ(certainty(method, {6, 0}), 15);
  Reading far = echo_in(80);
  far.range_max_m = 5.0;
  insert(method, far);
  EXPECT_EQ(certainty(method, {6, 0}), 14);
  EXPECT_EQ(method.map().value({50, 0}).visited, 1);
  EXPECT_EQ(method.map().value({51, 0}).visited, 0);
  Reading silent = echo_in(1);
  silent.outcome = NoEcho{};
  silent.trusted_range_m = 2.0;
  insert(method, silent);
  EXPECT_EQ(certainty(method, {6, 0}), 13);
}

TEST(Himm, BistaticReadingsAreLeftOutAndCounted) {
  Reading reading = echo_in(6);
  reading.rx = reading.tx + 1;
  reading.T_world_rx.position.y += 0.1;
  Himm method;
  insert(method, reading);
  EXPECT_EQ(method.counters().used, 0U);
  EXPECT_EQ(method.counters().no_information, 1U);
  EXPECT_EQ(method.tallies(), (std::vector<Tally>{{"bistatic", 1}}));
  EXPECT_EQ(method.map().tile_count(), 0U);
  EXPECT_EQ(Himm::restore(method.save())->tallies(), method.tallies());
}

TEST(Himm, TraceTellsWhatInsertDoes) {
  Rng rng(5);
  Himm method({.growth_rate = true});
  for (const Reading& reading : test::random_readings(rng, 200)) {
    const Trace trace = method.trace(reading);
    for (const CellChange& change : trace.cells) EXPECT_EQ(change.before, certainty(method, change.cell));
    insert(method, reading);
    for (const CellChange& change : trace.cells) EXPECT_EQ(change.after, certainty(method, change.cell));
    EXPECT_EQ(trace.cells.empty(), !reading.monostatic());
  }
}

TEST(Himm, HostileRangesCostNothing) {
  Himm method;
  Reading reading = echo_in(1);
  reading.range_max_m = std::numeric_limits<double>::max();
  for (const double range_m : {0.0, -1.0, 1e-300, 1e9, 1e300}) {
    reading.outcome = Echo{range_m};
    insert(method, reading);
  }
  EXPECT_EQ(method.counters().memory_limit, 2U);
  EXPECT_EQ(method.map().tile_count(), 1U);
}

TEST(Himm, RefusesStatesThatNoDriveLeads) {
  Himm method;
  insert(method, echo_in(6));
  std::vector<std::byte> bytes = method.save();
  bytes.back() = std::byte{7};  // `visited` of the last cell
  EXPECT_FALSE(Himm::restore(bytes));
  bytes.resize(bytes.size() / 2);
  EXPECT_FALSE(Himm::restore(bytes));
}

}  // namespace
}  // namespace echoarc
