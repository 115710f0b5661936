// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <span>
#include <vector>

#include "echoarc/core/vec2.hpp"

namespace echoarc::nav {

/// The places of obstacles that meet points were found by. A local map of sonar forgets soon; without what stands
/// behind the robot or was not heard yet on the way back, a meet point would not be known again, nor left between the
/// right two.
class NodeMemory {
 public:
  /// What was seen more of before is kept.
  void remember(int node, Vec2 place, std::vector<Vec2> closest) {
    Remembered& remembered = nodes_[node];
    if (closest.size() >= remembered.closest.size()) remembered = {place, std::move(closest)};
  }
  /// The points, and what is remembered of nodes near the place. Valid until the next call.
  [[nodiscard]] std::span<const Vec2> added_to(std::span<const Vec2> points, Vec2 place) {
    merged_.clear();
    for (const auto& [node, remembered] : nodes_)
      if (norm(remembered.place - place) < near_m)
        merged_.insert(merged_.end(), remembered.closest.begin(), remembered.closest.end());
    if (merged_.empty()) return points;
    merged_.insert(merged_.end(), points.begin(), points.end());
    return merged_;
  }

 private:
  static constexpr double near_m = 0.8;
  struct Remembered {
    Vec2 place;
    std::vector<Vec2> closest;
  };
  std::map<int, Remembered> nodes_;
  std::vector<Vec2> merged_;
};

}  // namespace echoarc::nav
