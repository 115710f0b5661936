// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose2.hpp"
#include "echoarc/live/chunked_log.hpp"

namespace echoarc::live {

/// Where the robot truly was, as far as the source knows. A copy is cheap and stays as it was.
class TruthLog {
 public:
  /// Not finite, or not later than the newest: not taken.
  void push(const Odometry& pose);
  /// T_world_robot between the true poses around a time; none before the first and after the last.
  [[nodiscard]] std::optional<Pose2> at(double time_s) const;
  void clear() { poses_.clear(); }

 private:
  ChunkedLog<Odometry> poses_;
};

}  // namespace echoarc::live
