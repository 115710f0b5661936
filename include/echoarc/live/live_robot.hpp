// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "echoarc/live/local_map.hpp"
#include "echoarc/live/navigator.hpp"
#include "echoarc/live/robot_control.hpp"
#include "echoarc/live/source.hpp"

namespace echoarc::live {

/// A running robot, steppable: source, local map of obstacles, control. The host steps it as real time passes and takes
/// the records; it is not thread-safe.
class LiveRobot {
 public:
  explicit LiveRobot(std::unique_ptr<Source> source, const ControlOptions& options = {});
  /// The same, with maps of its own to find its way by; heeded only of a source that can be driven.
  LiveRobot(std::unique_ptr<Source> source, const ControlOptions& options, Navigator navigator);

  /// Lets a strategy drive until it has ended, or somebody else does. Only with a navigator; `places` as there.
  void navigate(std::unique_ptr<nav::Strategy> strategy, std::span<const Vec2> places = {});
  [[nodiscard]] const Navigator* navigator() const { return navigator_ ? &*navigator_ : nullptr; }

  /// Goes on to `until_s` of the source's time in steps of at most 10 ms, the control in each; appends what was said.
  /// `host_s`: the host's monotonic time now.
  [[nodiscard]] Result<void> step(double until_s, double host_s, std::vector<Record>& records);
  /// Null for a source that cannot be driven.
  [[nodiscard]] RobotControl* control() { return control_ ? &*control_ : nullptr; }
  [[nodiscard]] Source& source() { return *source_; }
  /// The newest odometry, and truth where there is one.
  [[nodiscard]] const std::optional<Pose2>& T_world_robot() const { return T_world_robot_; }
  [[nodiscard]] const std::optional<Pose2>& T_world_true() const { return T_world_true_; }
  [[nodiscard]] RobotVelocity velocity() const;
  [[nodiscard]] double travelled_m() const { return travelled_m_; }

 private:
  void note_commands(std::vector<Record>& records);
  void heed(const Record& record);
  void ask_strategy(std::vector<Record>& records);
  void note_wall(WallSide side, std::vector<Record>& records);

  std::unique_ptr<Source> source_;
  std::optional<RobotControl> control_;
  LocalMap obstacles_;
  std::optional<Navigator> navigator_;
  double next_steering_s_ = 0.0;
  WallSide noted_wall_ = WallSide::unknown;
  std::optional<Pose2> T_world_robot_;
  std::optional<Pose2> T_world_true_;
  std::optional<Odometry> newest_;
  RobotVelocity measured_;  // from odometry
  std::string noted_mode_ = "stand";
  RobotVelocity noted_wanted_;
  double travelled_m_ = 0.0;
};

}  // namespace echoarc::live
