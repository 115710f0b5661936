// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/sensor_array.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoarc {
namespace {

constexpr double farthest_m = 1000.0;

bool within(double value, double low, double high) {
  return value >= low && value <= high;  // false for NaN
}

Error sensor_error(SensorId id, std::string message, std::string remedy) {
  return {ErrorCode::bad_value, "sensor " + std::to_string(id) + ": " + std::move(message),
          "sensors, id " + std::to_string(id), std::move(remedy)};
}

Result<void> check_mount(const Sensor& sensor) {
  const Mount& mount = sensor.mount;
  const bool near_robot = within(mount.x_m, -farthest_m, farthest_m) && within(mount.y_m, -farthest_m, farthest_m) &&
                          within(mount.z_m, -farthest_m, farthest_m);
  if (!near_robot)
    return sensor_error(sensor.id, "its mount is not finite or more than 1000 m from the robot's centre",
                        "give x, y and z in metres");
  if (!is_finite(mount.roll) || !is_finite(mount.pitch) || !is_finite(mount.yaw))
    return sensor_error(sensor.id, "its mount has an angle that is not finite", "give roll, pitch and yaw in radians");
  return {};
}

Result<void> check_model(const Sensor& sensor) {
  const SensorModel& model = sensor.model;
  const double beam_deg = model.beam_width.deg();
  if (!(beam_deg > 0.0 && beam_deg < 180.0))
    return sensor_error(sensor.id, "a beam width of " + std::to_string(beam_deg) + " degrees is not between 0 and 180",
                        "give the full angle of the beam, in radians unless the name ends in _deg");
  if (!within(model.range_min_m, 0.0, farthest_m) || !within(model.range_max_m, 0.0, farthest_m) ||
      model.range_min_m >= model.range_max_m)
    return sensor_error(sensor.id,
                        "ranges from " + std::to_string(model.range_min_m) + " to " +
                            std::to_string(model.range_max_m) + " m are not 0 <= min < max <= 1000 m",
                        "give range_min and range_max in metres");
  if (!within(model.trusted_range_m, 0.0, farthest_m))
    return sensor_error(sensor.id, "its trusted range is not between 0 and 1000 m", "give trusted_range in metres");
  if (model.no_echo.kind == NoEchoRule::Kind::above && !within(model.no_echo.above_m, 0.0, farthest_m))
    return sensor_error(sensor.id, "its no-echo limit is not between 0 and 1000 m",
                        "give no_echo = {above = ...} in metres");
  return {};
}

}  // namespace

Result<SensorArray> SensorArray::make(std::vector<Sensor> sensors) {
  if (sensors.size() > max_sensors)
    return Error{ErrorCode::too_large,
                 std::to_string(sensors.size()) + " sensors are more than " + std::to_string(max_sensors), "sensors",
                 "describe the sensors of one robot only"};
  for (const Sensor& sensor : sensors) {
    if (const Result<void> checked = check_mount(sensor); !checked) return checked.error();
    if (const Result<void> checked = check_model(sensor); !checked) return checked.error();
  }
  std::ranges::stable_sort(sensors, {}, &Sensor::id);
  const auto twin = std::ranges::adjacent_find(sensors, {}, &Sensor::id);
  if (twin != sensors.end())
    return sensor_error(twin->id, "the id is used twice", "give every sensor an id of its own");
  SensorArray array;
  array.sensors_ = std::move(sensors);
  return array;
}

const Sensor* SensorArray::find(SensorId id) const {
  const auto found = std::ranges::lower_bound(sensors_, id, {}, &Sensor::id);
  return found != sensors_.end() && found->id == id ? &*found : nullptr;
}

std::vector<Sensor> ring(int count, double radius_m, Angle start, const SensorModel& model) {
  std::vector<Sensor> sensors;
  for (int k = 0; k < count; ++k) {
    const Angle at = wrap(start + degrees(360.0) * (static_cast<double>(k) / count));
    const Vec2 position = radius_m * unit(at);
    sensors.push_back({static_cast<SensorId>(k), {.x_m = position.x, .y_m = position.y, .yaw = at}, model});
  }
  return sensors;
}

std::vector<Sensor> row(int count, double spacing_m, double x_m, const SensorModel& model) {
  std::vector<Sensor> sensors;
  for (int k = 0; k < count; ++k)
    sensors.push_back({static_cast<SensorId>(k), {.x_m = x_m, .y_m = (k - (count - 1) / 2.0) * spacing_m}, model});
  return sensors;
}

}  // namespace echoarc
