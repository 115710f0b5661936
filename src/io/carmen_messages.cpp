// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/carmen_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "io/text_cells.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_words = 100'000;
constexpr std::size_t max_skipped_names = 10;
/// What CARMEN assumes of the SICK laser behind FLASER and RLASER; readings from here on are no return.
constexpr double old_laser_range_max_m = 80.0;
constexpr std::array<std::string_view, 6> used_messages = {"ODOM",   "TRUEPOS",     "FLASER",
                                                           "RLASER", "ROBOTLASER1", "SONAR"};

/// The bearing step of a SICK scan over 180 (100 for the quarter degrees) degrees, which old messages do not state.
Angle old_laser_step(std::size_t readings) {
  switch (readings) {
    case 180:
    case 181: return degrees(1.0);
    case 360:
    case 361: return degrees(0.5);
    case 400:
    case 401: return degrees(0.25);
    default: return degrees(readings > 1 ? 180.0 / static_cast<double>(readings - 1) : 0.0);
  }
}

bool is_message_name(std::string_view word) {
  return std::ranges::all_of(word, [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace

bool is_carmen_message(std::string_view line) {
  const std::string_view name = line.substr(0, line.find_first_of(blanks));
  return name.size() < line.size() && std::ranges::find(used_messages, name) != used_messages.end();
}

void CarmenWords::split(std::string_view line) {
  split_words(line, max_words, words_);
  next_ = 1;
  failed_ = words_.empty();
}

double CarmenWords::number() {
  const auto value = next_ < words_.size() ? parse_number<double>(words_[next_++]) : std::nullopt;
  failed_ = failed_ || !value || !std::isfinite(*value);
  return failed_ ? 0.0 : *value;
}

Pose2 CarmenWords::pose() {
  const double x = number();
  const double y = number();
  return {{x, y}, angle()};
}

std::size_t CarmenWords::count() {
  const auto value = next_ < words_.size() ? parse_number<std::uint32_t>(words_[next_++]) : std::nullopt;
  failed_ = failed_ || !value || *value > words_.size() - next_;
  return failed_ ? 0 : *value;
}

void CarmenWords::skip(std::size_t words) {
  failed_ = failed_ || words > words_.size() - next_;
  if (!failed_) next_ += words;
}

bool CarmenMessages::read(const Line& line, Log& log) {
  line_ = line.number;
  words_.split(line.text);
  const std::string_view name = words_.name();
  if (name == "ODOM") return read_odometry(log);
  if (name == "TRUEPOS") return read_true_pose(log);
  if (name == "FLASER") return read_old_laser(0, log);
  if (name == "RLASER") return read_old_laser(1, log);
  if (name == "ROBOTLASER1") return read_laser(log);
  if (name == "SONAR") return read_sonar(log);
  if (!is_message_name(name)) return fail("not a CARMEN message");
  if (skipped_.size() < max_skipped_names) skipped_.emplace(name.substr(0, 40));
  return true;
}

bool CarmenMessages::fail(std::string cause) {
  fault_ = std::move(cause);
  return false;
}

// ODOM x y theta tv rv accel timestamp host logger_timestamp
bool CarmenMessages::read_odometry(Log& log) {
  const Pose2 T_world_robot = words_.pose();
  words_.skip(3);
  const double time_s = words_.number();
  if (words_.failed()) return fail("ODOM needs x y theta tv rv accel timestamp");
  log.odometry.push_back({time_s, T_world_robot, line_});
  return true;
}

// TRUEPOS x y theta odom_x odom_y odom_theta timestamp host logger_timestamp
bool CarmenMessages::read_true_pose(Log& log) {
  const Pose2 T_world_robot = words_.pose();
  words_.skip(3);
  const double time_s = words_.number();
  if (words_.failed()) return fail("TRUEPOS needs x y theta odom_x odom_y odom_theta timestamp");
  log.truth.push_back({time_s, T_world_robot, line_});
  return true;
}

// FLASER n r1..rn x y theta odom_x odom_y odom_theta timestamp host logger_timestamp
bool CarmenMessages::read_old_laser(std::uint32_t laser, Log& log) {
  Scan scan;
  scan.laser = laser;
  scan.angle_min = degrees(-90.0);
  read_ranges(scan, old_laser_range_max_m);
  scan.angle_step = old_laser_step(scan.ranges_m.size());
  const Pose2 T_world_laser = words_.pose();
  const Pose2 T_world_robot = words_.pose();
  scan.time_s = words_.number();
  if (words_.failed()) return fail("a laser message needs n, n ranges, two poses and a timestamp");
  return add_scan(std::move(scan), T_world_laser, T_world_robot, old_laser_range_max_m, log);
}

// ROBOTLASER1 type start_angle fov angular_resolution maximum_range accuracy remission_mode n r1..rn m remissions
//             laser_pose robot_pose tv rv forward_safety side_safety turn_axis timestamp host logger_timestamp
bool CarmenMessages::read_laser(Log& log) {
  Scan scan;
  words_.skip(1);
  scan.angle_min = words_.angle();
  words_.skip(1);
  scan.angle_step = words_.angle();
  const double range_max_m = words_.number();
  words_.skip(2);
  read_ranges(scan, range_max_m);
  words_.skip(words_.count());
  const Pose2 T_world_laser = words_.pose();
  const Pose2 T_world_robot = words_.pose();
  words_.skip(5);
  scan.time_s = words_.number();
  if (words_.failed()) return fail("a word of ROBOTLASER1 is missing or not a number");
  return add_scan(std::move(scan), T_world_laser, T_world_robot, range_max_m, log);
}

void CarmenMessages::read_ranges(Scan& scan, double range_max_m) {
  const std::size_t count = words_.count();
  scan.ranges_m.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double range_m = words_.number();
    const bool returned = range_m >= 0.0 && range_m < std::min(range_max_m, double{std::numeric_limits<float>::max()});
    scan.ranges_m.push_back(returned ? static_cast<float>(range_m) : std::numeric_limits<float>::quiet_NaN());
  }
}

bool CarmenMessages::add_scan(Scan scan, const Pose2& T_world_laser, const Pose2& T_world_robot, double range_max_m,
                              Log& log) {
  if (std::ranges::find(log.robot.lasers, scan.laser, &LaserMount::id) == log.robot.lasers.end()) {
    const Pose2 T_robot_laser = inverse(T_world_robot) * T_world_laser;
    if (!is_finite(T_robot_laser)) return fail("the laser is infinitely far from the robot");
    LaserMount mount{.id = scan.laser, .range_max_m = range_max_m};
    mount.mount.x_m = T_robot_laser.position.x;
    mount.mount.y_m = T_robot_laser.position.y;
    mount.mount.yaw = wrap(T_robot_laser.heading);
    log.robot.lasers.push_back(mount);
  }
  scan.line = line_;
  laser_odometry_.push_back({scan.time_s, T_world_robot, line_});
  log.scans.push_back(std::move(scan));
  return true;
}

// SONAR cone_angle n r1..rn (x y theta)1..n timestamp host
bool CarmenMessages::read_sonar(Log& log) {
  const double cone = words_.number();
  const std::size_t count = words_.count();
  std::vector<double> ranges_m(count);
  for (double& range_m : ranges_m) range_m = words_.number();
  std::vector<Pose2> T_robot_sensors(count);
  for (Pose2& T_robot_sensor : T_robot_sensors) T_robot_sensor = words_.pose();
  const double time_s = words_.number();
  if (words_.failed()) return fail("SONAR needs cone_angle, n, n ranges, n times x y theta, and a timestamp");
  // Radians are what CARMEN writes; a beam as wide as a half-plane is a configuration in degrees.
  const Angle beam_width = cone >= std::numbers::pi ? degrees(cone) : radians(cone);
  if (log.robot.sensors.empty() && !add_sensors(T_robot_sensors, beam_width, log)) return false;
  for (SensorId id = 0; id < count; ++id)
    log.pings.push_back({.time_s = time_s, .tx = id, .rx = id, .range_m = ranges_m[id], .line = line_});
  return true;
}

bool CarmenMessages::add_sensors(const std::vector<Pose2>& T_robot_sensors, Angle cone, Log& log) {
  std::vector<Sensor> sensors;
  for (const Pose2& T_robot_sensor : T_robot_sensors) {
    Sensor sensor;
    sensor.id = static_cast<SensorId>(sensors.size());
    sensor.mount.x_m = T_robot_sensor.position.x;
    sensor.mount.y_m = T_robot_sensor.position.y;
    sensor.mount.yaw = T_robot_sensor.heading;
    sensor.model.beam_width = cone;
    sensors.push_back(std::move(sensor));
  }
  Result<SensorArray> array = SensorArray::make(std::move(sensors));
  if (!array) return fail(fmt::format("{}; {}", array.error().message, array.error().remedy));
  log.robot.sensors = std::move(*array);
  return true;
}

void CarmenMessages::finish(Log& log) {
  if (log.odometry.empty()) log.odometry = std::move(laser_odometry_);
}

}  // namespace echoarc::io
