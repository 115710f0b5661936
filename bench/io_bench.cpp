// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Reading logs from memory, so that no disk is measured.

#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/measure.hpp"
#include "bench/workload.hpp"
#include "echoarc/io/jsonl.hpp"

namespace {

using namespace echoarc;
using namespace echoarc::bench;

std::string jsonl_of(const Log& log) {
  io::StringSink sink;
  if (!io::write_jsonl(log, sink)) std::abort();  // the workload holds finite numbers alone
  return sink.text();
}

void read_jsonl(benchmark::State& state) {
  const std::string text = jsonl_of(make_workload_log());
  for (auto _ : state) {
    io::MemorySource source(text);
    const auto log = io::read_jsonl(source);
    if (!log) state.SkipWithError(log.error().message.c_str());
    consume(log);
  }
  state.SetBytesProcessed(std::int64_t(text.size()) * std::int64_t(state.iterations()));
}
BENCHMARK(read_jsonl)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
