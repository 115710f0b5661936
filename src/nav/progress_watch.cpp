// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/progress_watch.hpp"

namespace echoarc::nav {

bool ProgressWatch::stalled(double time_s, double remaining_m) {
  const bool first = !since_s_;
  if (first) detours_ = 0;
  const bool detour = !first && remaining_m > before_m_ + detour_m && detours_++ < most_detours;
  before_m_ = remaining_m;
  if (first || detour || remaining_m <= least_m_ - progress_m) {
    since_s_ = time_s;
    least_m_ = remaining_m;
  }
  return time_s - *since_s_ > patience_s_;
}

}  // namespace echoarc::nav
