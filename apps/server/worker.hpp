// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace echoarc::server {

/// A thread that does one job after another. Jobs that have not begun when it is destroyed are dropped.
class Worker {
 public:
  using Job = std::function<void()>;

  /// More jobs than this may not wait.
  explicit Worker(std::size_t max_waiting);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker();

  /// False, and the job is not taken, when too many wait already.
  [[nodiscard]] bool post(Job job);

 private:
  void work();

  std::size_t max_waiting_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Job> jobs_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace echoarc::server
