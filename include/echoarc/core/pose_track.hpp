// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/pose2.hpp"

namespace echoarc {

/// The robot's poses over time, from odometry in the order in which it arrives.
class PoseTrack {
 public:
  /// Coordinates beyond this are out of every map's reach, m.
  static constexpr double farthest_m = 1e7;

  /// Why a sample was not taken.
  enum class Refusal : std::uint8_t {
    bad_time,   ///< not finite, or too far ahead of the newest sample
    bad_pose,   ///< not finite or out of reach
    backwards,  ///< stamped before the newest sample
    duplicate,  ///< stamped like the newest sample
  };
  /// Why there is no pose at a time.
  enum class Missing : std::uint8_t {
    outside,  ///< before the first or after the last sample
    gap,      ///< the samples around it are too far apart
  };

  /// A pose is interpolated between neighbours at most `max_gap_s` apart; odometry that jumps ahead by more than
  /// `max_jump_s` is refused, so that one wild stamp cannot make everything after it look late.
  explicit PoseTrack(double max_gap_s = std::numeric_limits<double>::infinity(),
                     double max_jump_s = std::numeric_limits<double>::infinity())
      : max_gap_s_(max_gap_s), max_jump_s_(max_jump_s) {}

  /// No value when the sample was taken, otherwise why not.
  [[nodiscard]] std::optional<Refusal> push(const Odometry& sample);

  /// T_world_robot at `time_s`, on the straight line and by the shortest turn between the samples around it. The times
  /// of samples themselves are never in a gap; a NaN is outside.
  [[nodiscard]] std::variant<Pose2, Missing> at(double time_s) const;

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
