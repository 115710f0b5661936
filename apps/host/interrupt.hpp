// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace echoarc::host {

/// Turns the first SIGINT or SIGTERM into a flag that long jobs look at; the second one ends the process at once, as it
/// would have without this. Only one at a time; the destructor puts the former handlers back.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  /// Whether a signal arrived since the guard was made. May be called from any thread.
  [[nodiscard]] static bool interrupted();
};

}  // namespace echoarc::host
