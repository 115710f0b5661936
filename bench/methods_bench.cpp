// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Methods that count arcs or mark cells, and the passes over their maps.

#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "bench/workload.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/mapping/directional_maximum.hpp"
#include "echoarc/mapping/himm.hpp"
#include "echoarc/mapping/morphological_processing.hpp"
#include "echoarc/mapping/voting.hpp"
#include "echoarc/maps/arc_raster.hpp"
#include "echoarc/maps/bit_plane.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

/// The drive with every reading an echo at its reach: arcs with the mean range of the workload, 3.7 m.
std::vector<Reading> arcs_only(const WorkloadOptions& options) {
  std::vector<Reading> readings = make_workload(options);
  for (Reading& reading : readings) reading.outcome = Echo{reach_m(reading)};
  return readings;
}

void count_arcs(benchmark::State& state, std::size_t arcs) {
  state.counters["us_per_arc"] = benchmark::Counter(
      1e-6 * double(arcs), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// One arc of the arc map at 1 cm, from reading to counted cells.
void voting(benchmark::State& state) {
  const std::vector<Reading> readings = arcs_only({.readings = 20'000});
  Voting method({.cell_m = 0.01});
  InlineExecutor executor;
  for (auto _ : state) {
    method.insert(readings, executor);
    consume(method.map());
  }
  count_arcs(state, readings.size());
}
BENCHMARK(voting)->Unit(benchmark::kMillisecond);

/// The same arcs added to a dense grid of floats: what rasterising and touching the cells costs at least.
void voting_floor(benchmark::State& state) {
  const std::vector<Reading> readings = arcs_only({.readings = 20'000});
  const DenseArea area = workload_area(0.01);
  DenseGrid<float> grid(area.geometry, area.width, area.height);
  ArcRaster raster(area.geometry);
  double cells = 0.0;
  for (auto _ : state) {
    for (const Reading& reading : readings)
      for (const Cell& cell : raster.cells(*arc_of(reading))) grid.at(cell) += 1.0F;
    consume(grid);
  }
  for (const Reading& reading : readings) cells += double(raster.cells(*arc_of(reading)).size());
  count_arcs(state, readings.size());
  state.counters["cells_per_arc"] = cells / double(readings.size());
}
BENCHMARK(voting_floor)->Unit(benchmark::kMillisecond);

/// 700 arcs in a room of 525 x 525 cells of 1 cm: from an empty method to the exported map.
void directional_maximum(benchmark::State& state, DirectionOfInterest doi) {
  const WorkloadOptions drive{.scene = chamber(), .readings = 700, .loop_half_x_m = 1.4, .loop_half_y_m = 1.4};
  const std::vector<Reading> readings = arcs_only(drive);
  InlineExecutor executor;
  for (auto _ : state) {
    DirectionalMaximum method({.cell_m = 0.01, .doi = doi});
    method.insert(readings, executor);
    method.finish(executor);
    consume(method.map());
  }
}
BENCHMARK_CAPTURE(directional_maximum, automatic, DirectionOfInterest::automatic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(directional_maximum, axis, DirectionOfInterest::axis)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(directional_maximum, followed_wall, DirectionOfInterest::followed_wall)
    ->Unit(benchmark::kMillisecond);

/// One pass of morphological processing over 525 x 525 cells.
void thinning(benchmark::State& state) {
  constexpr std::int32_t size = 525;
  BitPlane plane(size, size);
  Rng rng(1);
  for (std::int32_t j = 0; j < size; ++j)
    for (std::int32_t i = 0; i < size; ++i) plane.set({i, j}, rng.uniform() < 0.5);
  BitPlane out(size, size);
  for (auto _ : state) {
    plane.thin_into(7, out);
    consume(out);
  }
}
BENCHMARK(thinning)->Unit(benchmark::kMicrosecond);

/// A float add over as many cells: the floor.
void thinning_floor(benchmark::State& state) {
  DenseGrid<float> grid({}, 525, 525);
  for (auto _ : state) {
    for (float& value : grid.values()) value += 1.0F;
    consume(grid);
  }
}
BENCHMARK(thinning_floor)->Unit(benchmark::kMicrosecond);

/// From readings to the exported state of mapping 700 arcs, thinning included.
void morphological_processing(benchmark::State& state) {
  const WorkloadOptions drive{.scene = chamber(), .readings = 700, .loop_half_x_m = 1.4, .loop_half_y_m = 1.4};
  const std::vector<Reading> readings = arcs_only(drive);
  InlineExecutor executor;
  for (auto _ : state) {
    MorphologicalProcessing method;
    method.insert(readings, executor);
    method.finish(executor);
    consume(method.map());
  }
}
BENCHMARK(morphological_processing)->Unit(benchmark::kMillisecond);

/// One reading of histogramic in-motion mapping, cells of 10 cm.
void histogramic(benchmark::State& state) {
  const std::vector<Reading> readings = make_workload({.readings = 20'000});
  Himm method;
  InlineExecutor executor;
  for (auto _ : state) {
    method.insert(readings, executor);
    consume(method.map());
  }
  count_arcs(state, readings.size());
}
BENCHMARK(histogramic)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
