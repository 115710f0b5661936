// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/waypoints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoarc::live {
namespace {

constexpr double same_place_m = 0.05;
constexpr double arrived_m = 0.03;

}  // namespace

Route::Route(std::vector<Vec2> stations) : stations_(std::move(stations)) {
  closed_ = stations_.size() > 2 && norm(stations_.back() - stations_.front()) < same_place_m;
  if (closed_) stations_.pop_back();
}

void Route::restart() {
  at_.reset();
  backwards_ = false;
}

Vec2 Route::goal(Vec2 from) {
  if (!at_) {
    const auto distance_m = [&](Vec2 station) { return norm(station - from); };
    at_ = static_cast<std::size_t>(std::ranges::min_element(stations_, {}, distance_m) - stations_.begin());
  }
  return stations_[*at_];
}

Vec2 Route::next_goal() {
  const std::size_t count = stations_.size();
  const std::size_t at = at_.value_or(0);
  if (closed_) {
    at_ = (at + (backwards_ ? count - 1 : 1)) % count;
  } else {
    if (at == 0) backwards_ = false;
    if (at + 1 == count) backwards_ = true;
    at_ = backwards_ ? at - 1 : at + 1;
  }
  return stations_[*at_];
}

void Route::turn_back() {
  backwards_ = !backwards_;
  (void)next_goal();
}

bool Homing::arrived(const Pose2& T_world_base, Vec2 goal) const {
  return norm(goal - T_world_base.position) < arrived_m;
}

RobotVelocity Homing::steer(const Pose2& T_world_base, Vec2 goal, double cruise_m_s, double deceleration_m_s2,
                            const RobotLimits& limits) {
  constexpr double aimed_rad = 0.03;
  constexpr double astray_rad = 0.35;
  constexpr double gain_per_s = 1.5;
  constexpr double slowest_m_s = 0.03;
  constexpr double share_of_limits = 0.7;
  const Vec2 way = goal - T_world_base.position;
  const double aside = wrap(bearing(way) - T_world_base.heading).rad();
  turning_ = std::abs(aside) > (turning_ ? aimed_rad : astray_rad);
  if (!turning_) {
    const double distance_m = std::max(0.0, norm(way) - arrived_m);
    const double speed_m_s = std::sqrt(2.0 * share_of_limits * deceleration_m_s2 * distance_m) + slowest_m_s;
    return {std::min(speed_m_s, cruise_m_s), radians(gain_per_s * aside)};
  }
  // As fast as it can still come to rest on its aim.
  const double rate = std::sqrt(2.0 * share_of_limits * limits.turn_acceleration_per_s2.rad() * std::abs(aside));
  return {0.0, radians(std::copysign(std::min(rate, share_of_limits * limits.turn_rate_per_s.rad()), aside))};
}

}  // namespace echoarc::live
