// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/robot_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace echoarc::live {
namespace {

// Beside an obstacle the robot creeps, however near it is: it must be able to leave.
constexpr double creep_m_s = 0.1;
// Slower is standing still.
constexpr double still_m_s = 0.02;

double finite_or_zero(double value) {
  return std::isfinite(value) ? value : 0.0;
}

/// The fastest from which a robot can come to rest within a way.
double fastest(double way_m, double deceleration_m_s2) {
  return std::sqrt(2.0 * deceleration_m_s2 * std::max(0.0, way_m));
}

bool same_side(double a, double b) {
  return (a > 0.0) == (b > 0.0);
}

}  // namespace

std::string_view mode_name(const ControlState& state) {
  constexpr std::array<std::string_view, 4> names{"stand", "drive", "tour", "goto"};
  return state.mode == Mode::navigate ? std::string_view(state.strategy) : names[static_cast<std::size_t>(state.mode)];
}

std::string_view name(Reason reason) {
  constexpr std::array<std::string_view, 8> names{"",         "arrived", "blocked",  "obstacle",
                                                  "dead man", "stopped", "finished", "failed"};
  return names[static_cast<std::size_t>(reason)];
}

RobotControl::RobotControl(const ControlOptions& options, double hull_radius_m, std::vector<Vec2> tour)
    : options_(options), hull_radius_m_(hull_radius_m), route_(std::move(tour)) {}

void RobotControl::start(Mode mode, Reason reason) {
  state_.mode = mode;
  state_.reason = reason;
  state_.goal.reset();
  state_.strategy.clear();
  state_.detail.clear();
  wanted_ = {};
  driven_s_.reset();
  held_s_.reset();
  backing_until_s_.reset();
  held_ = false;
  hard_ = false;
}

void RobotControl::brake(Reason reason) {
  start(Mode::stand, reason);
  hard_ = true;
}

void RobotControl::drive(const RobotVelocity& wanted, double host_s) {
  const RobotVelocity finite{finite_or_zero(wanted.forward_m_s), radians(finite_or_zero(wanted.turn_per_s.rad()))};
  // Letting go of the stick is no wish to drive on: who stopped the robot stays in force.
  if (state_.mode != Mode::drive && state_.reason == Reason::stopped && finite == RobotVelocity{}) return;
  if (state_.mode != Mode::drive) start(Mode::drive);
  wanted_ = finite;
  driven_s_ = host_s;
}

void RobotControl::driver_gone() {
  driven_s_.reset();
}

void RobotControl::stand() {
  start(Mode::stand);
}

void RobotControl::tour() {
  if (!route_.stations()) return start(Mode::stand, Reason::blocked);
  start(Mode::tour);
  route_.restart();
}

void RobotControl::go_to(Vec2 goal) {
  if (!is_finite(goal)) return start(Mode::stand, Reason::blocked);
  start(Mode::go_to);
  state_.goal = goal;
}

void RobotControl::navigate(std::string strategy) {
  start(Mode::navigate);
  state_.strategy = std::move(strategy);
}

void RobotControl::obey(const nav::Steering& steering) {
  if (state_.mode != Mode::navigate) return;
  if (steering.status != nav::Status::running) {
    std::string strategy = std::move(state_.strategy);
    start(Mode::stand, steering.status == nav::Status::finished ? Reason::finished : Reason::failed);
    state_.strategy = std::move(strategy);
  } else {
    wanted_ = {finite_or_zero(steering.wanted.forward_m_s), radians(finite_or_zero(steering.wanted.turn_per_s.rad()))};
  }
  state_.detail = steering.reason;
}

void RobotControl::stop() {
  brake(Reason::stopped);
}

void RobotControl::unattended() {
  brake(Reason::dead_man);
}

MotorCommand RobotControl::update(const Drivable& robot, const Obstacles& obstacles, double host_s) {
  const bool alive = driven_s_ && host_s - *driven_s_ < options_.dead_man_s;
  if (state_.mode == Mode::drive && !alive) brake(Reason::dead_man);
  watch_blockade(host_s);
  const RobotVelocity wanted = steer(robot, host_s);
  return limited(wanted, robot, obstacles);
}

/// An obstacle that does not go away ends a way: to the point that was given, or to this station.
void RobotControl::watch_blockade(double host_s) {
  constexpr double patience_s = 3.0;
  if (!held_ || (state_.mode != Mode::tour && state_.mode != Mode::go_to)) {
    held_s_.reset();
    return;
  }
  if (!held_s_) held_s_ = host_s;
  if (host_s - *held_s_ < patience_s) return;
  if (state_.mode == Mode::go_to) return start(Mode::stand, Reason::blocked);
  held_s_.reset();
  state_.reason = Reason::blocked;
  route_.turn_back();
  // From a little further away noise that looked like an obstacle is heard through.
  constexpr double backing_s = 3.0;
  backing_until_s_ = host_s + backing_s;
}

/// What the mode wants, whatever stands in the way.
RobotVelocity RobotControl::steer(const Drivable& robot, double host_s) {
  if (state_.mode == Mode::drive || state_.mode == Mode::navigate) return wanted_;
  if (state_.mode == Mode::stand) return {};
  if (backing_until_s_ && host_s < *backing_until_s_) return {-creep_m_s, Angle{}};
  backing_until_s_.reset();
  const Pose2 T_world_base = robot.T_world_base();
  if (state_.mode == Mode::tour) {
    state_.goal = route_.goal(T_world_base.position);
    if (homing_.arrived(T_world_base, *state_.goal)) {
      state_.reason = Reason::none;
      state_.goal = route_.next_goal();
    }
  } else if (homing_.arrived(T_world_base, *state_.goal)) {
    const Vec2 goal = *state_.goal;
    start(Mode::stand, Reason::arrived);
    state_.goal = goal;
    return {};
  }
  return homing_.steer(T_world_base, *state_.goal, options_.cruise_m_s, options_.deceleration_m_s2, robot.limits());
}

RobotControl::Cap RobotControl::cap_along(const Drivable& robot, const Obstacles& obstacles,
                                          const RobotVelocity& velocity) const {
  const Pose2 T_world_base = robot.T_world_base();
  const double most_m_s = robot.limits().speed_m_s;
  const double clearance_m = options_.clearance_m;
  Cap cap{most_m_s, obstacles.free_along(T_world_base, velocity, hull_radius_m_)};
  // What a single echo tells of may be noise: it is time to brake for it when the hard deceleration is needed. Until
  // then the next ping will have told.
  const auto sure_m = obstacles.free_along(T_world_base, velocity, hull_radius_m_, 2);
  if (sure_m) cap.speed_m_s = std::min(cap.speed_m_s, fastest(*sure_m - clearance_m, options_.deceleration_m_s2));
  if (cap.free_m)
    cap.speed_m_s = std::min(cap.speed_m_s, fastest(*cap.free_m - clearance_m, options_.stop_deceleration_m_s2));
  // A wall met at a slant is heard only beside the robot, never where its hull will touch it: what passes closely slows
  // the robot down as if it stood ahead, so that the next pings are in time.
  const auto aside_m = obstacles.free_along(T_world_base, velocity, hull_radius_m_ + clearance_m);
  if (aside_m)
    cap.speed_m_s = std::min(cap.speed_m_s, std::max(creep_m_s, fastest(*aside_m, options_.deceleration_m_s2)));
  return cap;
}

/// The command that obeys the motors' limits and the cap, of the arc that is wanted and of the one the robot is on.
MotorCommand RobotControl::limited(const RobotVelocity& wanted, const Drivable& robot, const Obstacles& obstacles) {
  const RobotLimits limits = robot.limits();
  const RobotVelocity now = robot.velocity();
  MotorCommand command;
  command.wanted.forward_m_s = std::clamp(wanted.forward_m_s, -limits.speed_m_s, limits.speed_m_s);
  command.wanted.turn_per_s = std::clamp(wanted.turn_per_s, -limits.turn_rate_per_s, limits.turn_rate_per_s);
  const double asked_m_s = std::abs(command.wanted.forward_m_s);

  // Who stands is told what is ahead.
  Cap cap = cap_along(robot, obstacles, asked_m_s > 0.0 ? command.wanted : RobotVelocity{1.0, Angle{}});
  state_.free_ahead_m = cap.free_m;
  bool too_fast = false;
  if (now.forward_m_s != 0.0) {
    const Cap on_arc = cap_along(robot, obstacles, now);
    too_fast = std::abs(now.forward_m_s) > on_arc.speed_m_s;
    if (asked_m_s > 0.0 && same_side(now.forward_m_s, command.wanted.forward_m_s))
      cap.speed_m_s = std::min(cap.speed_m_s, on_arc.speed_m_s);
  }
  state_.limit_m_s = cap.speed_m_s;
  state_.limited_by_obstacle = asked_m_s > cap.speed_m_s;
  held_ = state_.limited_by_obstacle && cap.speed_m_s < still_m_s;
  if (held_)
    command.wanted.forward_m_s = 0.0;
  else if (state_.limited_by_obstacle)
    command.wanted.forward_m_s = std::copysign(cap.speed_m_s, command.wanted.forward_m_s);
  // The cap falls no faster than the gentle deceleration; only what appears suddenly needs the hard one.
  const bool hard = hard_ || too_fast || state_.limited_by_obstacle;
  command.deceleration_m_s2 = hard ? options_.stop_deceleration_m_s2 : options_.deceleration_m_s2;
  if (state_.reason == Reason::none && held_) state_.reason = Reason::obstacle;
  if (state_.reason == Reason::obstacle && !held_) state_.reason = Reason::none;
  return command;
}

}  // namespace echoarc::live
