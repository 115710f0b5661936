// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The whole way of a log in memory to a finished map, for every method of the catalogue with its defaults, on a drive
// along a corridor.

#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "bench/workload.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/pipeline/pipeline.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

void run_method(benchmark::State& state, const MethodEntry& entry, const Log& log) {
  InlineExecutor executor;
  for (auto _ : state) {
    std::vector<AnyMethod> methods;
    methods.push_back(make_method(entry.name).value());
    const LogRun run = run_log(log, {}, methods, executor);
    consume(run);
  }
  state.counters["us_per_ping"] = benchmark::Counter(
      1e-6 * double(log.pings.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

int main(int argc, char** argv) {
  const Log log =
      make_workload_log({.scene = corridor(), .readings = 10'000, .loop_half_x_m = 17.0, .loop_half_y_m = 0.3});
  for (const MethodEntry& entry : catalog())
    benchmark::RegisterBenchmark(("pipeline/" + std::string(entry.name)).c_str(), [&](benchmark::State& state) {
      run_method(state, entry, log);
    })->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
