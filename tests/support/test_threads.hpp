// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "echoarc/core/executor.hpp"

namespace echoarc::test {

/// Starts fresh threads for every call: slow, but with nothing to go wrong between calls.
class TestThreads final : public Executor {
 public:
  explicit TestThreads(std::size_t count) : count_(count) {}
  [[nodiscard]] std::size_t concurrency() const override { return count_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t k = next++; k < count; k = next++) task(k);
    };
    std::vector<std::thread> threads;
    for (std::size_t k = 1; k < count_; ++k) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
  }

 private:
  std::size_t count_;
};

}  // namespace echoarc::test
