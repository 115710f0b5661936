// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/simulated_robot.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::sim {
namespace {

// Within one such piece speeds change by so little that the arc of their means is the path to well below a millimetre.
constexpr double longest_piece_s = 0.005;
constexpr double longest_step_s = 3600.0;

double finite_or_zero(double value) {
  return std::isfinite(value) ? value : 0.0;
}

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

/// A speed that goes to another one within `duration_s`: towards zero at one rate, away from it at another.
double approach(double from, double to, double deceleration, double acceleration, double duration_s) {
  const bool brakes = from != 0.0 && (std::abs(to) < std::abs(from) || (to > 0.0) != (from > 0.0));
  if (!brakes) return towards(from, to, acceleration * duration_s);
  const double least = (to > 0.0) == (from > 0.0) ? to : 0.0;
  const double braking_s = std::abs(from - least) / deceleration;
  if (braking_s >= duration_s) return towards(from, least, deceleration * duration_s);
  return towards(least, to, acceleration * (duration_s - braking_s));
}

/// The chord of an arc that starts along +x, per metre of its length.
Vec2 chord_share(double turn_rad) {
  if (std::abs(turn_rad) < 1e-6) return {1.0, turn_rad / 2.0};
  return {std::sin(turn_rad) / turn_rad, (1.0 - std::cos(turn_rad)) / turn_rad};
}

}  // namespace

SimulatedRobot::SimulatedRobot(const Pose2& T_world_robot, const RobotLimits& limits)
    : limits_(limits), T_world_robot_(T_world_robot), deceleration_m_s2_(limits.acceleration_m_s2) {}

void SimulatedRobot::command(const RobotVelocity& wanted, std::optional<double> deceleration_m_s2) {
  const double braking = finite_or_zero(deceleration_m_s2.value_or(0.0));
  deceleration_m_s2_ = braking > 0.0 ? braking : limits_.acceleration_m_s2;
  const double rate = limits_.turn_rate_per_s.rad();
  wanted_.forward_m_s = std::clamp(finite_or_zero(wanted.forward_m_s), -limits_.speed_m_s, limits_.speed_m_s);
  wanted_.turn_per_s = radians(std::clamp(finite_or_zero(wanted.turn_per_s.rad()), -rate, rate));
}

void SimulatedRobot::hold(Vec2 position) {
  T_world_robot_.position = position;
  velocity_.forward_m_s = 0.0;
}

void SimulatedRobot::step(double duration_s) {
  if (!(duration_s > 0.0)) return;
  const double whole_s = std::min(duration_s, longest_step_s);
  const int pieces = static_cast<int>(std::ceil(whole_s / longest_piece_s));
  const double begin_s = time_s_;
  for (int k = 1; k <= pieces; ++k) move(whole_s / pieces);
  time_s_ = begin_s + whole_s;
}

void SimulatedRobot::move(double duration_s) {
  const RobotVelocity before = velocity_;
  velocity_.forward_m_s =
      approach(before.forward_m_s, wanted_.forward_m_s, deceleration_m_s2_, limits_.acceleration_m_s2, duration_s);
  velocity_.turn_per_s = radians(
      towards(before.turn_per_s.rad(), wanted_.turn_per_s.rad(), limits_.turn_acceleration_per_s2.rad() * duration_s));
  const double way_m = 0.5 * (before.forward_m_s + velocity_.forward_m_s) * duration_s;
  const Angle turn = 0.5 * duration_s * (before.turn_per_s + velocity_.turn_per_s);
  T_world_robot_ = T_world_robot_ * Pose2{way_m * chord_share(turn.rad()), turn};
  travelled_m_ += std::abs(way_m);
}

}  // namespace echoarc::sim
