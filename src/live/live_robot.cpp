// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/live_robot.hpp"

#include <algorithm>
#include <utility>

namespace echoarc::live {

LiveRobot::LiveRobot(std::unique_ptr<Source> source, const ControlOptions& options)
    : source_(std::move(source)), obstacles_(source_->description().robot) {
  const SourceDescription& is = source_->description();
  if (source_->drivable() != nullptr) control_.emplace(options, is.robot.radius_m, is.tour);
}

LiveRobot::LiveRobot(std::unique_ptr<Source> source, const ControlOptions& options, Navigator navigator)
    : LiveRobot(std::move(source), options) {
  if (control_) navigator_.emplace(std::move(navigator));
}

void LiveRobot::navigate(std::unique_ptr<nav::Strategy> strategy, std::span<const Vec2> places) {
  if (!navigator_ || strategy == nullptr) return;
  control_->navigate(std::string(strategy->name()));
  navigator_->follow(std::move(strategy), places);
  next_steering_s_ = source_->time_s();
}

Result<void> LiveRobot::step(double until_s, double host_s, std::vector<Record>& records) {
  constexpr double longest_step_s = 0.01;
  constexpr double same_time_s = 1e-9;
  Drivable* robot = source_->drivable();
  while (source_->time_s() < until_s) {
    double next_s = until_s;
    if (robot != nullptr) {
      if (control_->state().mode == Mode::navigate) {
        ask_strategy(records);
        robot->command(control_->update(*robot, PointObstacles(navigator_->points()), host_s));
      } else {
        note_wall(WallSide::unknown, records);
        if (navigator_) navigator_->rest(source_->time_s(), robot->T_world_base().position);
        robot->command(control_->update(*robot, obstacles_, host_s));
      }
      note_commands(records);
      if (until_s - source_->time_s() > longest_step_s + same_time_s) next_s = source_->time_s() + longest_step_s;
    }
    const std::size_t first = records.size();
    if (const Result<void> advanced = source_->advance(next_s, records); !advanced) return advanced;
    for (std::size_t k = first; k < records.size(); ++k) heed(records[k]);
    if (source_->time_s() < next_s) return {};  // it is over, or holds its breath
  }
  return {};
}

/// Asks at a steady rate, and notes in the log which wall is followed.
void LiveRobot::ask_strategy(std::vector<Record>& records) {
  constexpr double steering_period_s = 0.1;
  const Drivable& robot = *source_->drivable();
  if (source_->time_s() < next_steering_s_) return;
  next_steering_s_ += steering_period_s;
  const nav::Steering steering = navigator_->steer(source_->time_s(), robot.T_world_base(), robot.velocity());
  control_->obey(steering);
  note_wall(steering.followed.value_or(WallSide::unknown), records);
}

void LiveRobot::note_wall(WallSide side, std::vector<Record>& records) {
  if (side == noted_wall_) return;
  noted_wall_ = side;
  records.emplace_back(WallNote{.time_s = source_->time_s(), .side = side});
}

void LiveRobot::note_commands(std::vector<Record>& records) {
  const bool stopped = control_->state().reason == Reason::stopped && control_->state().mode == Mode::stand;
  const std::string_view mode = stopped ? "stop" : mode_name(control_->state());
  const bool steered = control_->state().mode == Mode::navigate;  // ten times a second: which mode it is says enough
  if (mode == noted_mode_ && (steered || control_->wanted() == noted_wanted_)) return;
  noted_mode_ = mode;
  noted_wanted_ = control_->wanted();
  records.emplace_back(CommandNote{source_->time_s(), noted_mode_, noted_wanted_});
}

void LiveRobot::heed(const Record& record) {
  if (const auto* truth = std::get_if<Truth>(&record)) T_world_true_ = truth->pose.T_world_robot;
  const bool drives = control_.has_value();
  if (navigator_) navigator_->heed(record);
  if (const auto* ping = std::get_if<Ping>(&record); ping != nullptr && drives) obstacles_.add(*ping);
  if (const auto* poll = std::get_if<Poll>(&record); poll != nullptr && drives) obstacles_.add(*poll);
  const auto* odometry = std::get_if<Odometry>(&record);
  if (odometry == nullptr) return;
  if (drives) obstacles_.add(*odometry);
  if (newest_ && odometry->time_s > newest_->time_s) {
    const Pose2 T_before_now = inverse(newest_->T_world_robot) * odometry->T_world_robot;
    const double duration_s = odometry->time_s - newest_->time_s;
    measured_ = {T_before_now.position.x / duration_s, wrap(T_before_now.heading) / duration_s};
    travelled_m_ += norm(T_before_now.position);
  }
  newest_ = *odometry;
  T_world_robot_ = odometry->T_world_robot;
}

RobotVelocity LiveRobot::velocity() const {
  const Drivable* robot = source_->drivable();
  return robot != nullptr ? robot->velocity() : measured_;
}

}  // namespace echoarc::live
