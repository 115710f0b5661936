// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/carved_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/evidence_grid.hpp"
#include "mapping/survival_profile.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options) {
  Method method(options);
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);
  return method;
}

Reading up_from(Vec2 sensor, double range_m) {
  return test::monostatic_reading({sensor, degrees(90.0)}, Echo{range_m});
}

float log_odds_at(const CarvedGrid& method, Vec2 position) {
  return method.map().value(method.map().geometry().cell_of(position));
}

TEST(SurvivalProfile, IsTheSmoothedShareOfArcs) {
  // Half width 3.4 degrees: bins at -3 ... 3. Two arcs hold 0 ... 3, one of them -3 ... -1 as well.
  const std::vector<AngleInterval> arcs{{degrees(-3.4), degrees(3.4)}, {degrees(-0.5), degrees(3.4)}};
  const auto profile = SurvivalProfile::of(arcs, degrees(3.4));
  ASSERT_TRUE(profile);
  // Shares (1 1 1 2 2 2 2)/2, means of three (of two at the ends): 1, 1, 4/3, 5/3, 2, 2, 2, scaled by 1/2.
  const double expected[] = {0.5, 0.5, 2.0 / 3.0, 5.0 / 6.0, 1.0, 1.0, 1.0};
  for (int k = 0; k < 7; ++k) EXPECT_NEAR(profile->at(degrees(k - 3.0)), expected[k], 1e-12) << k - 3;
  EXPECT_NEAR(profile->at(degrees(-0.5)), 0.75, 1e-12) << "linear between the middles of bins";
  EXPECT_NEAR(profile->at(degrees(3.4)), 1.0, 1e-12) << "constant beyond the last";
}

TEST(SurvivalProfile, NeedsAnArcThatHoldsAMiddle) {
  EXPECT_FALSE(SurvivalProfile::of({}, degrees(10.0)));
  const std::vector<AngleInterval> narrow{{degrees(0.2), degrees(0.8)}};
  EXPECT_FALSE(SurvivalProfile::of(narrow, degrees(10.0)));
}

// Without enough arcs of a sensor the grid is the evidence grid, up to the rounding of the latter.
TEST(CarvedGrid, FewReadingsGiveTheEvidenceGrid) {
  Rng rng(1);
  std::vector<Reading> readings = test::random_readings(rng, 24);
  for (std::size_t k = 0; k < readings.size(); ++k) readings[k].tx = readings[k].rx = SensorId(k);
  for (std::size_t k = 0; k < readings.size(); k += 5) readings[k].outcome = NoEcho{};
  const auto carved = mapped<CarvedGrid>(readings, {});
  const auto evidence = mapped<EvidenceGrid>(readings, {});
  std::size_t cells = 0;
  evidence.map().for_each_nonzero([&](Cell cell, std::int16_t value) {
    EXPECT_NEAR(double(carved.map().value(cell)), value * log_odds_unit, 25 * log_odds_unit);
    ++cells;
  });
  EXPECT_GT(cells, 500U);
}

TEST(CarvedGrid, DeferredBandLiesOnWhatIsLeft) {
  // C1 of V3.19 with a beam of 25 degrees: the newer reading leaves of the older one what lies left of the middle.
  const std::vector<Reading> readings{up_from({0, 0}, 2.0), up_from({0.2, 0}, 2.0)};
  CarvedGridOptions options{.cell_m = 0.01, .mode = CarvedGridMode::deferred};
  const auto method = mapped<CarvedGrid>(readings, options);
  const double theta_left = degrees(12.5).rad() + std::asin(0.05);
  const double amplitude = 0.35 + 0.10 * degrees(25.0).rad() / (4.0 * theta_left);
  EXPECT_NEAR(log_odds_at(method, {-0.4, 1.96}), log_odds(0.5 + amplitude), 0.15);  // a cell is not quite at its range
  EXPECT_LT(log_odds_at(method, {0.15, 1.94}), 0.0F) << "carved: free";
  EXPECT_EQ(method.tallies()[0].count, 1U);
}

TEST(CarvedGrid, DeferredRemovedArcsOnlyClear) {
  std::vector<Reading> readings{up_from({0, 0}, 2.0)};
  CarvedGridOptions options{.cell_m = 0.02, .mode = CarvedGridMode::deferred};
  EXPECT_GT(log_odds_at(mapped<CarvedGrid>(readings, options), {0, 2.0}), 0.0F);
  readings.push_back(up_from({0, -0.001}, 3.0));
  readings.back().beam_width = degrees(30.0);
  const auto method = mapped<CarvedGrid>(readings, options);
  EXPECT_EQ(method.tallies()[1].count, 1U);
  EXPECT_LT(log_odds_at(method, {0, 2.0}), 0.0F);
  EXPECT_NEAR(log_odds_at(method, {0, 1.0}), 2.0F * log_odds_at(method, {0, 2.5}), 0.05) << "both have cleared here";
}

TEST(CarvedGrid, ProfileFollowsTheCarvedArcs) {
  // Along a specular wall, driving in +x, the newer reading always takes the right half of the older arc.
  std::vector<Reading> readings;
  for (int k = 0; k < 30; ++k) readings.push_back(up_from({0.05 * k, 0.0}, 2.0));
  const auto method = mapped<CarvedGrid>(readings, {.cell_m = 0.01});
  const Trace trace = method.trace(up_from({0.05 * 30, 0.0}, 2.0));
  double left = 0.0;
  double right = 0.0;
  for (const CellChange& change : trace.cells) {
    if (change.terms[1].value <= 0.0) continue;
    (change.centre.x < 1.5 ? left : right) += change.terms[1].value;
  }
  EXPECT_GT(left, 4.0 * right) << "limits measured from the axis: [-0.7, 12.5] degrees, left is positive";
}

TEST(CarvedGrid, HostileHistoriesAndRanges) {
  Rng rng(2);
  std::vector<Reading> readings = test::random_readings(rng, 60);
  for (const double range_m : {0.0, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    readings.push_back(readings[0]);
    readings.back().outcome = Echo{range_m};
  }
  readings.push_back(readings[0]);
  readings.back().T_world_tx.position.x = readings.back().T_world_rx.position.x = 1e9;
  for (const CarvedGridMode mode : {CarvedGridMode::sensor_profile, CarvedGridMode::deferred})
    for (const int history : {0, 1, 1'000'000}) {
      const auto method = mapped<CarvedGrid>(readings, {.max_memory_mib = 64, .mode = mode, .history = history});
      const InsertCounters& c = method.counters();
      EXPECT_EQ(c.used + c.no_information + c.no_arc + c.memory_limit, readings.size());
      EXPECT_GE(c.no_arc, 3U);
      EXPECT_GE(c.memory_limit, 2U);
    }
}

TEST(CarvedGrid, DamagedStatesAreRefused) {
  Rng rng(3);
  const std::vector<Reading> readings = test::random_readings(rng, 12);
  for (const CarvedGridMode mode : {CarvedGridMode::sensor_profile, CarvedGridMode::deferred}) {
    const auto bytes = mapped<CarvedGrid>(readings, {.cell_m = 0.5, .max_memory_mib = 4, .mode = mode}).save();
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16)
      EXPECT_FALSE(CarvedGrid::restore(std::span(bytes).first(size))) << size;
    for (int k = 0; k < 600; ++k) {
      std::vector<std::byte> damaged = bytes;
      damaged[rng.below(std::min<std::size_t>(damaged.size(), 4'000))] = std::byte(rng.below(256));
      if (Result<CarvedGrid> method = CarvedGrid::restore(damaged)) {
        InlineExecutor here;
        method->insert(readings, here);
        method->finish(here);
      }
    }
  }
}

}  // namespace
}  // namespace echoarc
