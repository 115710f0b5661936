// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Tangent consensus under input that no honest drive gives.

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/consensus.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

using test::monostatic_reading;

Consensus mapped(const std::vector<Reading>& readings, const ConsensusOptions& options = {}) {
  Consensus method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

TEST(ConsensusHostile, StandingStillSaysOneThingOnce) {
  const std::vector<Reading> readings(5000, monostatic_reading({{1.0, 2.0}, degrees(30.0)}, Echo{1.5}));
  const Consensus method = mapped(readings);
  EXPECT_EQ(method.counters().used, 1U);
  EXPECT_EQ(method.counters().passed_over, 4999U);
  EXPECT_TRUE(method.map().empty()) << "an arc that no other supports is not shown";
}

/// On the spot, all arcs have one centre: those of a round room are everywhere tangent to one another.
TEST(ConsensusHostile, SpinningInARoundRoomGivesTheRoom) {
  std::vector<Reading> readings;
  for (int k = 0; k < 360; ++k) readings.push_back(monostatic_reading({{1.0, 2.0}, degrees(1.0 * k)}, Echo{1.5}));
  for (std::size_t k = 0; k < readings.size(); ++k) readings[k].ping = k;
  const Consensus method = mapped(readings);
  for (const MapPoint& point : method.map().points()) EXPECT_NEAR(norm(point.position - Vec2{1.0, 2.0}), 1.5, 0.05);
}

TEST(ConsensusHostile, NumbersThatAreNoneAreCounted) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Rng rng(2);
  std::vector<Reading> readings = test::wall_drive(rng, 10);
  const std::size_t honest = mapped(readings).counters().used;
  const std::size_t before = readings.size();
  for (const double range_m : {nan, 0.0, -1.0}) readings.push_back(monostatic_reading({}, Echo{range_m}));
  for (const double x : {nan, inf, 1e300}) readings.push_back(monostatic_reading({{x, 0.0}, Angle{}}, Echo{1.0}));
  for (const Angle beam : {Angle{}, degrees(-20.0), degrees(180.0), radians(nan)})
    readings.push_back(monostatic_reading({}, Echo{1.0}, beam));
  readings.push_back(monostatic_reading({{0.0, 0.0}, radians(nan)}, Echo{1.0}));
  const Consensus method = mapped(readings);
  EXPECT_EQ(method.counters().used, honest);
  EXPECT_EQ(method.counters().no_arc, readings.size() - before);
  for (const MapPoint& point : method.map().points()) EXPECT_TRUE(is_finite(point.position));
  EXPECT_EQ(mapped({monostatic_reading({}, Echo{inf})}).counters().passed_over, 1U);
}

TEST(ConsensusHostile, ArcsFarApartAreNoNeighbours) {
  std::vector<Reading> readings;
  for (int k = 0; k < 200; ++k)
    readings.push_back(monostatic_reading({{1e9 * k, -3e10 * k}, degrees(7.0 * k)}, Echo{1.0}));
  EXPECT_TRUE(mapped(readings).map().empty());
}

TEST(ConsensusHostile, TheWidestAndNarrowestBeamsAndOptions) {
  Rng rng(4);
  std::vector<Reading> readings = test::wall_drive(rng, 6);
  for (std::size_t k = 0; k < readings.size(); ++k)
    readings[k].beam_width = degrees(k % 3 == 0 ? 0.001 : k % 3 == 1 ? 179.0 : 30.0);
  ConsensusOptions fine;
  fine.step = degrees(0.25);
  fine.search_beams = 4.0;
  ConsensusOptions coarse;
  coarse.step = degrees(10.0);
  coarse.neighbours = 1;
  coarse.facing = 0.99;
  coarse.clutter_m = 100.0;
  coarse.range_sigma_m = 0.005;
  for (const ConsensusOptions& options : {fine, coarse}) {
    const PointMap map = mapped(readings, options).map();
    for (const MapPoint& point : map.points()) EXPECT_TRUE(is_finite(point.position));
  }
}

TEST(ConsensusHostile, DamagedStatesAreRefused) {
  Rng rng(5);
  const std::vector<std::byte> bytes = mapped(test::wall_drive(rng, 4)).save();
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_FALSE(Consensus::restore(std::span(bytes).first(size))) << size;
  for (std::size_t k = 0; k < bytes.size(); k += 61) {
    std::vector<std::byte> damaged = bytes;
    damaged[k] ^= std::byte{0xff};
    const Result<Consensus> method = Consensus::restore(damaged);
    if (!method) continue;
    for (const MapPoint& point : method->map().points()) EXPECT_TRUE(is_finite(point.position));
  }
}

}  // namespace
}  // namespace echoarc
