// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "live/mapper_state.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace echoarc::live {

Mapper::State::State(const SourceDescription& described, const SensingOptions& sensing, Executor& threads,
                     std::function<double()> cpu_s)
    : source(described), sensing_options(sensing), executor(&threads), thread_cpu_s(std::move(cpu_s)) {
  open_streams();
}

void Mapper::State::open_streams() {
  plain = std::make_unique<JudgedStream>(source, sensing_options, false);
  // Laser-limited readings wait for the scans around them, so they have a sensing of their own: the others do not.
  const bool beside = !source.robot.lasers.empty() && sensing_options.laser_limit == LaserLimit::none;
  limited = beside ? std::make_unique<JudgedStream>(source, sensing_options, true) : nullptr;
  timeline.clear();
  timed = 0;
  scan.clear();
  truth.clear();
  next_mark_s = -std::numeric_limits<double>::infinity();
}

const JudgedStream& Mapper::State::stream_of(const AnyMethod& method) const {
  return limited && method.takes_laser_limited() ? *limited : *plain;
}

void Mapper::State::after_push() {
  const PoseTrack& track = plain->sensing().track();
  const double newest_s = track.empty() ? source.begin_s : track.newest_s();
  for (; timed < plain->log().size(); ++timed) timeline.add(plain->log()[timed], source.begin_s, newest_s);
  scan.place(track, source.robot.lasers);
  if (track.empty() || track.newest_s() < next_mark_s) return;
  next_mark_s = (std::floor(track.newest_s() / finish_interval_s + 1e-9) + 1.0) * finish_interval_s;
  mark();
}

void Mapper::State::mark() {
  plain->mark();
  if (limited) limited->mark();
  advance_methods();
}

void Mapper::State::advance_methods() {
  constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max() / 2;
  if (entries.size() == 1) return advance_run(0, entries[0].run, no_limit, *executor);
  // Several methods share the threads among them; each stays on one thread, so that its CPU time is its own.
  executor->run(entries.size(), [&](std::size_t k) {
    InlineExecutor alone;
    advance_run(k, entries[k].run, no_limit, alone);
  });
}

void Mapper::State::advance_run(std::size_t k, MethodRun& run, std::size_t limit, Executor& threads) {
  const JudgedStream& stream = stream_of(run.method());
  const double begin_s = thread_cpu_s ? thread_cpu_s() : 0.0;
  run.advance(stream.log(), stream.marks(), limit, threads);
  if (thread_cpu_s) methods[k].insert_cpu_s += thread_cpu_s() - begin_s;
}

Result<MethodRun> Mapper::State::fresh_run(const MethodChoice& choice) const {
  auto method = make_method(choice.name, choice.options);
  if (!method) return method.error();
  return MethodRun(std::move(*method), off);
}

std::optional<std::size_t> Mapper::State::find(std::string_view id) const {
  const auto found = std::ranges::find(methods, id, &RunningMethod::id);
  return found == methods.end() ? std::nullopt : std::optional(std::size_t(found - methods.begin()));
}

void Mapper::State::recompute(std::size_t k) {
  auto run = fresh_run(methods[k].choice);
  if (!run) {  // checked when the choice was made
    methods[k].state = RunningMethod::State::failed;
    methods[k].reason = run.error().message;
    return;
  }
  methods[k].state = RunningMethod::State::recomputing;
  methods[k].reason.clear();
  methods[k].recomputed = 0;
  methods[k].insert_cpu_s = 0.0;
  const std::span<const std::size_t> marks = stream_of(run->method()).marks();
  methods[k].recompute_total = marks.empty() ? 0 : marks.back();
  entries[k].next = std::move(*run);
}

/// True while more is left.
bool Mapper::State::recompute_slice(std::size_t k, std::size_t readings) {
  Entry& entry = entries[k];
  advance_run(k, *entry.next, readings, *executor);
  const std::span<const std::size_t> marks = stream_of(entry.next->method()).marks();
  methods[k].recomputed = entry.next->position();
  methods[k].recompute_total = marks.empty() ? 0 : marks.back();
  if (!entry.next->at_end(marks)) return true;
  entry.run = std::move(*entry.next);
  entry.next.reset();
  entry.exported.reset();
  methods[k].state = RunningMethod::State::ok;
  return false;
}

bool Mapper::State::export_method(std::size_t k) {
  Entry& entry = entries[k];
  RunningMethod& method = methods[k];
  if (entry.exported == entry.run.finishes()) return false;
  if (!entry.exported && entry.run.finishes() == 0 && !method.map) return false;
  entry.exported = entry.run.finishes();
  auto map = entry.run.method().export_map();
  if (!map) {
    method.state = RunningMethod::State::failed;
    method.reason = map.error().message;
    return true;
  }
  method.map = std::make_shared<const MapExport>(std::move(*map));
  method.counters = entry.run.method().counters();
  const ReadingLog& log = plain->log();
  const auto arc_centre_of = [&](PingId ping) -> std::optional<Vec2> {
    const auto place = log.find(ping);
    if (!place || !echo_range_m(log[*place].reading.outcome)) return std::nullopt;
    const Reading& reading = log[*place].reading;
    return 0.5 * (reading.T_world_tx.position + reading.T_world_rx.position);
  };
  method.store.update(*method.map, arc_centre_of, cell_layer_of(method.choice.name, method.choice.options));
  if (method.state == RunningMethod::State::recomputing) return true;
  const std::uint64_t left_out = entry.run.method().counters().memory_limit;
  method.state = left_out > 0 ? RunningMethod::State::failed : RunningMethod::State::ok;
  method.reason = left_out == 0 ? ""
                                : "its map is as large as max_memory_mib allows; " + std::to_string(left_out) +
                                      " readings were left out";
  return true;
}

}  // namespace echoarc::live
