// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/acceleration.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::nav {
namespace {

double finite_or_zero(double value) {
  return std::isfinite(value) ? value : 0.0;
}

double ramp(double now, double wanted, double most, double most_change) {
  const double target = std::clamp(finite_or_zero(wanted), -most, most);
  const double from = finite_or_zero(now);
  return from + std::clamp(target - from, -most_change, most_change);
}

}  // namespace

double speed_cap_m_s(double free_m, double stop_distance_m, double deceleration_m_s2) {
  const double way_m = free_m - stop_distance_m;
  return way_m > 0.0 ? std::sqrt(2.0 * deceleration_m_s2 * way_m) : 0.0;
}

double stopping_distance_m(double speed_m_s, double deceleration_m_s2) {
  return speed_m_s * speed_m_s / (2.0 * deceleration_m_s2);
}

RobotVelocity accelerated(const RobotVelocity& now, const RobotVelocity& wanted, const RobotLimits& limits,
                          double step_s) {
  const double time_s = std::max(0.0, finite_or_zero(step_s));
  return {ramp(now.forward_m_s, wanted.forward_m_s, limits.speed_m_s, limits.acceleration_m_s2 * time_s),
          radians(ramp(now.turn_per_s.rad(), wanted.turn_per_s.rad(), limits.turn_rate_per_s.rad(),
                       limits.turn_acceleration_per_s2.rad() * time_s))};
}

}  // namespace echoarc::nav
