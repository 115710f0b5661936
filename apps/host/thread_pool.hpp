// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "echoarc/core/executor.hpp"

namespace echoarc::host {

/// The threads a program lends to the library. The calling thread works too, so a pool of one starts none.
///
/// `run` may be called from inside a task: the caller works on its own batch until nothing of it is left to begin, so a
/// pool can never wait for itself. The first exception of a task is rethrown by `run` once the whole batch is over.
class ThreadPool final : public Executor {
 public:
  /// \param threads how many tasks progress at once, the caller's included; at least 1 is used
  explicit ThreadPool(std::size_t threads);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() override;

  [[nodiscard]] std::size_t concurrency() const override { return workers_.size() + 1; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override;

 private:
  /// One call of `run`; lives on the stack of its caller. Guarded by `mutex_`.
  struct Batch {
    const std::function<void(std::size_t)>& task;
    std::size_t count;
    std::size_t begun = 0;
    std::size_t ended = 0;
    std::exception_ptr error;
  };

  void work();
  void run_one(Batch& batch, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable begin_;  // a batch has tasks to begin, or the pool is closing
  std::condition_variable end_;    // the last task of some batch ended
  std::vector<Batch*> open_;       // batches with tasks not yet begun; the newest is served first
  bool closing_ = false;
  std::vector<std::thread> workers_;
};

/// Hardware threads of this machine; at least 1.
[[nodiscard]] std::size_t hardware_threads();

}  // namespace echoarc::host
