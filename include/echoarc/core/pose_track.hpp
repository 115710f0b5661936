// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose2.hpp"

namespace echoarc {

/// Where the robot was at any moment of a log: odometry, interpolated in time.
class PoseTrack {
 public:
  PoseTrack() = default;
  /// Keeps the finite records whose time exceeds that of the last one kept; the others are counted.
  explicit PoseTrack(std::span<const Odometry> odometry);

  /// Straight-line position and shortest-turn heading between the records around `time_s`. No value before the first or
  /// after the last record, between records more than `max_gap_s` apart, and for a NaN.
  [[nodiscard]] std::optional<Pose2> T_world_robot(double time_s,
                                                   double max_gap_s = std::numeric_limits<double>::infinity()) const;

  [[nodiscard]] std::span<const Odometry> records() const { return records_; }
  [[nodiscard]] bool empty() const { return records_.empty(); }
  /// Records left out because a number in them was NaN or infinite.
  [[nodiscard]] std::uint64_t not_finite() const { return not_finite_; }
  /// Records left out because time stood still or ran backwards.
  [[nodiscard]] std::uint64_t out_of_order() const { return out_of_order_; }

 private:
  std::vector<Odometry> records_;
  std::uint64_t not_finite_ = 0;
  std::uint64_t out_of_order_ = 0;
};

}  // namespace echoarc
