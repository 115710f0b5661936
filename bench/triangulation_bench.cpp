// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Triangulation-based fusion: 16 sonars x 10 columns, one every 5 cm of the drive.

#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "bench/workload.hpp"
#include "echoarc/mapping/triangulation_fusion.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

/// Sweeps of the ring along the hall, 5 cm apart, every reading an echo at its reach, all nearer than the method's 5 m.
std::vector<Reading> sweeps(std::size_t count) {
  std::vector<Reading> readings = make_workload({.readings = count, .range_max_m = 5.0});
  Vec2 robot;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    // The drive of the workload is denser than the window's columns: every sweep is shifted to its place.
    Reading& reading = readings[k];
    if (k % 16 == 0) robot = {0.05 * double(k / 16), 0.0};
    const Vec2 shift = robot - reading.T_world_robot.position;
    reading.T_world_robot.position = robot;
    reading.T_world_tx.position = reading.T_world_tx.position + shift;
    reading.T_world_rx = reading.T_world_tx;
    reading.outcome = Echo{reach_m(reading)};
  }
  return readings;
}

void triangulation_fusion(benchmark::State& state) {
  const std::vector<Reading> readings = sweeps(16'000);
  InlineExecutor executor;
  std::uint64_t used = 0;
  for (auto _ : state) {
    TriangulationFusion method({.rows = 16, .columns = 10, .column_m = 0.05});
    method.insert(readings, executor);
    used = method.counters().used;
    benchmark::DoNotOptimize(method.map().size());
  }
  state.counters["us_per_arc"] = benchmark::Counter(
      1e-6 * double(used), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["used_share"] = double(used) / double(readings.size());
}
BENCHMARK(triangulation_fusion)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
