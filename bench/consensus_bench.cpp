// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Tangent consensus along a corridor as dense as a recorded one: readings a second in one batch, at several numbers of
// neighbours, and with the map brought up to date again and again.

#include <benchmark/benchmark.h>

#include "bench/corridor.hpp"
#include "bench/measure.hpp"
#include "echoarc/mapping/consensus.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

void count(benchmark::State& state, const Consensus& method, std::size_t readings) {
  state.counters["readings_per_s"] =
      benchmark::Counter(double(readings), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["arcs"] = double(method.counters().used);
  state.counters["points"] = double(method.map().size());
  state.counters["bytes"] = double(method.memory_bytes());
}

void consensus_batch(benchmark::State& state, ConsensusMode mode, int neighbours) {
  const std::vector<Reading> readings = corridor_echoes(3000);
  Consensus::Options options;
  options.mode = mode;
  options.neighbours = neighbours;
  InlineExecutor executor;
  Consensus method(options);
  for (auto _ : state) {
    method = Consensus(options);
    method.insert(readings, executor);
    method.finish(executor);
    consume(method.map());
  }
  count(state, method, readings.size());
}
BENCHMARK_CAPTURE(consensus_batch, balanced, ConsensusMode::balanced, 96)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(consensus_batch, balanced_48, ConsensusMode::balanced, 48)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(consensus_batch, complete, ConsensusMode::complete, 96)->Unit(benchmark::kMillisecond);

/// The map brought up to date after every so many readings.
void consensus_steps(benchmark::State& state) {
  const std::vector<Reading> readings = corridor_echoes(3000);
  const auto step = std::size_t(state.range(0));
  InlineExecutor executor;
  Consensus method;
  for (auto _ : state) {
    method = Consensus();
    for (std::size_t k = 0; k < readings.size(); k += step) {
      method.insert(std::span(readings).subspan(k, std::min(step, readings.size() - k)), executor);
      method.finish(executor);
    }
    consume(method.map());
  }
  count(state, method, readings.size());
}
BENCHMARK(consensus_steps)->Arg(8)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

/// Readings a second and memory as the way grows.
void consensus_way(benchmark::State& state) {
  const std::vector<Reading> readings = corridor_echoes(std::size_t(state.range(0)));
  InlineExecutor executor;
  Consensus method;
  for (auto _ : state) {
    method = Consensus();
    method.insert(readings, executor);
    method.finish(executor);
    consume(method.map());
  }
  count(state, method, readings.size());
}
BENCHMARK(consensus_way)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)->Iterations(1);

/// The same with the map brought up to date every 100 readings.
void consensus_way_on_line(benchmark::State& state) {
  const std::vector<Reading> readings = corridor_echoes(std::size_t(state.range(0)));
  constexpr std::size_t step = 100;
  InlineExecutor executor;
  Consensus method;
  for (auto _ : state) {
    method = Consensus();
    for (std::size_t k = 0; k < readings.size(); k += step) {
      method.insert(std::span(readings).subspan(k, std::min(step, readings.size() - k)), executor);
      method.finish(executor);
    }
    consume(method.map());
  }
  count(state, method, readings.size());
}
BENCHMARK(consensus_way_on_line)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
