// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "echoarc/mapping/doi_history.hpp"

namespace echoarc::doi {

/// Walks along a path by distance travelled. Distances may only grow from call to call.
class PathWalk {
 public:
  explicit PathWalk(std::span<const DoiHistory::Waypoint> path) : path_(path) {
    for (std::size_t k = 1; k < path_.size(); ++k) length_m_ += segment_m(k);
  }
  [[nodiscard]] double length_m() const { return length_m_; }
  /// The position after \p s_m metres; the ends of the path before and beyond it. The path must not be empty.
  [[nodiscard]] Vec2 at(double s_m) {
    while (next_ + 1 < path_.size() && passed_m_ + segment_m(next_) < s_m) passed_m_ += segment_m(next_++);
    if (next_ >= path_.size()) return path_.back().position;
    const double length_m = segment_m(next_);
    const double fraction = length_m > 0.0 ? std::clamp((s_m - passed_m_) / length_m, 0.0, 1.0) : 0.0;
    return path_[next_ - 1].position + fraction * (path_[next_].position - path_[next_ - 1].position);
  }
  /// The waypoint at or before the last position.
  [[nodiscard]] const DoiHistory::Waypoint& passed() const { return path_[next_ - 1]; }

 private:
  [[nodiscard]] double segment_m(std::size_t k) const { return norm(path_[k].position - path_[k - 1].position); }

  std::span<const DoiHistory::Waypoint> path_;
  std::size_t next_ = 1;
  double passed_m_ = 0.0;
  double length_m_ = 0.0;
};

}  // namespace echoarc::doi
