// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "echoarc/live/live_robot.hpp"
#include "echoarc/nav/strategies.hpp"

namespace echoarc::server {

/// What the strategy that drives has in mind.
struct Plan {
  std::string strategy;
  nav::Sketch sketch;
};

/// With what a robot finds its way by itself.
struct Navigation {
  live::Navigator navigator;
  std::optional<Vec2> home;  ///< in the odometry's frame; none: where it is now
};

/// How the robot is at one tick. Times of the host are CLOCK_MONOTONIC.
struct RobotStatus {
  std::uint64_t tick = 0;
  double time_s = 0.0;
  std::int64_t mono_us = 0;
  std::optional<Pose2> T_world_robot;
  std::optional<Pose2> T_world_true;
  RobotVelocity velocity;
  live::ControlState control;  ///< as it was made, for what cannot be driven
  bool playing = true;
  double speed = 1.0;
  bool ended = false;  ///< nothing follows
  std::string broken;  ///< why the source says no more; else empty
  double travelled_m = 0.0;
  std::optional<std::uint32_t> drive_seq;  ///< of the newest command that reached the robot
  std::int64_t drive_us = 0;               ///< when it did
  std::shared_ptr<const Plan> plan;        ///< null: no strategy drives; the same until it is looked at anew
};

/// Steps a robot as real time passes, on a thread of its own that waits for nobody: every 10 ms, and at once when a
/// command comes.
class ControlLoop {
 public:
  static constexpr double period_s = 0.01;
  static constexpr double tick_s = 0.1;
  static constexpr int ticks_per_plan = 5;  ///< plans are looked at twice a second

  /// All are called on the loop's thread.
  struct Host {
    std::function<void(std::vector<live::Record>&&)> records;
    std::function<void()> restarted;  ///< a log jumped back: what follows starts anew
    std::function<void(std::shared_ptr<const RobotStatus>)> tick;
    std::function<bool()> crowded;  ///< whether records wait that nobody took; a log then waits, a robot does not
  };

  ControlLoop(std::unique_ptr<live::Source> source, const live::ControlOptions& options, double speed, Host host,
              std::optional<Navigation> navigation = {});
  ControlLoop(const ControlLoop&) = delete;
  ControlLoop& operator=(const ControlLoop&) = delete;
  ~ControlLoop();

  void drive(const RobotVelocity& wanted, std::optional<std::uint32_t> seq);
  /// Whatever else is done with the control; nothing for a source that cannot be driven.
  void control(std::function<void(live::RobotControl&)> action);
  /// Starts one of `strategy_modes`; nothing without navigation. `goal`: of "goto".
  void navigate(std::string mode, std::optional<Vec2> goal);
  void play(bool playing);
  void set_speed(double speed);
  void seek(double time_s);

 private:
  void post(std::function<void()> action);
  void work();
  void step_to_now();
  void hand_over();
  void report();
  [[nodiscard]] std::shared_ptr<const Plan> look_at_plan();
  void anchor();

  Host host_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<std::function<void()>> mailbox_;
  bool closing_ = false;
  // Of the thread alone:
  live::LiveRobot robot_;
  nav::StrategySettings settings_;  // of what drives, or drove last
  Vec2 home_;
  std::shared_ptr<const Plan> plan_;
  std::vector<live::Record> records_;
  double speed_;
  bool playing_ = true;
  double anchor_host_s_ = 0.0;    // when
  double anchor_source_s_ = 0.0;  // the source was there
  std::string broken_;
  std::uint64_t ticks_ = 0;
  std::optional<std::uint32_t> drive_seq_;
  std::int64_t drive_us_ = 0;
  std::thread thread_;
};

}  // namespace echoarc::server
