// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/sensing/rejection.hpp"

namespace echoarc {

/// The robot's poses over time, from odometry in the order in which it arrives.
class PoseTrack {
 public:
  /// Coordinates beyond this are out of every map's reach, m.
  static constexpr double farthest_m = 1e7;

  /// A pose is interpolated between neighbours at most `max_gap_s` apart; odometry that jumps ahead by more than
  /// `max_jump_s` is refused, so that one wild stamp cannot make everything after it look late.
  PoseTrack(double max_gap_s, double max_jump_s) : max_gap_s_(max_gap_s), max_jump_s_(max_jump_s) {}

  /// No value when the sample was taken, otherwise why not: bad_time, bad_pose, time_backwards, duplicate.
  [[nodiscard]] std::optional<Rejection> push(const Odometry& sample);

  /// T_world_robot at `time_s`, on the straight line and by the shortest turn between the samples around it; `no_pose`
  /// before the first and after the last sample (their own times are fine), `pose_gap` in a gap.
  [[nodiscard]] std::variant<Pose2, Rejection> at(double time_s) const;

  [[nodiscard]] std::span<const Odometry> samples() const { return samples_; }
  [[nodiscard]] bool empty() const { return samples_.empty(); }
  /// Time of the newest sample, s. Requires !empty().
  [[nodiscard]] double newest_s() const { return samples_.back().time_s; }

 private:
  double max_gap_s_;
  double max_jump_s_;
  std::vector<Odometry> samples_;
};

}  // namespace echoarc
