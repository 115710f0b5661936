// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/pipeline/pipeline.hpp"

#include <algorithm>
#include <mutex>
#include <thread>
#include <utility>

namespace echoarc {
namespace {

/// Asking the host and telling it costs little, but not nothing: once in so many pings.
constexpr std::size_t host_interval = 256;

/// Passes tasks on and adds up the CPU time of those that ran on other threads than the one that asked.
class MeteredExecutor final : public Executor {
 public:
  MeteredExecutor(Executor& inner, const std::function<double()>& clock) : inner_(inner), clock_(clock) {}

  [[nodiscard]] std::size_t concurrency() const override { return inner_.concurrency(); }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    const std::thread::id asking = std::this_thread::get_id();
    inner_.run(count, [&](std::size_t i) {
      if (std::this_thread::get_id() == asking) return task(i);
      const double begin_s = clock_();
      task(i);
      const double spent_s = clock_() - begin_s;
      const std::lock_guard lock(mutex_);
      elsewhere_s_ += spent_s;
    });
  }
  [[nodiscard]] double elsewhere_s() const { return elsewhere_s_; }

 private:
  Executor& inner_;
  const std::function<double()>& clock_;
  std::mutex mutex_;
  double elsewhere_s_ = 0.0;
};

/// CPU time of `work`, on whatever threads of `executor` it runs; 0 without a clock.
double timed(const std::function<double()>& clock, Executor& executor, const std::function<void(Executor&)>& work) {
  if (!clock) {
    work(executor);
    return 0.0;
  }
  MeteredExecutor metered(executor, clock);
  const double begin_s = clock();
  work(metered);
  return clock() - begin_s + metered.elsewhere_s();
}

}  // namespace

Pipeline::Pipeline(Sensing sensing, std::span<AnyMethod> methods, Executor& executor, PipelineHost host,
                   std::size_t batch_readings)
    : sensing_(std::move(sensing)),
      methods_(methods),
      executor_(&executor),
      host_(std::move(host)),
      batch_readings_(std::max<std::size_t>(batch_readings, 1)),
      costs_(methods.size()) {}

void Pipeline::push(const Odometry& sample) {
  sensing_.push(sample);
  if (sensing_.readings().size() >= batch_readings_) insert_ready();
}

void Pipeline::push(const WallNote& note) {
  sensing_.push(note);
}

void Pipeline::push(const Scan& scan) {
  sensing_.push(scan);
}

void Pipeline::push(const Ping& ping) {
  sensing_.push(ping);
  if (sensing_.readings().size() >= batch_readings_) insert_ready();
}

void Pipeline::push(const Poll& poll) {
  sensing_.push(poll);
  if (sensing_.readings().size() >= batch_readings_) insert_ready();
}

void Pipeline::end_of_polls() {
  sensing_.end_of_polls();
}

void Pipeline::end_of_odometry() {
  sensing_.end_of_odometry();
}

void Pipeline::flush() {
  insert_ready();
  for_each_method(&MethodCost::finish_cpu_s, [](AnyMethod& method, Executor& executor) { method.finish(executor); });
}

void Pipeline::insert_ready() {
  const std::span<const Reading> readings = sensing_.readings();
  if (readings.empty()) return;
  if (host_.readings) host_.readings(readings);
  for_each_method(&MethodCost::insert_cpu_s, [&](AnyMethod& method, Executor& executor) {
    method.insert(method.takes_laser_limited() ? sensing_.limited_readings() : readings, executor);
  });
  sensing_.clear_readings();
}

void Pipeline::for_each_method(double MethodCost::* cost, const std::function<void(AnyMethod&, Executor&)>& work) {
  if (methods_.size() == 1) {
    costs_[0].*cost += timed(host_.thread_cpu_s, *executor_, [&](Executor& all) { work(methods_[0], all); });
    return;
  }
  // Several methods share the threads among them; each stays on one thread, so that its CPU time is its own.
  executor_->run(methods_.size(), [&](std::size_t i) {
    InlineExecutor alone;
    costs_[i].*cost += timed(host_.thread_cpu_s, alone, [&](Executor& one) { work(methods_[i], one); });
  });
}

LogRun run_log(const Log& log, const SensingOptions& options, std::span<AnyMethod> methods, Executor& executor,
               const PipelineHost& host, std::size_t batch_readings) {
  const bool limited = std::ranges::any_of(methods, &AnyMethod::takes_laser_limited);
  Pipeline pipeline(sensing_for(log, options, limited), methods, executor, host, batch_readings);
  bool cancelled = false;
  const auto push_all = [&](const auto& records) {
    for (std::size_t i = 0; i < records.size() && !cancelled; ++i) {
      pipeline.push(records[i]);
      if (i % host_interval != 0) continue;
      if (host.progress) host.progress(static_cast<double>(i) / static_cast<double>(records.size()));
      cancelled = host.cancelled && host.cancelled();
    }
  };
  push_all(log.pings);
  if (log.pings.empty()) push_all(log.polls);
  pipeline.end_of_polls();
  pipeline.flush();
  if (host.progress && !cancelled) host.progress(1.0);
  const std::span<const Odometry> path = pipeline.path();
  const std::span<const MethodCost> costs = pipeline.costs();
  return {pipeline.report(), {path.begin(), path.end()}, {costs.begin(), costs.end()}, cancelled};
}

std::vector<PingId> supporting_pings(const AnyMethod& method, std::span<const Reading> readings, Vec2 position) {
  std::vector<PingId> pings;
  for (const Reading& reading : readings)
    if (method.supports(reading, position)) pings.push_back(reading.ping);
  return pings;
}

}  // namespace echoarc
