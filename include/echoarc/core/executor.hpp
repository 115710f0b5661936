// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>

namespace echoarc {

/// Runs independent tasks on threads the host owns. The library starts no thread of its own, and no result depends on
/// how many there are: tasks write to disjoint places and sums are merged in a fixed order.
class Executor {
 public:
  virtual ~Executor() = default;
  /// How many tasks can make progress at once; at least 1.
  [[nodiscard]] virtual std::size_t concurrency() const = 0;
  /// Calls `task(0) ... task(count - 1)`, in any order and on any thread, and returns when all are done.
  /// May be called from inside a task.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& task) = 0;
};

/// Runs every task on the calling thread, in order.
class InlineExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t concurrency() const override { return 1; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

}  // namespace echoarc
