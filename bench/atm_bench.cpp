// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Arc-transversal median: a room in one batch, circular and mixed with elliptical arcs, and time per arc and bytes per
// arc along an ever longer corridor.

#include <cmath>

#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "bench/workload.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/mapping/atm.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

/// 700 arcs of the front sensors of a robot that follows the walls of a room of 525 x 525 cells of 1 cm, a stop every
/// 2.5 cm ([Barshan07] 5.1: 697 arcs). With `bistatic` neighbouring
/// sensors hear each other's echoes, which makes four of seven arcs elliptical.
std::vector<Reading> room(bool bistatic) {
  Rng rng(3);
  const Scene scene = chamber();
  std::vector<Reading> readings;
  const Vec2 middle = 0.5 * scene.size;
  for (int stop = 0; readings.size() < 700; ++stop) {
    const double way_m = 0.025 * stop;  // along a square 0.7 m inside the walls
    const double side_m = scene.size.x - 1.4;
    const int side = int(way_m / side_m) % 4;
    const Angle heading = degrees(90.0 * side);
    const Vec2 start = middle + rotate({-0.5 * side_m, -0.5 * side_m}, heading);
    const Pose2 T_world_robot{start + std::fmod(way_m, side_m) * unit(heading), heading};
    const auto sensor = [&](int k) {
      const Angle yaw = degrees(-90.0 + 22.5 * k);
      return T_world_robot * Pose2{0.23 * unit(yaw), yaw};
    };
    for (int tx = -1; tx <= 1; ++tx)
      for (int rx = -1; rx <= 1; ++rx) {
        if (tx != rx && (!bistatic || (tx + rx) % 2 == 0)) continue;  // neighbours hear each other
        Reading r;
        r.ping = readings.size();
        r.time_s = 0.12 * stop;
        r.tx = SensorId(tx + 1);
        r.rx = SensorId(rx + 1);
        r.T_world_robot = T_world_robot;
        r.T_world_tx = sensor(tx);
        r.T_world_rx = sensor(rx);
        const double there = nearest_surface_m(scene, r.T_world_tx, r.beam_width);
        const double back = nearest_surface_m(scene, r.T_world_rx, r.beam_width);
        r.outcome = Echo{0.5 * (there + back) + rng.normal(0.0, 0.005)};
        readings.push_back(r);
      }
  }
  readings.resize(700);
  return readings;
}

void atm_room(benchmark::State& state, bool bistatic) {
  const std::vector<Reading> readings = room(bistatic);
  AtmMod::Options options;
  options.theta_t = degrees(5.0);  // [Barshan07] 4.3 for rooms
  InlineExecutor executor;
  std::size_t points = 0;
  for (auto _ : state) {
    AtmMod method(options);
    method.insert(readings, executor);
    method.finish(executor);
    points = method.map().size();
    consume(method.map());
  }
  std::size_t elliptical = 0;
  for (const Reading& r : readings) elliptical += r.monostatic() ? 0 : 1;
  state.counters["arcs"] = double(readings.size());
  state.counters["elliptical"] = double(elliptical);
  state.counters["points"] = double(points);
}
BENCHMARK_CAPTURE(atm_room, circular, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(atm_room, half_elliptical, true)->Unit(benchmark::kMillisecond);

/// A straight drive along a corridor without end: a sweep of 16 sonars every 0.25 m between walls 1.2 m away, so that
/// the density of arcs is the same at every length.
std::vector<Reading> straight_drive(std::size_t count) {
  constexpr double sweep_m = 0.25;
  Rng rng(4);
  std::vector<Reading> readings(count);
  for (std::size_t k = 0; k < count; ++k) {
    Reading& r = readings[k];
    r.ping = k;
    r.time_s = 0.04 * double(k);
    r.tx = r.rx = SensorId(k % 16);
    r.T_world_robot = {{sweep_m * double(k / 16), rng.uniform(-0.01, 0.01)}, Angle{}};
    const Angle yaw = degrees(22.5 * double(k % 16));
    r.T_world_tx = r.T_world_rx = r.T_world_robot * Pose2{0.23 * unit(yaw), yaw};
    const double slant = std::abs(std::sin(yaw.rad()));
    r.outcome = Echo{(slant > 0.3 ? 1.2 / slant - 0.23 : 3.0) + rng.normal(0.0, 0.01)};
  }
  return readings;
}

void atm_corridor(benchmark::State& state) {
  const std::vector<Reading> readings = straight_drive(std::size_t(state.range(0)));
  AtmMod::Options options;
  options.max_memory_mib = 8192;
  InlineExecutor executor;
  std::size_t bytes = 0;
  for (auto _ : state) {
    AtmMod method(options);
    method.insert(readings, executor);
    method.finish(executor);
    bytes = method.memory_bytes();
    consume(method.map());
  }
  const double arcs = double(readings.size());
  state.counters["us_per_arc"] =
      benchmark::Counter(1e-6 * arcs, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["bytes_per_arc"] = double(bytes) / arcs;
}
BENCHMARK(atm_corridor)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);

/// The on-line form with so many arcs in total, on the same corridor: time per reading.
void atm_ring(benchmark::State& state) {
  const std::vector<Reading> readings = straight_drive(20'000);
  AtmSilver::Options options;
  options.history_arcs = int(state.range(0));
  options.archive = false;
  InlineExecutor executor;
  AtmSilver method(options);
  for (auto _ : state) method.insert(readings, executor);
  state.counters["us_per_ping"] = benchmark::Counter(
      1e-6 * double(readings.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(atm_ring)->Arg(250)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
