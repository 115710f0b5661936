// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "host/clocks.hpp"

#include <gtest/gtest.h>

namespace echoarc::host {
namespace {

/// Spins until the thread has used `seconds` of processor time.
void work(double seconds) {
  const double begin = thread_cpu_time_s();
  while (thread_cpu_time_s() - begin < seconds) continue;
}

TEST(Clocks, WorkCountsOnEveryClock) {
  const double process = process_cpu_time_s();
  const double wall = wall_time_s();
  work(0.01);
  EXPECT_GE(process_cpu_time_s() - process, 0.009);
  EXPECT_GE(wall_time_s() - wall, 0.009);
}

}  // namespace
}  // namespace echoarc::host
