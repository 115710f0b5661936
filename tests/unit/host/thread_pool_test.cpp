// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "host/thread_pool.hpp"

#include <atomic>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::host {
namespace {

class ThreadPoolTest : public testing::TestWithParam<std::size_t> {};

TEST_P(ThreadPoolTest, RunsEveryTaskOnce) {
  ThreadPool pool(GetParam());
  for (const std::size_t count : {0UL, 1UL, 2UL, 7UL, 1000UL}) {
    std::vector<int> calls(count, 0);
    pool.run(count, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(count, 1));
  }
}

TEST_P(ThreadPoolTest, TasksMayRunTasks) {
  ThreadPool pool(GetParam());
  std::vector<std::vector<int>> calls(8, std::vector<int>(8, 0));
  pool.run(8, [&](std::size_t i) { pool.run(8, [&](std::size_t j) { ++calls[i][j]; }); });
  for (const std::vector<int>& row : calls) EXPECT_EQ(row, std::vector<int>(8, 1));
}

TEST_P(ThreadPoolTest, FirstExceptionArrivesAfterTheWholeBatch) {
  ThreadPool pool(GetParam());
  std::atomic<int> calls{0};
  const auto task = [&](std::size_t i) {
    ++calls;
    if (i == 0) throw std::runtime_error("task 0");
  };
  EXPECT_THROW(pool.run(4, task), std::runtime_error);
  EXPECT_EQ(calls, 4);
  pool.run(3, [&](std::size_t) { ++calls; });  // the pool still works
  EXPECT_EQ(calls, 7);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ThreadPoolTest, testing::Values(1, 2, 8));

TEST(ThreadPool, ConcurrencyCountsTheCaller) {
  EXPECT_EQ(ThreadPool(0).concurrency(), 1U);
  EXPECT_EQ(ThreadPool(1).concurrency(), 1U);
  EXPECT_EQ(ThreadPool(5).concurrency(), 5U);
}

TEST(ThreadPool, WorkersTakePart) {
  ThreadPool pool(2);
  std::atomic<int> present{0};
  // Each task waits for the other: two threads must be inside at once.
  pool.run(2, [&](std::size_t) {
    ++present;
    while (present < 2) std::this_thread::yield();
  });
  EXPECT_EQ(present, 2);
}

}  // namespace
}  // namespace echoarc::host
