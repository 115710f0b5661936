// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "host/interrupt.hpp"

#include <csignal>

#include <gtest/gtest.h>

namespace echoarc::host {
namespace {

TEST(InterruptGuard, NotesTheFirstSignal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const InterruptGuard guard;
    EXPECT_FALSE(InterruptGuard::interrupted());
    ASSERT_EQ(std::raise(signal), 0);
    EXPECT_TRUE(InterruptGuard::interrupted());
  }
}

TEST(InterruptGuardDeathTest, SecondSignalEndsTheProcess) {
  const auto interrupt_twice = [] {
    const InterruptGuard guard;
    std::raise(SIGINT);
    std::raise(SIGINT);
  };
  EXPECT_EXIT(interrupt_twice(), testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace echoarc::host
