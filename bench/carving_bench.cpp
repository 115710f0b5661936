// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Arc carving, alone and with the arc-transversal median.

#include <benchmark/benchmark.h>

#include "bench/corridor.hpp"
#include "bench/measure.hpp"
#include "echoarc/mapping/carve.hpp"
#include "echoarc/mapping/combined.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

/// Time per reading with a full ring: the first `history` readings are inserted before the clock runs.
template <class Method>
void in_corridor(benchmark::State& state) {
  const auto history = std::size_t(state.range(0));
  constexpr std::size_t timed = 20'000;
  const std::vector<Reading> readings = corridor_echoes(history + timed);
  InlineExecutor executor;
  for (auto _ : state) {
    state.PauseTiming();
    typename Method::Options options;
    options.history = int(history);
    Method method(options);
    method.insert(std::span(readings).first(history), executor);
    state.ResumeTiming();
    method.insert(std::span(readings).subspan(history), executor);
    consume(method.counters());
  }
  state.counters["us_per_reading"] = benchmark::Counter(
      1e-6 * double(timed), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(in_corridor<Combined>)->Name("combined_corridor")->Arg(250)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(in_corridor<Carve>)->Name("carve_corridor")->Arg(250)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
