// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/jump_filter.hpp"

#include <cmath>

namespace echoarc {

bool JumpFilter::jumps(const Reading& reading, double threshold_m) {
  const auto [place, first] = last_.try_emplace({reading.tx, reading.rx}, reading.outcome);
  if (first) return false;
  const Outcome before = std::exchange(place->second, reading.outcome);
  if (before.index() != reading.outcome.index()) return true;
  const auto was_m = echo_range_m(before);
  const auto is_m = echo_range_m(reading.outcome);
  return was_m && is_m && std::abs(*is_m - *was_m) > threshold_m;
}

}  // namespace echoarc
