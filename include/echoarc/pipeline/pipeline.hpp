// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing.hpp"

namespace echoarc {

/// What a pipeline may ask its host for; every part may be left out.
struct PipelineHost {
  /// Told the share of the log that is done, 0 to 1, now and then, on the calling thread.
  std::function<void(double fraction)> progress;
  /// Asked now and then; true stops taking pings. What was taken is still finished and handed out.
  std::function<bool()> cancelled;
  /// CPU time of the calling thread, s; for `MethodCost`. Called from the executor's threads.
  std::function<double()> thread_cpu_s;
  /// Shown every batch of readings before the methods get it, on the calling thread.
  std::function<void(std::span<const Reading>)> readings;
};

/// What one method cost so far.
struct MethodCost {
  double insert_cpu_s = 0.0;  ///< 0 without a clock
  double finish_cpu_s = 0.0;
};

/// Drives a log or a stream through sensing into several methods in one pass.
///
/// Readings are handed over in batches, each method its own task of the executor; a batch is a matter of speed alone:
/// maps and counters depend neither on its size nor on the number of threads. Methods that take laser-limited readings
/// get those of `sensing`, the others the plain ones, in the same pass.
class Pipeline {
 public:
  static constexpr std::size_t default_batch = 4096;

  /// `methods` and `executor` belong to the host and outlive the pipeline.
  Pipeline(Sensing sensing, std::span<AnyMethod> methods, Executor& executor, PipelineHost host = {},
           std::size_t batch_readings = default_batch);

  void push(const Odometry& sample);
  void push(const WallNote& note);
  void push(const Scan& scan);
  void push(const Ping& ping);
  void push(const Poll& poll);
  void end_of_polls();
  /// Gives the methods every reading that is ready and brings their maps up to date; more may follow. Pings that wait
  /// for odometry keep waiting.
  void flush();
  /// No more odometry will come: waiting pings are decided now and later ones at once.
  void end_of_odometry();

  [[nodiscard]] const SensingReport& report() const { return sensing_.report(); }
  /// The robot's path: every odometry record that was taken, in the order of time.
  [[nodiscard]] std::span<const Odometry> path() const { return sensing_.track().samples(); }
  /// In the order of the methods.
  [[nodiscard]] std::span<const MethodCost> costs() const { return costs_; }

 private:
  void insert_ready();
  void for_each_method(double MethodCost::* cost, const std::function<void(AnyMethod&, Executor&)>& work);

  Sensing sensing_;
  std::span<AnyMethod> methods_;
  Executor* executor_;
  PipelineHost host_;
  std::size_t batch_readings_;
  std::vector<MethodCost> costs_;
};

/// What became of a log. The maps are in the methods.
struct LogRun {
  SensingReport report;
  std::vector<Odometry> path;
  std::vector<MethodCost> costs;
  bool cancelled = false;  ///< pings after the cancellation were never offered
};

/// The whole log through `methods`: no-echo decisions from all its values, then one pass.
[[nodiscard]] LogRun run_log(const Log& log, const SensingOptions& options, std::span<AnyMethod> methods,
                             Executor& executor, const PipelineHost& host = {},
                             std::size_t batch_readings = Pipeline::default_batch);

/// Ids of the pings that speak for something at `position`, by asking `method` about every reading: the way back from a
/// grid cell to the log. `readings` as `sense` gives them for the log and options of the map.
[[nodiscard]] std::vector<PingId> supporting_pings(const AnyMethod& method, std::span<const Reading> readings,
                                                   Vec2 position);

}  // namespace echoarc
