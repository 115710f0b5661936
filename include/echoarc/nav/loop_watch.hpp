// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/core/pose2.hpp"

namespace echoarc::nav {

/// Whether a robot that follows something is round: near its start again, the same way on, after some way.
class LoopWatch {
 public:
  /// Once per moment: the pose, and thereby the way.
  void drive_to(const Pose2& T_world_base) {
    const double step_m = T_world_last_ ? norm(T_world_base.position - T_world_last_->position) : 0.0;
    T_world_last_ = T_world_base;
    step_m_ = step_m;
    travel_m_ += step_m;
    if (T_world_start_) loop_m_ += step_m;
  }

  /// The loop begins where the robot is; the first time alone counts.
  void begin() {
    if (!T_world_start_) T_world_start_ = T_world_last_;
  }

  /// The same, as soon as the robot has been settled on what it follows for some way.
  void settled(bool is_settled) {
    constexpr double settled_way_m = 0.3;
    settled_m_ = is_settled ? settled_m_ + step_m_ : 0.0;
    if (settled_m_ > settled_way_m) begin();
  }

  [[nodiscard]] bool round(double close_m, double least_loop_m) const {
    constexpr double same_way_deg = 45.0;
    if (!T_world_start_ || loop_m_ < least_loop_m) return false;
    return norm(T_world_last_->position - T_world_start_->position) < close_m &&
           abs(wrap(T_world_last_->heading - T_world_start_->heading)) < degrees(same_way_deg);
  }

  [[nodiscard]] double step_m() const { return step_m_; }      ///< the last step's way
  [[nodiscard]] double travel_m() const { return travel_m_; }  ///< in all
  [[nodiscard]] const std::optional<Pose2>& T_world_start() const { return T_world_start_; }

 private:
  std::optional<Pose2> T_world_last_;
  std::optional<Pose2> T_world_start_;
  double step_m_ = 0.0;
  double travel_m_ = 0.0;
  double loop_m_ = 0.0;
  double settled_m_ = 0.0;
};

}  // namespace echoarc::nav
