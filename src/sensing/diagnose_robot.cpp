// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <functional>
#include <limits>

#include "echoarc/core/arc.hpp"
#include "sensing/findings.hpp"

namespace echoarc {
namespace {

/// Ids of the sensors for which `odd` holds.
std::vector<SensorId> sensors_that(const RobotDescription& robot, const std::function<bool(const Sensor&)>& odd) {
  std::vector<SensorId> ids;
  for (const Sensor& sensor : robot.sensors.sensors())
    if (odd(sensor)) ids.push_back(sensor.id);
  return ids;
}

void find_odd_beams(const RobotDescription& robot, Findings& findings) {
  const auto narrow = sensors_that(robot, [](const Sensor& s) { return s.model.beam_width < degrees(3.0); });
  if (!narrow.empty())
    findings.push_back({Severity::warning, "beam_narrow", sensor_text(narrow) + ": beam under 3 degrees full width",
                        "beam_width is the full angle in radians, beam_width_deg in degrees; ultrasonic sensors have "
                        "10 to 60 degrees"});
  const auto wide = sensors_that(robot, [](const Sensor& s) { return s.model.beam_width > degrees(90.0); });
  if (!wide.empty())
    findings.push_back({Severity::warning, "beam_wide", sensor_text(wide) + ": beam over 90 degrees full width",
                        "beam_width is the full angle in radians, beam_width_deg in degrees; ultrasonic sensors have "
                        "10 to 60 degrees"});
}

void find_odd_ranges(const RobotDescription& robot, Findings& findings) {
  const auto blind = sensors_that(robot, [](const Sensor& s) { return s.model.range_min_m < 0.01; });
  if (!blind.empty())
    findings.push_back({Severity::note, "no_minimum_range", sensor_text(blind) + ": no minimum range is given",
                        "set range_min from the data sheet: nearer than that a sensor hears its own pulse, and reports "
                        "walls that are not there"});
  const auto far = sensors_that(robot, [](const Sensor& s) { return s.model.range_max_m > 20.0; });
  if (!far.empty())
    findings.push_back({Severity::warning, "maximum_range_large", sensor_text(far) + ": maximum range over 20 m",
                        "range_max is in metres; ultrasonic sensors in air reach 2 to 11 m"});
}

void find_odd_mounts(const RobotDescription& robot, Findings& findings) {
  const auto sensors = robot.sensors.sensors();
  const auto shared =
      sensors_that(robot, [&](const Sensor& s) { return std::ranges::count(sensors, s.mount, &Sensor::mount) > 1; });
  if (!shared.empty())
    findings.push_back({Severity::warning, "same_mount", sensor_text(shared) + " share a place and a direction",
                        "give each its own x, y and yaw; without mounts no map can be right"});
  const auto away = sensors_that(
      robot, [&](const Sensor& s) { return norm(s.mount.T_robot_sensor().position) > robot.radius_m + 0.5; });
  if (!away.empty())
    findings.push_back({Severity::warning, "mount_far",
                        sensor_text(away) + " sit more than 0.5 m outside the robot's radius of " +
                            number_text(robot.radius_m, 2) + " m",
                        "x, y and radius are in metres"});
}

/// Sensors that meet the floor at one and the same range are told together.
void find_floor(const RobotDescription& robot, Findings& findings) {
  std::map<std::pair<std::string, std::string>, std::vector<SensorId>> groups;
  for (const Sensor& sensor : robot.sensors.sensors()) {
    const double range_m = floor_range_m(sensor);
    if (range_m < sensor.model.range_max_m)
      groups[{number_text(range_m, 2), number_text(sensor.mount.z_m, 2)}].push_back(sensor.id);
  }
  for (const auto& [place, ids] : groups)
    findings.push_back({Severity::note, "floor_in_beam",
                        sensor_text(ids) + ", " + place.second +
                            " m high: the lower edge of the beam meets the floor at " + place.first +
                            " m; a rough floor or a kerb answers from there on",
                        "mount the sensor higher or tilt it up (negative pitch), or set range_max to that range"});
}

}  // namespace

double floor_range_m(const Sensor& sensor) {
  // REP 103: positive pitch turns the nose down.
  const Angle below_horizon = sensor.mount.pitch + 0.5 * sensor.model.beam_width;
  if (sensor.mount.z_m <= 0.0 || below_horizon.rad() <= eps_angle.rad()) return std::numeric_limits<double>::infinity();
  return below_horizon < degrees(90.0) ? sensor.mount.z_m / sin(below_horizon) : sensor.mount.z_m;
}

std::vector<Finding> diagnose(const RobotDescription& robot) {
  Findings findings;
  if (robot.sensors.empty())
    findings.push_back({Severity::error, "no_sensors", "the robot has no sonar",
                        "describe it: `echoarc init` writes a robot.toml to start from"});
  find_odd_beams(robot, findings);
  find_odd_ranges(robot, findings);
  find_odd_mounts(robot, findings);
  find_floor(robot, findings);
  return findings;
}

}  // namespace echoarc
