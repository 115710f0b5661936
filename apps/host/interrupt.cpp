// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "host/interrupt.hpp"

#include <array>
#include <atomic>
#include <csignal>

namespace echoarc::host {
namespace {

constexpr std::array handled_signals{SIGINT, SIGTERM};

// A signal handler can reach nothing but statics; a lock-free atomic is all it may touch.
std::atomic<bool> signal_arrived{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::array<struct sigaction, handled_signals.size()> former_actions{};

extern "C" void note_signal(int) {
  signal_arrived.store(true);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  signal_arrived.store(false);
  struct sigaction action{};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  // SA_RESETHAND: the second signal meets the default action, so an impatient user is never stuck.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (std::size_t i = 0; i < handled_signals.size(); ++i) sigaction(handled_signals[i], &action, &former_actions[i]);
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < handled_signals.size(); ++i) sigaction(handled_signals[i], &former_actions[i], nullptr);
}

bool InterruptGuard::interrupted() {
  return signal_arrived.load();
}

}  // namespace echoarc::host
