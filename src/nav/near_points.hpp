// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "echoarc/core/vec2.hpp"

namespace echoarc::nav {

/// Keeps what was seen close to the robot for some seconds. A sonar hears nothing nearer than its blanking range, so a
/// wall that the robot drives close along would vanish from a map of the newest echoes.
class NearPoints {
 public:
  /// The points, and what vanished of late from close around the place. Valid until the next call.
  [[nodiscard]] std::span<const Vec2> added_to(std::span<const Vec2> points, Vec2 place, double time_s) {
    for (const Vec2 p : points)
      if (norm(p - place) < close_m) kept_[cell_of(p)] = {p, time_s};  // false for what is not finite
    std::erase_if(kept_, [&](const auto& entry) {
      return time_s - entry.second.time_s > keep_s || norm(entry.second.place - place) > forget_m;
    });
    merged_.assign(points.begin(), points.end());
    for (const auto& [cell, kept] : kept_)
      if (kept.time_s < time_s) merged_.push_back(kept.place);
    return merged_;
  }

 private:
  static constexpr double close_m = 0.6;
  static constexpr double forget_m = 1.2;
  static constexpr double keep_s = 10.0;
  static constexpr double cell_m = 0.05;
  struct Kept {
    Vec2 place;
    double time_s = 0.0;
  };
  using Cell = std::pair<std::int64_t, std::int64_t>;
  static Cell cell_of(Vec2 p) { return {std::llround(p.x / cell_m), std::llround(p.y / cell_m)}; }
  std::map<Cell, Kept> kept_;
  std::vector<Vec2> merged_;
};

}  // namespace echoarc::nav
