// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/scene_scoring.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::studies {

/// A scene and how its maps are judged.
struct StudyScene {
  sim::Scene scene;
  SceneScoring scoring;
};

/// What a study asks of its host. Studies open no files and read no clock.
struct StudyHost {
  Executor* executor = nullptr;  ///< outlives the study
  /// A scene by name, without folder and ending: "e1_curve". Called from one thread.
  std::function<Result<StudyScene>(std::string_view name)> scene;
  int seeds = 10;  ///< runs of every scene, seeds 1, 2, ...
  /// Told the share that is done, 0 to 1, by one thread at a time. May be left out.
  std::function<void(double fraction)> progress;
  /// Asked now and then, from any thread. May be left out.
  std::function<bool()> cancelled;
  /// CPU time of the calling thread, s; without it no times are reported. Times are the only figures of a study that
  /// differ from run to run.
  std::function<double()> thread_cpu_s;
};

/// The error of a study that was told to stop.
[[nodiscard]] Error interrupted_study();

/// Counts finished tasks of a study and tells the host. Any thread may call `step`.
class StudyProgress {
 public:
  /// `host` outlives this; `tasks` are all that there will be.
  StudyProgress(const StudyHost& host, std::size_t tasks) : host_(&host), tasks_(tasks) {}
  void step();

 private:
  const StudyHost* host_;
  std::size_t tasks_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

/// `task(0) ... task(count - 1)` through the host's executor, results in the order of the index, whatever the threads.
/// Of several errors that of the lowest index is returned; after an error or a cancellation no new task begins.
template <class T>
[[nodiscard]] Result<std::vector<T>> run_tasks(const StudyHost& host, std::size_t count, StudyProgress& progress,
                                               const std::function<Result<T>(std::size_t)>& task) {
  std::vector<Result<T>> results(count, Result<T>(interrupted_study()));
  std::atomic<bool> stop = false;
  host.executor->run(count, [&](std::size_t k) {
    if (stop || (host.cancelled && host.cancelled())) return;
    results[k] = task(k);
    if (!results[k]) stop = true;
    progress.step();
  });
  for (const Result<T>& result : results)
    if (!result && result.error().code != ErrorCode::interrupted) return result.error();
  std::vector<T> values;
  values.reserve(count);
  for (Result<T>& result : results) {
    if (!result) return result.error();
    values.push_back(std::move(*result));
  }
  return values;
}

}  // namespace echoarc::studies
