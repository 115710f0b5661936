// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/surface_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace echoarc::nav {

SurfaceFollower::SurfaceFollower(const RobotBody& body, const SurfaceFollowerOptions& options)
    : body_(body),
      options_(options),
      side_(options.left ? WallSide::left : WallSide::right),
      watch_(body.limits),
      recovery_(body) {}

Steering SurfaceFollower::end(Status status, std::string reason) {
  ended_ = Steering{{}, status, std::move(reason)};
  return *ended_;
}

Steering SurfaceFollower::update(const Surroundings& surroundings) {
  if (ended_) return *ended_;
  if (std::string fault = watch_.fault(surroundings); !fault.empty()) return end(Status::failed, std::move(fault));
  loop_.drive_to(surroundings.T_world_base);
  past_end_m_ += loop_.step_m();
  if (loop_.round(options_.close_m, options_.least_loop_m))
    return end(Status::finished, "round: the start is reached again");
  if (loop_.travel_m() > options_.longest_m) return end(Status::failed, "no end: the longest way is driven");
  Steering steering = steer(surroundings);
  if (steering.status != Status::running) return end(steering.status, std::move(steering.reason));
  if (auto way_out = recovery_.update(surroundings, steering.wanted)) {
    if (way_out->status != Status::running) return end(way_out->status, std::move(way_out->reason));
    surface_.clear();
    return *way_out;
  }
  steering.wanted = safe_velocity(surroundings.T_world_base, steering.wanted, body_.radius_m, surroundings.points);
  return steering;
}

Steering SurfaceFollower::steer(const Surroundings& surroundings) {
  const Pose2& T_world_base = surroundings.T_world_base;
  const SectorMinima minima = sector_minima(T_world_base, side_, surroundings.points);
  if (minima.front_m < options_.turn_away_m) {
    surface_.clear();
    return turning(-sign_of(side_) * options_.turn_per_s.rad(), "turning away");
  }
  const bool abreast = minima.side_m <= options_.within_m;
  const bool goes_on = minima.front_side_m <= options_.within_m;
  const bool behind = abreast && dot(minima.side_point - T_world_base.position, unit(T_world_base.heading)) < -0.3;
  if (!beside_) {
    const auto nearest = nearest_of(T_world_base.position, surroundings.points);
    beside_ = abreast && nearest && *nearest == minima.side_point;
    if (!beside_) return turn_beside(surroundings, nearest);
  }
  if ((abreast && !behind) || goes_on) past_end_m_ = 0.0;
  if (past_end_m_ >= options_.end_m) return {{}, Status::finished, "the surface ends here"};
  return along_surface(surroundings, minima);
}

Steering SurfaceFollower::turning(double rate_rad_s, std::string reason) const {
  const double most = std::min(options_.turn_per_s, body_.limits.turn_rate_per_s).rad();
  return {{0.0, radians(std::clamp(rate_rad_s, -most, most))}, Status::running, std::move(reason)};
}

/// On the spot, until the nearest point is abreast.
Steering SurfaceFollower::turn_beside(const Surroundings& surroundings, const std::optional<Vec2>& nearest) {
  constexpr double gain_per_s = 1.5;
  constexpr double looking_around_rad_s = 0.3;  // arcs of several places tell more than those of one
  const Pose2& T_world_base = surroundings.T_world_base;
  if (!nearest || norm(*nearest - T_world_base.position) > options_.within_m) {
    if (!silent_since_s_) silent_since_s_ = surroundings.time_s;
    if (surroundings.time_s - *silent_since_s_ < options_.patience_s)
      return turning(sign_of(side_) * looking_around_rad_s, "waiting for an echo");
    return {{}, Status::failed, "no surface is heard within its reach"};
  }
  silent_since_s_.reset();
  const Angle wanted = bearing(*nearest - T_world_base.position) - sign_of(side_) * degrees(90.0);
  return turning(gain_per_s * wrap(wanted - T_world_base.heading).rad(), "turning beside the surface");
}

/// The tangent of the curve where it is abreast. A tangent is square to the way to the nearest point, too, but a single
/// point is a poor witness where points are sparse.
std::optional<Angle> SurfaceFollower::tangent(const Surroundings& surroundings, const SectorMinima& minima,
                                              bool abreast) const {
  constexpr double half_length_m = 0.25;
  constexpr double least_spread_m = 0.12;
  constexpr double most_off_m = 0.06;  // curved it may be
  const Pose2& T_world_base = surroundings.T_world_base;
  if (!abreast) return surface_.direction(T_world_base.heading);
  const Vec2 ahead = unit(T_world_base.heading);
  std::vector<Vec2> curve;
  double foremost_m = 0.0;
  double hindmost_m = 0.0;
  for (const Vec2 point : surroundings.points) {
    const Vec2 off = point - minima.side_point;
    if (!(squared_norm(off) < half_length_m * half_length_m)) continue;
    curve.push_back(point);
    foremost_m = std::max(foremost_m, dot(ahead, off));
    hindmost_m = std::max(hindmost_m, -dot(ahead, off));
  }
  // A line through what lies behind alone is the tangent of a place that is passed.
  if (std::min(foremost_m, hindmost_m) > 0.5 * least_spread_m)
    if (const auto line = line_along(curve, T_world_base.heading, least_spread_m, most_off_m)) return line;
  return bearing(minima.side_point - T_world_base.position) - sign_of(side_) * degrees(90.0);
}

Steering SurfaceFollower::along_surface(const Surroundings& surroundings, const SectorMinima& minima) {
  constexpr double settled_m = 0.15;
  constexpr double settled_deg = 20.0;
  constexpr double most_towards_rad = 0.7;
  const bool abreast = minima.side_m <= options_.within_m;
  if (abreast) surface_.add(minima.side_point);
  const double error_m = abreast ? minima.side_m - options_.distance_m : 0.0;
  const auto along = tangent(surroundings, minima, abreast);
  const Angle aslant = along ? wrap(*along - surroundings.T_world_base.heading) : Angle{};
  loop_.settled(abreast && along && std::abs(error_m) < settled_m && abs(aslant) < degrees(settled_deg));
  const double v_m_s = std::min(options_.cruise_m_s, body_.limits.speed_m_s);
  const double towards = std::clamp(options_.distance_gain_per_m * error_m, -most_towards_rad, most_towards_rad);
  const double rate = options_.direction_gain_per_s * (sign_of(side_) * towards + aslant.rad());
  Steering steering = turning(rate, "along the surface");
  steering.wanted.forward_m_s = v_m_s;
  if (abreast) steering.followed = side_;
  return steering;
}

Sketch SurfaceFollower::sketch() const {
  Sketch sketch;
  if (loop_.T_world_start()) sketch.nodes.push_back({loop_.T_world_start()->position, "start"});
  return sketch;
}

}  // namespace echoarc::nav
