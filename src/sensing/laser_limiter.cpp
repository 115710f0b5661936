// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/laser_limiter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "echoarc/core/arc.hpp"
#include "sensing/hit_kernels.hpp"

namespace echoarc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::size_t padded(std::size_t count) {
  return (count + kernels::hit_lanes - 1) / kernels::hit_lanes * kernels::hit_lanes;
}

/// The beam of a reading, as seen from the sensor or the midpoint of two. No value when their axes are more than 90
/// degrees apart: such a reading has no arc.
std::optional<kernels::BeamCone> cone_of(const Reading& reading) {
  const Pose2& tx = reading.T_world_tx;
  const Pose2& rx = reading.T_world_rx;
  const bool mono = reading.monostatic();
  const Angle apart = mono ? Angle{} : wrap(rx.heading - tx.heading);
  if (abs(apart) > degrees(90.0) + eps_angle) return std::nullopt;
  const Vec2 apex = mono ? tx.position : 0.5 * (tx.position + rx.position);
  const Vec2 focal = mono ? Vec2{} : rx.position - apex;
  const Vec2 axis = unit(tx.heading + 0.5 * apart);
  const double slope = std::tan((0.5 * reading.beam_width + eps_angle).rad());
  return kernels::BeamCone{.apex_x = apex.x,
                           .apex_y = apex.y,
                           .axis_x = axis.x,
                           .axis_y = axis.y,
                           .slope = slope,
                           .focal_x = focal.x,
                           .focal_y = focal.y,
                           .nearest_m = reading.range_min_m};
}

/// Where the axis crosses the line from one beam's return to the next one's.
double nearest_on_axis(const kernels::BeamCone& cone, const std::vector<double>& x, const std::vector<double>& y) {
  const Vec2 apex{cone.apex_x, cone.apex_y};
  const Vec2 axis{cone.axis_x, cone.axis_y};
  const Vec2 focal{cone.focal_x, cone.focal_y};
  double best = infinity;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const Vec2 a = Vec2{x[k], y[k]} - apex;
    const Vec2 b = Vec2{x[k + 1], y[k + 1]} - apex;
    const double side_a = cross(axis, a);
    const double side_b = cross(axis, b);
    if (!(side_a * side_b <= 0.0)) continue;  // NaN ends up here, too
    const double share = side_a != side_b ? side_a / (side_a - side_b) : 0.0;
    const double along = dot(axis, a) + share * (dot(axis, b) - dot(axis, a));
    if (!(along > 0.0)) continue;
    const double half_path = 0.5 * (norm(along * axis + focal) + norm(along * axis - focal));
    if (half_path >= cone.nearest_m) best = std::min(best, half_path);
  }
  return best;
}

}  // namespace

double limit_of(const Reading& reading, LaserLimit rule, const std::vector<double>& hit_x,
                const std::vector<double>& hit_y) {
  const auto cone = cone_of(reading);
  if (!cone || rule == LaserLimit::none) return infinity;
  if (rule == LaserLimit::axis) return nearest_on_axis(*cone, hit_x, hit_y);
  return kernels::hit_kernels().nearest(*cone, hit_x.data(), hit_y.data(),
                                        hit_x.size() / kernels::hit_lanes * kernels::hit_lanes);
}

LaserLimiter::LaserLimiter(const std::vector<LaserMount>& lasers, LaserLimit rule, double max_age_s)
    : rule_(rule), max_age_s_(max_age_s) {
  for (const LaserMount& mount : lasers) lasers_.emplace_back().mount = mount;
}

std::optional<LaserLimiter::Refusal> LaserLimiter::push(const Scan& scan) {
  if (!std::isfinite(scan.time_s)) return Refusal::bad_time;
  for (Laser& laser : lasers_) {
    if (laser.mount.id != scan.laser) continue;
    if (scan.time_s <= laser.newest_s) return Refusal::backwards;
    laser.newest_s = scan.time_s;
    laser.scans.push_back(scan);
    return std::nullopt;
  }
  return Refusal::unknown_laser;
}

void LaserLimiter::choose_scan(Laser& laser, double time_s) const {
  const auto away = [&](const Scan& scan) { return std::abs(scan.time_s - time_s); };
  while (laser.scans.size() > 1 && away(laser.scans[1]) < away(laser.scans[0])) laser.scans.pop_front();
}

bool LaserLimiter::place_scan(Laser& laser, const PoseTrack& track) const {
  const Scan& scan = laser.scans.front();
  if (laser.placed_s == scan.time_s) return true;
  const auto pose = track.at(scan.time_s);
  const Pose2* T_world_robot = std::get_if<Pose2>(&pose);
  if (T_world_robot == nullptr) return false;
  const std::size_t beams = scan.ranges_m.size();
  if (laser.beam_x.size() != beams || laser.angle_min != scan.angle_min || laser.angle_step != scan.angle_step) {
    laser.angle_min = scan.angle_min;
    laser.angle_step = scan.angle_step;
    laser.beam_x.resize(beams);
    laser.beam_y.resize(beams);
    for (std::size_t k = 0; k < beams; ++k) {
      const Vec2 beam = unit(scan.angle_min + double(k) * scan.angle_step);
      laser.beam_x[k] = beam.x;
      laser.beam_y[k] = beam.y;
    }
    laser.hit_x.assign(padded(beams), nan);
    laser.hit_y.assign(padded(beams), nan);
  }
  const Pose2 T_world_laser = *T_world_robot * laser.mount.mount.T_robot_sensor();
  const Vec2 origin = T_world_laser.position;
  const Vec2 turn = unit(T_world_laser.heading);
  const double least_m = laser.mount.range_min_m;
  const double most_m = laser.mount.range_max_m;
  for (std::size_t k = 0; k < beams; ++k) {
    const double range_m = scan.ranges_m[k];
    const double r = range_m > 0.0 && range_m >= least_m && range_m < most_m ? range_m : nan;
    laser.hit_x[k] = origin.x + r * (turn.x * laser.beam_x[k] - turn.y * laser.beam_y[k]);
    laser.hit_y[k] = origin.y + r * (turn.y * laser.beam_x[k] + turn.x * laser.beam_y[k]);
  }
  laser.placed_s = scan.time_s;
  return true;
}

Reading LaserLimiter::limited(const Reading& reading, const PoseTrack& track) {
  const bool silent = is_no_echo(reading.outcome);
  if (!silent && !echo_range_m(reading.outcome)) return reading;
  double limit_m = infinity;
  for (Laser& laser : lasers_) {
    choose_scan(laser, reading.time_s);
    if (laser.scans.empty() || std::abs(laser.scans.front().time_s - reading.time_s) > max_age_s_) continue;
    if (place_scan(laser, track)) limit_m = std::min(limit_m, limit_of(reading, rule_, laser.hit_x, laser.hit_y));
  }
  if (!(limit_m < echo_range_m(reading.outcome).value_or(reading.range_max_m))) return reading;
  Reading shortened = reading;
  shortened.outcome = Echo{limit_m};
  shortened.laser_limited = true;
  return shortened;
}

}  // namespace echoarc
