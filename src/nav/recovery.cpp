// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/recovery.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "echoarc/nav/side_wall.hpp"

namespace echoarc::nav {
namespace {

constexpr double still_m_s = 0.02;  // slower is standing

std::string in_metres(double way_m) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), way_m, std::chars_format::fixed, 1).ptr;
  return std::string(text.data(), end) + " m";
}

}  // namespace

std::string PoseWatch::fault(const Surroundings& surroundings) {
  constexpr double slack = 1.5;    // of what the limits allow: odometry is not exact
  constexpr double slack_m = 0.3;  // a localisation may correct so much at once
  constexpr double slack_deg = 30.0;
  const Pose2& T_world_base = surroundings.T_world_base;
  if (!std::isfinite(surroundings.time_s)) return "the time is no number";
  if (!is_finite(T_world_base)) return "the pose is no number";
  const auto before = before_;
  before_ = Moment{surroundings.time_s, T_world_base};
  if (!before) return {};
  const double step_s = surroundings.time_s - before->time_s;
  if (step_s < 0.0) return "time runs backwards";
  const double way_m = norm(T_world_base.position - before->T_world_base.position);
  if (way_m > slack * limits_.speed_m_s * step_s + slack_m) return "the pose jumped by " + in_metres(way_m);
  const double turn_deg = std::abs(wrap(T_world_base.heading - before->T_world_base.heading).deg());
  if (turn_deg > slack * limits_.turn_rate_per_s.deg() * step_s + slack_deg) return "the heading jumped";
  return {};
}

Recovery::Recovery(const RobotBody& body, const RecoveryOptions& options, const SafetyOptions& safety)
    : body_(body), options_(options), safety_(safety) {}

void Recovery::reset() {
  *this = Recovery(body_, options_, safety_);
}

bool Recovery::stuck(const Surroundings& surroundings, const RobotVelocity& wanted) {
  constexpr double longest_step_s = 1.0;
  const double step_s = std::clamp(surroundings.time_s - last_s_, 0.0, longest_step_s);
  last_s_ = surroundings.time_s;
  const Pose2& T_world_base = surroundings.T_world_base;
  if (!T_world_still_ || norm(T_world_base.position - T_world_still_->position) >= options_.progress_m) {
    T_world_still_ = T_world_base;
    driving_s_ = 0.0;
    wanting_s_ = 0.0;
    return false;
  }
  const bool driving = std::abs(wanted.forward_m_s) > still_m_s;
  if (driving) driving_s_ += step_s;
  if (driving || wanted.turn_per_s != Angle{}) wanting_s_ += step_s;
  return driving_s_ >= options_.stuck_s || wanting_s_ >= options_.turning_s;
}

void Recovery::begin(Phase phase, const Surroundings& surroundings) {
  phase_ = phase;
  began_s_ = surroundings.time_s;
  T_world_began_ = surroundings.T_world_base;
}

void Recovery::begin_try(const Surroundings& surroundings) {
  const Vec2 here = surroundings.T_world_base.position;
  if (!tried_at_ || norm(here - *tried_at_) > options_.away_m) {
    tried_at_ = here;
    tries_ = 0;
  }
  const auto nearest = nearest_of(here, surroundings.points);
  const bool left = nearest && cross(unit(surroundings.T_world_base.heading), *nearest - here) > 0.0;
  // Away from what is nearest; if that was of no use, the other way the next time.
  turn_side_ = left == (tries_ % 2 == 0) ? -1.0 : 1.0;
  begin(tries_ < options_.tries ? Phase::backing : Phase::given_up, surroundings);
  ++tries_;
}

bool Recovery::backed_off(const Surroundings& surroundings, const RobotVelocity& back) const {
  const double longest_s = 2.0 * options_.back_off_m / options_.back_off_m_s + 2.0;
  return std::abs(back.forward_m_s) < still_m_s || surroundings.time_s - began_s_ > longest_s ||
         norm(surroundings.T_world_base.position - T_world_began_.position) >= options_.back_off_m;
}

bool Recovery::turned(const Surroundings& surroundings) const {
  const double longest_s = 2.0 * (options_.turn / options_.turn_per_s) + 2.0;
  const Angle turn = abs(wrap(surroundings.T_world_base.heading - T_world_began_.heading));
  return turn >= options_.turn - degrees(3.0) || surroundings.time_s - began_s_ > longest_s;
}

Steering Recovery::given_up() const {
  return {{}, Status::failed, "stuck: no way on after " + std::to_string(tries_ - 1) + " tries to back off and turn"};
}

std::optional<Steering> Recovery::update(const Surroundings& surroundings, const RobotVelocity& wanted) {
  if (phase_ == Phase::watching) {
    if (!stuck(surroundings, wanted)) return {};
    begin_try(surroundings);
  }
  if (phase_ == Phase::backing) {
    const RobotVelocity back = safe_velocity(surroundings.T_world_base, {-options_.back_off_m_s, Angle{}},
                                             body_.radius_m, surroundings.points, safety_);
    if (!backed_off(surroundings, back)) return Steering{.wanted = back, .reason = "stuck: backing off"};
    begin(Phase::turning, surroundings);
  }
  if (phase_ == Phase::turning) {
    if (!turned(surroundings))
      return Steering{.wanted = {0.0, turn_side_ * options_.turn_per_s}, .reason = "stuck: turning"};
    begin(Phase::watching, surroundings);
    T_world_still_.reset();
    last_s_ = surroundings.time_s;
    return {};
  }
  return given_up();
}

}  // namespace echoarc::nav
