// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/local_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "echoarc/nav/free_way.hpp"

namespace echoarc::live {
namespace {

constexpr double margin_m = 0.1;            // to both sides of a range
constexpr double share_of_beam = 0.9;       // sound is weak at its rim
constexpr double share_of_beam_near = 1.2;  // a whole arc that was noise, wherever the robot has gone since
constexpr int most_hits = 100;

}  // namespace

LocalMap::LocalMap(const RobotDescription& robot, const LocalMapOptions& options) : options_(options), robot_(robot) {
  for (const Sensor& sensor : robot_.sensors.sensors()) decisions_.push_back(describe_no_echo(sensor));
  registers_m_.assign(robot_.sensors.size(), std::numeric_limits<double>::quiet_NaN());
  registers_s_.assign(robot_.sensors.size(), -std::numeric_limits<double>::infinity());
}

void LocalMap::add(const Odometry& odometry) {
  T_world_robot_ = odometry.T_world_robot;
  forget(odometry.time_s);
}

/// Echoes of other sensors' pings lie on ellipses, not on arcs; the own ones say enough.
void LocalMap::add(const Ping& ping) {
  const Sensor* sensor = robot_.sensors.find(ping.rx);
  if (sensor == nullptr || ping.tx != ping.rx || ping.echo_index > 0) return;
  hear(static_cast<std::size_t>(sensor - robot_.sensors.sensors().data()), ping.time_s, ping.range_m);
}

/// A register that has not changed may hold an echo of long ago: it is heeded anew only once in a while.
void LocalMap::add(const Poll& poll) {
  constexpr double heed_again_s = 1.0;
  if (poll.ranges_m.size() != registers_m_.size()) return;
  for (std::size_t k = 0; k < registers_m_.size(); ++k) {
    const double now_m = poll.ranges_m[k];
    const bool same = now_m == registers_m_[k] || (std::isnan(now_m) && std::isnan(registers_m_[k]));
    if (same && poll.time_s < registers_s_[k] + heed_again_s) continue;
    registers_m_[k] = now_m;
    registers_s_[k] = poll.time_s;
    hear(k, poll.time_s, now_m);
  }
}

void LocalMap::hear(std::size_t sensor, double time_s, double raw_m) {
  if (!T_world_robot_) return;
  const Sensor& by = robot_.sensors.sensors()[sensor];
  const DecodedRange decoded = decode_range(raw_m, decisions_[sensor], by.model);
  if (decoded.rejection) return;
  const Pose2 T_world_sensor = *T_world_robot_ * by.mount.T_robot_sensor();
  const std::optional<double> range_m = echo_range_m(decoded.outcome);
  if (!range_m && !is_no_echo(decoded.outcome)) return;
  hear_through(by, T_world_sensor, range_m.value_or(by.model.trusted_range_m), !range_m);
  if (range_m) add_arc(by, T_world_sensor, *range_m, time_s);
}

void LocalMap::add_arc(const Sensor& sensor, const Pose2& T_world_sensor, double range_m, double time_s) {
  if (range_m > options_.reach_m + norm(sensor.mount.T_robot_sensor().position)) return;
  const Angle beam = sensor.model.beam_width;
  const int steps = std::max(1, static_cast<int>(std::ceil(range_m * beam.rad() / options_.spacing_m)));
  for (int k = 0; k <= steps; ++k) {
    const Angle aside = (static_cast<double>(k) / steps - 0.5) * beam;
    const Vec2 place = T_world_sensor * (range_m * unit(aside));
    Point& point = points_[cell_of(place)];
    const bool same_arc = point.hits > 0 && point.time_s == time_s;
    const int hits = same_arc ? point.hits : std::min(heard_before(place, time_s) + 1, most_hits);
    point = {.place = place, .time_s = time_s, .doubts = 0, .hits = hits};
  }
}

/// How often something was heard here; that it was beside tells as much of a new point as if it had been here once.
int LocalMap::heard_before(Vec2 place, double time_s) const {
  const auto here = points_.find(cell_of(place));
  if (here != points_.end() && here->second.hits > 0) return here->second.hits;
  for (int row = -1; row <= 1; ++row)
    for (int column = -1; column <= 1; ++column) {
      const auto found = points_.find(cell_of(place + options_.spacing_m * Vec2{double(column), double(row)}));
      if (found != points_.end() && found->second.hits > 0 && found->second.time_s < time_s) return 1;
    }
  return 0;
}

/// How often something was heard here and right beside.
int LocalMap::hits_around(Vec2 place) const {
  int hits = 0;
  for (int row = -1; row <= 1; ++row)
    for (int column = -1; column <= 1; ++column) {
      const auto found = points_.find(cell_of(place + options_.spacing_m * Vec2{double(column), double(row)}));
      if (found != points_.end()) hits += found->second.hits;
    }
  return hits;
}

/// Whether one more reading that hears through a point is one too many. A single echo may be noise. What is too near to
/// be heard goes only if it never was heard well: the sensor is as good as deaf to a wall that it stands before.
bool LocalMap::doubtful(Point& point, bool too_near) const {
  constexpr int well_heard = 10;  // by three arcs or so, each with three cells of the nine
  constexpr int near_doubts = 4;
  ++point.doubts;
  if (too_near) return point.doubts >= near_doubts && hits_around(point.place) < well_heard;
  return point.doubts >= std::min(point.hits, options_.doubts);
}

/// Points well inside the sector are not where the echo came from. Silence tells nothing of what is too near.
void LocalMap::hear_through(const Sensor& sensor, const Pose2& T_world_sensor, double free_m, bool silent) {
  const double near_m = sensor.model.range_min_m + margin_m;
  const double to_m = free_m - margin_m;
  const Vec2 axis = unit(T_world_sensor.heading);
  const double least = cos(0.5 * share_of_beam * sensor.model.beam_width);
  const double least_near = cos(0.5 * share_of_beam_near * sensor.model.beam_width);
  const auto heard_through = [&](Point& point) {
    const Vec2 there = point.place - T_world_sensor.position;
    const double along_m = dot(there, axis);
    if (along_m <= 0.0 || along_m > to_m) return false;
    const double distance_m = norm(there);
    const bool too_near = distance_m < near_m;
    if (distance_m > to_m || along_m < (too_near ? least_near : least) * distance_m) return false;
    if (too_near && silent) return false;
    return doubtful(point, too_near);
  };
  for (auto entry = points_.begin(); entry != points_.end();)
    entry = heard_through(entry->second) ? points_.erase(entry) : std::next(entry);
}

/// Old points, far ones, and those where the robot itself is. What is beside the hull is not heard any more, but there.
void LocalMap::forget(double time_s) {
  constexpr double certainly_inside = 0.9;
  constexpr double beside_m = 0.3;
  const Vec2 here = T_world_robot_->position;
  const double inside_m = certainly_inside * robot_.radius_m;
  const double near_m = robot_.radius_m + beside_m;
  const double far_m = 1.5 * options_.reach_m;
  std::erase_if(points_, [&](const auto& entry) {
    const double squared = squared_norm(entry.second.place - here);
    if (squared < inside_m * inside_m || squared > far_m * far_m) return true;
    return squared > near_m * near_m && entry.second.time_s < time_s - options_.memory_s;
  });
}

std::optional<double> LocalMap::free_along(const Pose2& T_world_base, const RobotVelocity& velocity,
                                           double hull_radius_m, int least_hits) const {
  nav::FreeWay way(T_world_base, velocity, hull_radius_m, look_m);
  for (const auto& [cell, point] : points_)
    if (point.hits >= least_hits) way.meet(point.place);
  return way.free_m();
}

std::vector<Vec2> LocalMap::points() const {
  std::vector<Vec2> places;
  places.reserve(points_.size());
  for (const auto& [cell, point] : points_) places.push_back(point.place);
  return places;
}

std::uint64_t LocalMap::cell_of(Vec2 place) const {
  const auto index = [&](double coordinate) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(coordinate / options_.spacing_m)));
  };
  return (std::uint64_t{index(place.x)} << 32) | index(place.y);
}

}  // namespace echoarc::live
