// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/scene_checks.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "sim/scene_fault.hpp"

namespace echoarc::sim {
namespace {

template <OptionStruct S>
Result<void> check_options(std::string_view table, const S& options) {
  const Result<void> checked = validate(options);
  if (checked) return {};
  Error error = checked.error();
  error.where = std::string(table) + "." + error.where;
  return error;
}

Result<void> check_robot(const RobotDescription& robot) {
  if (robot.sensors.empty())
    return scene_fault("the robot has no sensors", 0, R"(give it some, for example array = "nomad200")");
  if (!(robot.radius_m >= 0.0 && robot.radius_m <= 1000.0))
    return scene_fault("the robot's radius is not between 0 and 1000 m", 0, "give radius_m in metres");
  return {};
}

Result<void> check_lasers(const Scene& scene) {
  for (const LaserOptions& laser : scene.lasers) {
    if (const Result<void> checked = check_options("laser", laser); !checked) return checked;
    const LaserMount* mount = find_laser(scene.robot, laser.laser);
    if (mount == nullptr)
      return scene_fault("the robot has no laser " + std::to_string(laser.laser), 0,
                         "add it to the robot, or leave its beams out");
    if (!(mount->range_min_m >= 0.0 && mount->range_max_m > mount->range_min_m && mount->range_max_m <= 1000.0))
      return scene_fault("the ranges of laser " + std::to_string(laser.laser) + " are not 0 <= min < max <= 1000 m", 0,
                         "give range_min and range_max in metres");
  }
  return {};
}

Result<void> check_polling(const Scene& scene) {
  if (!scene.polling.polled) return {};
  if (scene.drive.stop_step_m > 0.0 || scene.drive.stop_turn > Angle{})
    return scene_fault("registers are polled while the array fires on and on; this drive stops to fire", 0,
                       "leave out stop_step_m and stop_turn_deg, or polling");
  if (scene.sonar.listening == Listening::all)
    return scene_fault("a register holds what its own sensor heard, but all sensors listen", 0,
                       R"(set listening = "own", or leave out polling)");
  return {};
}

}  // namespace

const LaserMount* find_laser(const RobotDescription& robot, int id) {
  const auto found = std::ranges::find(robot.lasers, static_cast<std::uint32_t>(id), &LaserMount::id);
  return found != robot.lasers.end() ? &*found : nullptr;
}

Result<void> check_scene(const Scene& scene) {
  if (const Result<void> checked = check_options("sonar", scene.sonar); !checked) return checked;
  if (const Result<void> checked = check_options("drive", scene.drive); !checked) return checked;
  if (const Result<void> checked = check_options("odometry", scene.odometry); !checked) return checked;
  if (const Result<void> checked = check_options("polling", scene.polling); !checked) return checked;
  if (const Result<void> checked = check_robot(scene.robot); !checked) return checked;
  if (const Result<void> checked = check_lasers(scene); !checked) return checked;
  return check_polling(scene);
}

}  // namespace echoarc::sim
