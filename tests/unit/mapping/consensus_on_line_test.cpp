// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Tangent consensus with the map brought up to date again and again.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/consensus.hpp"
#include "support/random_readings.hpp"
#include "support/test_threads.hpp"

namespace echoarc {
namespace {

/// A drive round and round a square room of 4 m: eight sensors, 45 degrees apart, each hears the nearest wall that its
/// beam meets, with 1 cm of noise; every twentieth echo comes from somewhere else.
std::vector<Reading> room(std::uint64_t seed, int stops) {
  constexpr double half_m = 2.0;
  Rng rng(seed);
  std::vector<Reading> readings;
  for (int stop = 0; stop < stops; ++stop)
    for (int k = 0; k < 8; ++k) {
      const Angle round = degrees(1.31 * stop);
      Reading reading;
      reading.ping = readings.size();
      reading.time_s = 0.1 * stop;
      reading.tx = reading.rx = SensorId(k);
      reading.T_world_robot = {(0.7 + 0.1 * cos(3.0 * round)) * unit(round), round + degrees(90.0)};
      const Angle yaw = degrees(45.0 * k);
      reading.T_world_tx = reading.T_world_rx = reading.T_world_robot * Pose2{0.15 * unit(yaw), yaw};
      double nearest_m = 10.0;
      for (int ray = -10; ray <= 10; ++ray) {
        const Vec2 p = reading.T_world_tx.position;
        const Vec2 u = unit(reading.T_world_tx.heading + degrees(1.0 * ray));
        if (u.x != 0.0) nearest_m = std::min(nearest_m, (std::copysign(half_m, u.x) - p.x) / u.x);
        if (u.y != 0.0) nearest_m = std::min(nearest_m, (std::copysign(half_m, u.y) - p.y) / u.y);
      }
      const bool lost = rng.below(20) == 0;
      reading.outcome = Echo{lost ? rng.uniform(0.3, 3.0) : nearest_m + rng.normal(0.0, 0.01)};
      readings.push_back(reading);
    }
  return readings;
}

/// Share of the points within 10 cm of the room's walls, and share of the walls with a point that near.
struct RoomScore {
  double accuracy = 0.0;
  double coverage = 0.0;
};
RoomScore score_of(const PointMap& map) {
  const auto off_wall_m = [](Vec2 p) { return std::abs(std::max(std::abs(p.x), std::abs(p.y)) - 2.0); };
  RoomScore score;
  for (const MapPoint& point : map.points())
    score.accuracy += (off_wall_m(point.position) < 0.1 ? 1.0 : 0.0) / double(map.size());
  int found = 0;
  int places = 0;
  for (int side = 0; side < 4; ++side)
    for (double along = -1.975; along < 2.0; along += 0.05) {
      const Vec2 wall = Pose2{{}, degrees(90.0 * side)} * Vec2{2.0, along};
      ++places;
      found += std::ranges::any_of(map.points(), [&](const MapPoint& p) { return norm(p.position - wall) < 0.1; });
    }
  score.coverage = double(found) / places;
  return score;
}

void insert_in_steps(Consensus& method, std::span<const Reading> readings, std::size_t step) {
  InlineExecutor executor;
  for (std::size_t k = 0; k < readings.size(); k += step) {
    method.insert(readings.subspan(k, std::min(step, readings.size() - k)), executor);
    method.finish(executor);
  }
}

Consensus in_steps(std::span<const Reading> readings, std::size_t step, const ConsensusOptions& options = {}) {
  Consensus method(options);
  insert_in_steps(method, readings, step);
  return method;
}

void expect_same(const PointMap& a, const PointMap& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::ranges::equal(a.segments(), b.segments()));
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a.points()[k].position, b.points()[k].position);
    EXPECT_EQ(a.points()[k].label, b.points()[k].label);
    EXPECT_EQ(a.beliefs()[k], b.beliefs()[k]);
    EXPECT_TRUE(std::ranges::equal(a.support(a.points()[k]), b.support(b.points()[k])));
  }
}

/// Small histories, so that little is much.
ConsensusOptions small(ConsensusMode mode = ConsensusMode::balanced) {
  ConsensusOptions options;
  options.mode = mode;
  options.history = 60;
  options.neighbours = 24;
  options.renew_arcs = 50;
  options.vote_arcs = 200;
  return options;
}

TEST(ConsensusOnLine, FinishWithoutReadingsGivesTheMapOfOneBatch) {
  InlineExecutor executor;
  for (const ConsensusMode mode : {ConsensusMode::strict, ConsensusMode::balanced, ConsensusMode::complete})
    for (const std::size_t step : {1, 8, 100}) {
      const std::vector<Reading> readings = room(step, 60);
      Consensus method = in_steps(readings, step, small(mode));
      method.finish(executor);
      expect_same(method.map(), in_steps(readings, readings.size(), small(mode)).map());
      method.finish(executor);
      expect_same(method.map(), in_steps(readings, readings.size(), small(mode)).map());
    }
}

TEST(ConsensusOnLine, RoomsAreNearlyThoseOfOneBatch) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<Reading> readings = room(seed, 200);
    const RoomScore batch = score_of(in_steps(readings, readings.size()).map());
    const RoomScore on_line = score_of(in_steps(readings, 8).map());
    EXPECT_GT(batch.accuracy, 0.9);
    EXPECT_GT(batch.coverage, 0.7);
    EXPECT_NEAR(on_line.accuracy, batch.accuracy, 0.05);
    EXPECT_NEAR(on_line.coverage, batch.coverage, 0.05);
  }
}

/// Arcs so far apart that they make no points: what is left is what the method remembers.
TEST(ConsensusOnLine, MemoryIsBoundedByTheWindow) {
  ConsensusOptions options = small();
  options.window_arcs = 1000;
  InlineExecutor executor;
  for (const std::size_t step : {50, 100'000}) {
    Consensus method(options);
    std::size_t most = 0;
    for (int k = 0; k < 6000; ++k) {
      const Reading reading = test::monostatic_reading({{7.0 * k, -4.0 * k}, degrees(7.0 * k)}, Echo{1.0});
      method.insert(std::span(&reading, 1), executor);
      if ((std::size_t(k) + 1) % step == 0) method.finish(executor);
      if (k == 1998) most = method.memory_bytes();
      if (k > 1999) {
        EXPECT_LE(method.memory_bytes(), most + 1000);
      }
    }
    EXPECT_EQ(method.counters().used, 6000U);
  }
}

TEST(ConsensusOnLine, PointsOutliveTheirArcs) {
  ConsensusOptions options = small();
  options.window_arcs = 1000;
  for (const std::size_t step : {64, 100'000}) {
    const Consensus method = in_steps(room(5, 600), step, options);
    ASSERT_GT(method.counters().used, 4000U);
    EXPECT_GT(score_of(method.map()).accuracy, 0.7);
    std::vector<PingId> echoes;
    for (const MapPoint& point : method.map().points())
      if (point.label != PointLabel::link && point.label != PointLabel::zone) echoes.push_back(point.ping);
    std::ranges::sort(echoes);
    EXPECT_LT(echoes.front(), 100U);
    EXPECT_GT(echoes.size(), 2500U);
    EXPECT_EQ(std::ranges::adjacent_find(echoes), echoes.end()) << "an arc has one point";
  }
}

TEST(ConsensusOnLine, PortionsOfInsertDoNotMatterBeyondTheWindow) {
  ConsensusOptions options = small();
  options.window_arcs = 1000;
  const std::vector<Reading> readings = room(6, 700);
  Consensus pieces(options);
  InlineExecutor executor;
  for (std::size_t k = 0; k < readings.size(); k += 37)
    pieces.insert(std::span(readings).subspan(k, std::min<std::size_t>(37, readings.size() - k)), executor);
  pieces.finish(executor);
  expect_same(pieces.map(), in_steps(readings, readings.size(), options).map());
}

TEST(ConsensusOnLine, ARestoredMethodGoesOnBeyondTheWindow) {
  ConsensusOptions options = small();
  options.window_arcs = 1000;
  const std::vector<Reading> readings = room(7, 600);
  const auto half = std::span(readings).first(3000);
  Consensus original = in_steps(half, 500, options);
  Result<Consensus> copy = Consensus::restore(original.save());
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->save(), original.save());
  InlineExecutor executor;
  original.finish(executor);
  expect_same(copy->map(), original.map());
  for (Consensus* method : {&original, &*copy}) insert_in_steps(*method, std::span(readings).subspan(3000), 100);
  EXPECT_EQ(copy->save(), original.save());
  expect_same(copy->map(), original.map());
}

TEST(ConsensusOnLine, HostileReadingsOnTheWay) {
  std::vector<Reading> readings = room(8, 60);
  Rng rng(9);
  for (std::size_t k = 0; k < readings.size(); k += 3) {
    Reading& reading = readings[k];
    reading.ping = k % 2 == 0 ? 7 : reading.ping;  // one number for many
    reading.time_s = std::numeric_limits<double>::quiet_NaN();
    reading.beam_width = degrees(rng.uniform(0.001, 170.0));
    if (k % 5 == 0) reading.T_world_robot.position.x = 1e300;
    if (k % 7 == 0) reading = test::random_reading(rng, k);
  }
  for (const int sweeps : {1, 2, 4}) {
    ConsensusOptions options = small(ConsensusMode::complete);
    options.sweeps = sweeps;
    options.renew_arcs = 8;
    options.vote_arcs = 100;
    const PointMap map = in_steps(readings, 5, options).map();
    for (const MapPoint& point : map.points()) EXPECT_TRUE(is_finite(point.position));
  }
}

TEST(ConsensusOnLine, ThreadsDoNotChangeABit) {
  const std::vector<Reading> readings = room(10, 60);
  const PointMap expected = in_steps(readings, 16, small()).map();
  test::TestThreads threads(4);
  Consensus method(small());
  for (std::size_t k = 0; k < readings.size(); k += 16) {
    method.insert(std::span(readings).subspan(k, 16), threads);
    method.finish(threads);
  }
  expect_same(method.map(), expected);
}

}  // namespace
}  // namespace echoarc
