// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/wall_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace echoarc::nav {
namespace {

constexpr double settled_m = 0.1;     // off the distance that is kept
constexpr double settled_deg = 15.0;  // off the wall's direction

/// The middle of the occupied cell that is nearest to `position`.
std::optional<Vec2> nearest_occupied(const DenseGrid<CellState>& map, Vec2 position) {
  std::optional<Vec2> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::int32_t j = 0; j < map.height(); ++j) {
    const auto row = map.row(j);
    for (std::int32_t i = 0; i < map.width(); ++i) {
      if (row[static_cast<std::size_t>(i)] != CellState::occupied) continue;
      const Vec2 centre = map.geometry().centre({i, j});
      const double squared = squared_norm(centre - position);
      if (squared >= least) continue;
      least = squared;
      nearest = centre;
    }
  }
  return nearest;
}

}  // namespace

WallFollower::WallFollower(const RobotBody& body, const WallFollowerOptions& options)
    : body_(body),
      options_(options),
      side_(options.left ? WallSide::left : WallSide::right),
      watch_(body.limits),
      recovery_(body) {}

Steering WallFollower::end(Status status, std::string reason) {
  ended_ = Steering{{}, status, std::move(reason)};
  return *ended_;
}

Steering WallFollower::update(const Surroundings& surroundings) {
  if (ended_) return *ended_;
  if (std::string fault = watch_.fault(surroundings); !fault.empty()) return end(Status::failed, std::move(fault));
  const Pose2& T_world_base = surroundings.T_world_base;
  keep_account(T_world_base);
  if (loop_.round(options_.close_m, options_.least_loop_m))
    return end(Status::finished, "round: the start is reached again");
  if (loop_.travel_m() > options_.longest_m) return end(Status::failed, "no way round: the longest way is driven");
  Steering steering = steer(surroundings);
  if (steering.status != Status::running) return end(steering.status, std::move(steering.reason));
  if (auto way_out = recovery_.update(surroundings, steering.wanted)) {
    if (way_out->status != Status::running) return end(way_out->status, std::move(way_out->reason));
    forget_wall();
    way_out->followed = steering.followed;
    return *way_out;
  }
  steering.wanted = safe_velocity(T_world_base, steering.wanted, body_.radius_m, surroundings.points);
  return steering;
}

void WallFollower::keep_account(const Pose2& T_world_base) {
  loop_.drive_to(T_world_base);
  unseen_m_ += loop_.step_m();
  past_edge_m_ += loop_.step_m();
  if (lost_) approach_m_ += loop_.step_m();
}

Steering WallFollower::steer(const Surroundings& surroundings) {
  const Pose2& T_world_base = surroundings.T_world_base;
  const auto nearest = nearest_of(T_world_base.position, surroundings.points);
  if (!nearest) return approach(surroundings, {});
  silent_since_s_.reset();
  const SectorMinima minima = sector_minima(T_world_base, side_, surroundings.points);
  look_for_wall(T_world_base, minima);
  if (!lost_ && at_corner(minima.front_m)) rounding_ = true;
  if (rounding_) return around_edge(T_world_base, *edge_, minima.front_m);
  // Begun, the turn goes on until what was ahead is about abreast.
  constexpr double further_m = 0.1;
  turning_away_ = minima.front_m < options_.turn_away_m ||
                  (turning_away_ && (minima.front_m < options_.turn_away_m + further_m ||
                                     minima.front_side_m < options_.distance_m + further_m));
  if (minima.front_m < options_.stop_m) return turn_away(0.0, "turning away on the spot");
  if (turning_away_) return turn_away(options_.slow_m_s, "turning away");
  return lost_ ? approach(surroundings, nearest) : along_wall(T_world_base, minima);
}

/// Whether the wall has ended for good. With something ahead the way round its end is the way to go on.
bool WallFollower::at_corner(double front_m) const {
  if (beside_ || goes_on_ || !edge_) return false;
  return past_edge_m_ > (front_m < options_.turn_away_m ? options_.corner_m : options_.gap_m);
}

/// Whether a wall is there, and whether it still is the one that was abreast: what lies beyond a gap that a robot can
/// turn into is another.
void WallFollower::look_for_wall(const Pose2& T_world_base, const SectorMinima& minima) {
  constexpr double behind_m = 0.05;
  constexpr double other_face_m = 0.2;
  beside_ = minima.side_m <= options_.wall_within_m;
  goes_on_ = minima.front_side_m <= options_.wall_within_m &&
             (!edge_ || norm(minima.front_side_point - *edge_) <= options_.wall_within_m);
  if (beside_ && rounding_ && edge_) rounding_ = norm(minima.side_point - *edge_) < other_face_m;
  if (beside_ && !rounding_) {
    edge_ = minima.side_point;
    wall_.add(minima.side_point);
    if (dot(minima.side_point - T_world_base.position, unit(T_world_base.heading)) > -behind_m) past_edge_m_ = 0.0;
  }
  if (goes_on_ && !rounding_) past_edge_m_ = 0.0;
  if (beside_ || goes_on_) {
    unseen_m_ = 0.0;
    lost_ = false;
  } else if (unseen_m_ > options_.lost_m && !lost_) {
    lost_ = true;
    approach_m_ = 0.0;
    forget_wall();
  }
}

void WallFollower::forget_wall() {
  wall_.clear();
  edge_.reset();
  rounding_ = false;
  mapped_wall_.reset();
}

Steering WallFollower::turn_away(double forward_m_s, std::string reason) {
  wall_.clear();
  rounding_ = false;
  Steering steering{{forward_m_s, -sign_of(side_) * options_.turn_per_s}, Status::running, std::move(reason)};
  if (!lost_) steering.followed = side_;
  return steering;
}

/// On a circle around where the wall ended; from further out on a spiral onto it.
Steering WallFollower::around_edge(const Pose2& T_world_base, Vec2 edge, double front_m) {
  constexpr double on_spot_deg = 60.0;
  constexpr double ahead_deg = 30.0;
  constexpr double inwards_rad_per_m = 2.0;
  constexpr double most_inwards_rad = 0.9;
  constexpr double gain_per_s = 1.5;
  const double side = sign_of(side_);
  const Vec2 towards = edge - T_world_base.position;
  const double away_m = norm(towards);
  const double inwards =
      std::clamp(inwards_rad_per_m * (away_m - options_.distance_m), -most_inwards_rad, most_inwards_rad);
  const Angle wanted = bearing(towards) + side * radians(inwards - 0.5 * std::numbers::pi);
  const Angle astray = wrap(wanted - T_world_base.heading);
  // What it turns towards may be near until it has turned past it; what then is ahead is a wall of its own.
  if (front_m < options_.turn_away_m && abs(astray) < degrees(ahead_deg))
    return turn_away(front_m < options_.stop_m ? 0.0 : options_.slow_m_s, "turning away");
  wall_.clear();
  loop_.settled(std::abs(away_m - options_.distance_m) < settled_m && abs(astray) < degrees(settled_deg));
  const double v_m_s = std::min(options_.cruise_m_s, body_.limits.speed_m_s);
  const double rate = side * v_m_s / std::max(away_m, body_.radius_m) + gain_per_s * astray.rad();
  const double most = std::min(options_.turn_per_s, body_.limits.turn_rate_per_s).rad();
  const double share = std::max(0.0, 1.0 - std::abs(astray.deg()) / on_spot_deg);
  Steering steering{{share * v_m_s, radians(std::clamp(rate, -most, most))}, Status::running, "around a corner"};
  steering.followed = side_;
  return steering;
}

/// The direction of the wall. Before there is a line, a near wall whose nearest point is ahead of abreast is approached
/// at a slant: it is square to the way to that point.
std::optional<Angle> WallFollower::wall_direction(const Pose2& T_world_base, const SectorMinima& minima) const {
  if (const auto line = wall_.direction(T_world_base.heading)) return line;
  constexpr double near_m = 0.15;
  const bool ahead = minima.front_side_m < minima.side_m;
  const Vec2 to_nearest = (ahead ? minima.front_side_point : minima.side_point) - T_world_base.position;
  const double nearest_m = std::min(minima.front_side_m, minima.side_m);
  if (!(nearest_m < options_.distance_m + near_m)) return {};
  const Angle direction = bearing(to_nearest) - sign_of(side_) * degrees(90.0);
  const double away = -sign_of(side_) * wrap(direction - T_world_base.heading).rad();
  return away > degrees(10.0).rad() ? std::optional(direction) : std::nullopt;
}

Steering WallFollower::along_wall(const Pose2& T_world_base, const SectorMinima& minima) {
  const double passage_m = minima.side_m + minima.other_side_m;
  const double distance_m = std::min(options_.distance_m, 0.5 * passage_m);
  const auto direction = wall_direction(T_world_base, minima);
  const Angle along = direction.value_or(T_world_base.heading);
  const double aslant = wrap(along - T_world_base.heading).rad();
  double error_m = 0.0;
  if (beside_)
    error_m = minima.side_m - distance_m;
  else if (goes_on_)
    error_m = std::abs(cross(unit(along), minima.front_side_point - T_world_base.position)) - distance_m;
  loop_.settled(beside_ && direction && std::abs(error_m) < settled_m && std::abs(aslant) < degrees(settled_deg).rad());
  const double v_m_s = std::min(options_.cruise_m_s, body_.limits.speed_m_s);
  const double rate =
      sign_of(side_) * options_.distance_gain_per_m2 * v_m_s * error_m + options_.direction_gain_per_s * aslant;
  const double most = std::min(options_.turn_per_s, body_.limits.turn_rate_per_s).rad();
  Steering steering{{v_m_s, radians(std::clamp(rate, -most, most))}, Status::running, "along the wall"};
  if (beside_ || goes_on_) steering.followed = side_;
  return steering;
}

/// The nearest wall of the map, looked up once for every time it is needed: a map may be large.
std::optional<Vec2> WallFollower::mapped_wall(const Surroundings& surroundings) {
  if (!mapped_wall_ && surroundings.map != nullptr)
    mapped_wall_ = nearest_occupied(*surroundings.map, surroundings.T_world_base.position);
  return mapped_wall_;
}

Steering WallFollower::approach(const Surroundings& surroundings, const std::optional<Vec2>& nearest) {
  constexpr double far_m = 20.0;
  constexpr double aimed_deg = 30.0;
  constexpr double gain_per_s = 1.5;
  if (!nearest) {
    if (!silent_since_s_) silent_since_s_ = surroundings.time_s;
    // The first echoes may be late, and what a robot drives without any it drives blindly. A turn is safe, and lets
    // methods that compare arcs of several places make something of them.
    constexpr double looking_around_rad_s = 0.3;
    if (surroundings.time_s - *silent_since_s_ < options_.patience_s)
      return {{0.0, radians(sign_of(side_) * looking_around_rad_s)}, Status::running, "waiting for an echo"};
    lost_ = true;
  }
  const auto wall = nearest ? nearest : mapped_wall(surroundings);
  if (!wall) return {{}, Status::failed, "the wall is lost: nothing is heard, and no wall is known"};
  if (approach_m_ > far_m) return {{}, Status::failed, "the wall is lost: none was reached"};
  const Pose2& T_world_base = surroundings.T_world_base;
  const Angle aside = wrap(bearing(*wall - T_world_base.position) - T_world_base.heading);
  const double most = std::min(options_.turn_per_s, body_.limits.turn_rate_per_s).rad();
  const double rate = std::clamp(gain_per_s * aside.rad(), -most, most);
  const double forward_m_s = abs(aside) < degrees(aimed_deg) ? options_.cruise_m_s : 0.0;
  return {{forward_m_s, radians(rate)}, Status::running, "to the nearest wall"};
}

Sketch WallFollower::sketch() const {
  Sketch sketch;
  if (loop_.T_world_start()) sketch.nodes.push_back({loop_.T_world_start()->position, "start"});
  return sketch;
}

}  // namespace echoarc::nav
