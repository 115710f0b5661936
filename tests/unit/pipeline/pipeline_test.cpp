// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/pipeline/pipeline.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "unit/pipeline/fold_method.hpp"
#include "unit/sensing/test_logs.hpp"

namespace echoarc {
namespace {

/// Runs every task on a thread of its own, `count` at a time.
class ThreadsExecutor final : public Executor {
 public:
  explicit ThreadsExecutor(std::size_t count) : count_(count) {}
  [[nodiscard]] std::size_t concurrency() const override { return count_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < std::min(count, count_); ++k)
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < count; i = next++) task(i);
      });
    for (std::thread& thread : threads) thread.join();
  }

 private:
  std::size_t count_;
};

std::vector<AnyMethod> folds(int count) {
  std::vector<AnyMethod> methods;
  for (int salt = 1; salt <= count; ++salt) methods.emplace_back(test::Fold({.salt = salt}));
  return methods;
}

/// What the methods hold after the log.
std::vector<std::vector<std::byte>> states_after(const Log& log, int methods_count, Executor& executor,
                                                 std::size_t batch) {
  std::vector<AnyMethod> methods = folds(methods_count);
  (void)run_log(log, {}, methods, executor, {}, batch);
  std::vector<std::vector<std::byte>> states;
  for (const AnyMethod& method : methods) states.push_back(method.save());
  return states;
}

Log small_log() {
  return test::drive(0.0, test::model_of(0.2, 4.0));
}

TEST(Pipeline, BatchesAndThreadsDoNotChangeAByte) {
  const Log log = small_log();
  InlineExecutor alone;
  const auto expected = states_after(log, 3, alone, 4096);
  EXPECT_NE(expected[0], expected[1]) << "methods have states of their own";
  for (const std::size_t batch : {1, 7, 64, 100000}) {
    EXPECT_EQ(states_after(log, 3, alone, batch), expected) << batch;
    for (const std::size_t threads : {2, 8}) {
      ThreadsExecutor executor(threads);
      EXPECT_EQ(states_after(log, 3, executor, batch), expected) << batch << " " << threads;
      EXPECT_EQ(states_after(log, 1, executor, batch)[0], expected[0]) << batch << " " << threads;
    }
  }
}

TEST(Pipeline, EveryMethodGetsEveryReadingOnce) {
  const Log log = small_log();
  const std::vector<Reading> readings = sense(log).readings;
  std::vector<AnyMethod> methods = folds(2);
  InlineExecutor executor;
  const LogRun run = run_log(log, {}, methods, executor, {}, 10);
  EXPECT_FALSE(run.cancelled);
  EXPECT_EQ(run.report.accepted(), readings.size());
  EXPECT_EQ(run.path.size(), log.odometry.size());
  for (const AnyMethod& method : methods) EXPECT_EQ(method.counters().used, readings.size());
}

TEST(Pipeline, StreamingEqualsTheWholeLog) {
  const Log log = small_log();
  InlineExecutor executor;
  const auto expected = states_after(log, 1, executor, 4096);

  std::vector<AnyMethod> methods = folds(1);
  Pipeline pipeline(Sensing(log.robot.sensors), methods, executor, {}, 5);
  std::size_t next = 0;
  for (const Odometry& sample : log.odometry) {
    while (next < log.pings.size() && log.pings[next].time_s < sample.time_s) pipeline.push(log.pings[next++]);
    pipeline.push(sample);
  }
  while (next < log.pings.size()) pipeline.push(log.pings[next++]);
  pipeline.end_of_odometry();
  pipeline.flush();
  EXPECT_EQ(methods[0].save(), expected[0]);
  EXPECT_EQ(pipeline.report().waiting, 0U);
  EXPECT_EQ(pipeline.path().size(), log.odometry.size());
}

TEST(Pipeline, FlushingInBetweenLeavesWaitingPingsWaiting) {
  const Log log = small_log();
  std::vector<AnyMethod> methods = folds(1);
  InlineExecutor executor;
  Pipeline pipeline(Sensing(log.robot.sensors), methods, executor);
  pipeline.push(test::odometry_at(0.0));
  pipeline.push(test::ping_at(0.0, 0, 1.0));
  pipeline.push(test::ping_at(0.5, 1, 1.0));
  pipeline.flush();
  EXPECT_EQ(methods[0].counters().used, 1U);
  EXPECT_EQ(pipeline.report().waiting, 1U);
  pipeline.push(test::odometry_at(1.0));
  pipeline.flush();
  EXPECT_EQ(methods[0].counters().used, 2U);
}

TEST(Pipeline, CancellationFinishesWhatWasTaken) {
  const Log log = test::drive(0.0, test::model_of(0.2, 4.0), 4, 1000);
  std::vector<AnyMethod> methods = folds(2);
  InlineExecutor executor;
  int asked = 0;
  const LogRun run = run_log(log, {}, methods, executor, {.cancelled = [&] { return ++asked == 3; }}, 50);
  EXPECT_TRUE(run.cancelled);
  EXPECT_GT(run.report.accepted(), 0U);
  EXPECT_LT(run.report.pings, log.pings.size());
  EXPECT_EQ(methods[0].counters().used, run.report.accepted()) << "readings below a batch are not lost";
  // The state is that of the log cut at the same place.
  Log cut = log;
  cut.pings.resize(run.report.pings);
  EXPECT_EQ(methods[1].save(), states_after(cut, 2, executor, 50)[1]);
}

TEST(Pipeline, ProgressRisesToOne) {
  const Log log = test::drive(0.0, test::model_of(0.2, 4.0), 4, 1000);
  std::vector<AnyMethod> methods = folds(1);
  InlineExecutor executor;
  std::vector<double> seen;
  (void)run_log(log, {}, methods, executor, {.progress = [&](double fraction) { seen.push_back(fraction); }});
  ASSERT_GE(seen.size(), 5U);
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_GE(seen.front(), 0.0);
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(Pipeline, ReadingsAreShownToTheHost) {
  const Log log = small_log();
  std::vector<AnyMethod> methods;
  InlineExecutor executor;
  std::vector<PingId> shown;
  const auto show = [&](std::span<const Reading> batch) {
    for (const Reading& reading : batch) shown.push_back(reading.ping);
  };
  const LogRun run = run_log(log, {}, methods, executor, {.readings = show}, 16);
  EXPECT_EQ(shown.size(), run.report.accepted()) << "even without any method";
  EXPECT_TRUE(std::ranges::is_sorted(shown));
}

TEST(Pipeline, CpuTimeIsChargedToItsMethod) {
  const Log log = small_log();
  InlineExecutor executor;
  // A clock that ticks once when it is read: every timed call costs one second.
  std::atomic<int> ticks = 0;
  const PipelineHost host{.thread_cpu_s = [&] { return double(ticks++); }};
  std::vector<AnyMethod> methods = folds(2);
  const LogRun run = run_log(log, {}, methods, executor, host, 60);
  ASSERT_EQ(run.costs.size(), 2U);
  for (const MethodCost& cost : run.costs) {
    EXPECT_EQ(cost.insert_cpu_s, 4.0) << "240 readings in batches of 60";
    EXPECT_EQ(cost.finish_cpu_s, 1.0);
  }
  const LogRun without = run_log(log, {}, methods, executor);
  EXPECT_EQ(without.costs[0].insert_cpu_s, 0.0);
}

TEST(Pipeline, CpuTimeOnOtherThreadsIsAdded) {
  const Log log = small_log();
  ThreadsExecutor executor(4);
  std::atomic<int> ticks = 0;
  std::atomic<int> elsewhere = 0;
  const std::thread::id here = std::this_thread::get_id();
  const PipelineHost host{.thread_cpu_s = [&] {
    const bool other = std::this_thread::get_id() != here;
    thread_local int begins = 0;
    if (other && begins++ % 2 == 0) ++elsewhere;
    return other ? double(begins) : double(ticks++);
  }};
  std::vector<AnyMethod> methods = folds(1);
  const LogRun run = run_log(log, {}, methods, executor, host, 100000);
  EXPECT_EQ(elsewhere, 240) << "one task per reading";
  EXPECT_EQ(run.costs[0].insert_cpu_s, 1.0 + 240.0);
}

TEST(Pipeline, SupportingPingsAreFoundByReplay) {
  const Log log = small_log();
  const std::vector<Reading> readings = sense(log).readings;
  std::vector<AnyMethod> methods = folds(1);
  const Reading& reading = *std::ranges::find_if(readings, [](const Reading& r) { return r.ping == 11; });
  const Vec2 there = reading.T_world_tx * Vec2{*echo_range_m(reading.outcome), 0.0};
  const std::vector<PingId> pings = supporting_pings(methods[0], readings, there);
  EXPECT_TRUE(std::ranges::binary_search(pings, PingId{11}));
  EXPECT_TRUE(std::ranges::is_sorted(pings));
  EXPECT_LT(pings.size(), readings.size());
  EXPECT_TRUE(supporting_pings(methods[0], readings, {1e6, 0.0}).empty());
}

RC_GTEST_PROP(Pipeline, EveryPingIsAccountedFor, (std::vector<std::int16_t> values)) {
  Log log = small_log();
  for (std::size_t i = 0; i < std::min(values.size(), log.pings.size()); ++i) {
    log.pings[i].range_m = values[i] / 1000.0;
    log.pings[i].time_s += values[i] % 7 == 0 ? -1.0 : 0.0;
  }
  std::vector<AnyMethod> methods = folds(1);
  InlineExecutor executor;
  const LogRun run = run_log(log, {}, methods, executor, {}, 3);
  RC_ASSERT(run.report.accepted() + run.report.rejected_pings.total() == log.pings.size());
  RC_ASSERT(methods[0].counters().used == run.report.accepted());
}

}  // namespace
}  // namespace echoarc
