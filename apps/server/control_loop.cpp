// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/control_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "host/clocks.hpp"
#include "server/strategy_modes.hpp"

namespace echoarc::server {
namespace {

/// A machine that was busy or asleep does not make up for more than this at once.
constexpr double longest_step_s = 0.25;

std::int64_t microseconds(double host_s) {
  return std::llround(host_s * 1e6);
}

live::LiveRobot robot_of(std::unique_ptr<live::Source> source, const live::ControlOptions& options,
                         std::optional<Navigation>& navigation) {
  if (!navigation) return live::LiveRobot(std::move(source), options);
  return {std::move(source), options, std::move(navigation->navigator)};
}

}  // namespace

ControlLoop::ControlLoop(std::unique_ptr<live::Source> source, const live::ControlOptions& options, double speed,
                         Host host, std::optional<Navigation> navigation)
    : host_(std::move(host)), robot_(robot_of(std::move(source), options, navigation)), speed_(speed) {
  if (const live::Drivable* drivable = robot_.source().drivable()) {
    settings_.body = {robot_.source().description().robot.radius_m, drivable->limits()};
    settings_.cruise_m_s = options.cruise_m_s;
    home_ = navigation && navigation->home ? *navigation->home : drivable->T_world_base().position;
  }
  thread_ = std::thread([this] { work(); });
}

ControlLoop::~ControlLoop() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void ControlLoop::post(std::function<void()> action) {
  {
    const std::lock_guard lock(mutex_);
    mailbox_.push_back(std::move(action));
  }
  wake_.notify_one();
}

void ControlLoop::drive(const RobotVelocity& wanted, std::optional<std::uint32_t> seq) {
  post([this, wanted, seq] {
    live::RobotControl* control = robot_.control();
    if (control == nullptr) return;
    const double now_s = host::wall_time_s();
    control->drive(wanted, now_s);
    drive_seq_ = seq;
    drive_us_ = microseconds(now_s);
  });
}

void ControlLoop::control(std::function<void(live::RobotControl&)> action) {
  post([this, action = std::move(action)] {
    if (live::RobotControl* control = robot_.control()) action(*control);
  });
}

void ControlLoop::navigate(std::string mode, std::optional<Vec2> goal) {
  post([this, mode = std::move(mode), goal] {
    if (robot_.navigator() == nullptr) return;
    settings_.goals.clear();
    if (goal) settings_.goals.push_back(*goal);
    if (mode == home_mode) settings_.goals = {home_};
    Result<std::unique_ptr<nav::Strategy>> strategy = make_mode(mode, settings_);
    if (strategy) robot_.navigate(std::move(*strategy), settings_.goals);
  });
}

void ControlLoop::play(bool playing) {
  post([this, playing] {
    playing_ = playing;
    anchor();
  });
}

void ControlLoop::set_speed(double speed) {
  post([this, speed] {
    speed_ = speed;
    anchor();
  });
}

void ControlLoop::seek(double time_s) {
  post([this, time_s] {
    live::Source& source = robot_.source();
    live::Seekable* seekable = source.seekable();
    if (seekable == nullptr) return;
    hand_over();
    if (time_s < source.time_s()) {
      seekable->seek(source.description().begin_s - 1.0);  // its first record is heard again, too
      host_.restarted();
    }
    const double end_s = source.description().end_s.value_or(time_s);
    (void)robot_.step(std::clamp(time_s, source.description().begin_s, end_s), host::wall_time_s(), records_);
    anchor();
  });
}

void ControlLoop::anchor() {
  anchor_host_s_ = host::wall_time_s();
  anchor_source_s_ = robot_.source().time_s();
}

void ControlLoop::work() {
  using Clock = std::chrono::steady_clock;
  constexpr auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s));
  constexpr auto tick = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(tick_s));
  anchor();
  auto next_step = Clock::now() + period;
  auto next_tick = Clock::now() + tick;
  for (;;) {
    std::vector<std::function<void()>> mail;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_until(lock, next_step, [&] { return closing_ || !mailbox_.empty(); });
      if (closing_) return;
      mail.swap(mailbox_);
    }
    for (const std::function<void()>& action : mail) action();
    step_to_now();
    hand_over();
    const auto now = Clock::now();
    next_step = std::max(next_step + period, now);
    if (now < next_tick) continue;
    next_tick = std::max(next_tick + tick, now);
    report();
  }
}

void ControlLoop::step_to_now() {
  const double now_s = host::wall_time_s();
  live::Source& source = robot_.source();
  const bool waits = source.seekable() != nullptr && host_.crowded();
  if (!playing_ || !broken_.empty() || source.ended() || waits) return anchor();
  double until_s = anchor_source_s_ + (now_s - anchor_host_s_) * speed_;
  if (until_s > source.time_s() + longest_step_s * speed_) {
    until_s = source.time_s() + longest_step_s * speed_;
    anchor_host_s_ = now_s;
    anchor_source_s_ = until_s;
  }
  if (const Result<void> stepped = robot_.step(until_s, now_s, records_); !stepped) broken_ = stepped.error().message;
}

void ControlLoop::hand_over() {
  if (!records_.empty()) host_.records(std::exchange(records_, {}));
}

std::shared_ptr<const Plan> ControlLoop::look_at_plan() {
  const live::RobotControl* control = robot_.control();
  if (control == nullptr || control->state().mode != live::Mode::navigate) return plan_ = nullptr;
  const std::string& strategy = control->state().strategy;
  const bool due = ticks_ % ticks_per_plan == 0 || !plan_ || plan_->strategy != strategy;
  if (due) plan_ = std::make_shared<const Plan>(Plan{strategy, robot_.navigator()->strategy()->sketch()});
  return plan_;
}

void ControlLoop::report() {
  auto status = std::make_shared<RobotStatus>();
  status->tick = ++ticks_;
  status->time_s = robot_.source().time_s();
  status->T_world_robot = robot_.T_world_robot();
  status->T_world_true = robot_.T_world_true();
  status->velocity = robot_.velocity();
  status->plan = look_at_plan();
  if (const live::RobotControl* control = robot_.control()) status->control = control->state();
  if (status->plan && !settings_.goals.empty()) status->control.goal = settings_.goals.front();
  status->playing = playing_;
  status->speed = speed_;
  status->ended = robot_.source().ended();
  status->broken = broken_;
  status->travelled_m = robot_.travelled_m();
  status->drive_seq = drive_seq_;
  status->drive_us = drive_us_;
  status->mono_us = microseconds(host::wall_time_s());
  host_.tick(std::move(status));
}

}  // namespace echoarc::server
