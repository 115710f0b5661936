// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>

#include "echoarc/core/pose2.hpp"

namespace echoarc::nav {

/// A box of places and headings. Headings are numbered 0 ... headings - 1 around the circle.
struct PoseBin {
  std::int32_t i = 0;
  std::int32_t j = 0;
  std::int32_t heading = 0;
  friend auto operator<=>(const PoseBin&, const PoseBin&) = default;
};

[[nodiscard]] inline std::int32_t headings_of(Angle bin_turn) {
  return std::max(1, static_cast<std::int32_t>(std::lround(degrees(360.0) / bin_turn)));
}

[[nodiscard]] inline PoseBin bin_of(const Pose2& T, double bin_m, Angle bin_turn) {
  const auto index = [](double v) { return static_cast<std::int32_t>(std::clamp(std::floor(v), -1e9, 1e9)); };
  const std::int32_t headings = headings_of(bin_turn);
  const double turns = (wrap(T.heading) / degrees(360.0)) + 0.5;  // in (0, 1]
  const std::int32_t heading = index(turns * headings) % headings;
  return {index(T.position.x / bin_m), index(T.position.y / bin_m), heading};
}

}  // namespace echoarc::nav
