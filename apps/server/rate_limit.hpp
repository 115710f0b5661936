// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>

namespace echoarc::server {

/// So many a second on average, so many at once.
class RateLimit {
 public:
  RateLimit(double per_s, double burst) : per_s_(per_s), burst_(burst), left_(burst) {}

  /// Whether one more is within the limit.
  [[nodiscard]] bool take(double now_s) {
    left_ = std::min(burst_, left_ + std::max(0.0, now_s - last_s_) * per_s_);
    last_s_ = now_s;
    if (left_ < 1.0) return false;
    left_ -= 1.0;
    return true;
  }

 private:
  double per_s_;
  double burst_;
  double left_;
  double last_s_ = 0.0;
};

}  // namespace echoarc::server
