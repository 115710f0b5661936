// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/worker.hpp"

#include <future>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::server {
namespace {

TEST(Worker, DoesJobsInOrder) {
  std::vector<int> done;
  std::promise<void> last;
  Worker worker(100);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(worker.post([&done, i] { done.push_back(i); }));
  ASSERT_TRUE(worker.post([&] { last.set_value(); }));
  last.get_future().wait();
  ASSERT_EQ(done.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(Worker, RefusesWhatWouldWaitBeyondItsLimit) {
  std::promise<void> begun;
  std::promise<void> go_on;
  Worker worker(2);
  ASSERT_TRUE(worker.post([&] {
    begun.set_value();
    go_on.get_future().wait();
  }));
  begun.get_future().wait();
  EXPECT_TRUE(worker.post([] {}));
  EXPECT_TRUE(worker.post([] {}));
  EXPECT_FALSE(worker.post([] { ADD_FAILURE() << "was refused"; }));
  std::promise<void> last;
  go_on.set_value();
  while (!worker.post([&] { last.set_value(); })) std::this_thread::yield();
  last.get_future().wait();
}

}  // namespace
}  // namespace echoarc::server
