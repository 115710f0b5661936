// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "host/clocks.hpp"

#include <ctime>

namespace echoarc::host {
namespace {

double read_clock(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double process_cpu_time_s() {
  return read_clock(CLOCK_PROCESS_CPUTIME_ID);
}
double thread_cpu_time_s() {
  return read_clock(CLOCK_THREAD_CPUTIME_ID);
}
double wall_time_s() {
  return read_clock(CLOCK_MONOTONIC);
}

}  // namespace echoarc::host
