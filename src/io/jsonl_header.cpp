// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/jsonl_header.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "echoarc/io/jsonl.hpp"

namespace echoarc::io {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::string_view format_name = "echoarc-log";
constexpr const char* header_remedy =
    R"(start the file with {"type":"header","format":"echoarc-log","version":1,"frame":"odom","robot":{"sensors":[...]}})";

struct NoEchoName {
  NoEchoRule::Kind kind;
  std::string_view name;
};
constexpr std::array no_echo_names = {
    NoEchoName{NoEchoRule::Kind::automatic, "auto"}, NoEchoName{NoEchoRule::Kind::inf, "inf"},
    NoEchoName{NoEchoRule::Kind::nan, "nan"},        NoEchoName{NoEchoRule::Kind::zero, "zero"},
    NoEchoName{NoEchoRule::Kind::max, "max"},
};

/// Reads keys of a JSON object; keeps the first thing wrong.
class HeaderFields {
 public:
  HeaderFields(const json& object, std::string what, std::string& fault)
      : object_(object), what_(std::move(what)), fault_(fault) {
    if (!object.is_object()) fail(fmt::format("{} is not an object", what_));
  }

  [[nodiscard]] const json* find(const char* key) const {
    const auto found = object_.is_object() ? object_.find(key) : object_.end();
    return found == object_.end() ? nullptr : &*found;
  }
  void number(const char* key, double& value) {
    const json* found = find(key);
    if (found == nullptr) return;
    if (found->is_number())
      value = found->get<double>();
    else
      fail(fmt::format("{} of {} is not a number", key, what_));
  }
  void angle(const char* key, Angle& value) {
    double rad = value.rad();
    number(key, rad);
    value = radians(rad);
  }
  void text(const char* key, std::string& value) {
    const json* found = find(key);
    if (found == nullptr) return;
    if (found->is_string())
      value = found->get<std::string>();
    else
      fail(fmt::format("{} of {} is not a string", key, what_));
  }
  void id(const char* key, std::uint32_t& value) {
    const json* found = find(key);
    if (found == nullptr || !found->is_number_unsigned() ||
        found->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
      fail(fmt::format("{} of {} is missing or not a whole number from 0 on", key, what_));
    else
      value = found->get<std::uint32_t>();
  }
  /// Calls `read` with each element of a list, which may be absent.
  template <class Read>
  void list(const char* key, const char* element_name, std::size_t max_count, const Read& read) {
    const json* found = find(key);
    if (found == nullptr) return;
    if (!found->is_array() || found->size() > max_count)
      return fail(fmt::format("{} of {} is not a list of at most {}", key, what_, max_count));
    for (const json& element : *found) {
      HeaderFields fields(element, element_name, fault_);
      read(fields);
    }
  }
  void fail(std::string fault) {
    if (fault_.empty()) fault_ = std::move(fault);
  }

 private:
  const json& object_;
  std::string what_;
  std::string& fault_;
};

void read_mount(HeaderFields& fields, Mount& mount) {
  fields.number("x", mount.x_m);
  fields.number("y", mount.y_m);
  fields.number("z", mount.z_m);
  fields.angle("roll", mount.roll);
  fields.angle("pitch", mount.pitch);
  fields.angle("yaw", mount.yaw);
}

void read_no_echo(HeaderFields& fields, NoEchoRule& rule) {
  const json* found = fields.find("no_echo");
  if (found == nullptr) return;
  if (found->is_object()) {
    rule.kind = NoEchoRule::Kind::above;
    const auto above = found->find("above");
    if (above != found->end() && above->is_number()) return void(rule.above_m = above->get<double>());
  }
  if (found->is_string())
    for (const NoEchoName& known : no_echo_names)
      if (known.name == found->get_ref<const std::string&>()) return void(rule.kind = known.kind);
  fields.fail(R"(no_echo of a sensor is none of "auto", "inf", "nan", "zero", "max", {"above":5.0})");
}

Sensor read_sensor(HeaderFields& fields) {
  Sensor sensor;
  fields.id("id", sensor.id);
  read_mount(fields, sensor.mount);
  fields.text("preset", sensor.model.preset);
  if (const auto preset = sensor_preset(sensor.model.preset)) sensor.model = *preset;
  fields.angle("beam_width", sensor.model.beam_width);
  fields.number("range_min", sensor.model.range_min_m);
  fields.number("range_max", sensor.model.range_max_m);
  fields.number("trusted_range", sensor.model.trusted_range_m);
  read_no_echo(fields, sensor.model.no_echo);
  return sensor;
}

LaserMount read_laser(HeaderFields& fields) {
  LaserMount laser;
  fields.id("id", laser.id);
  read_mount(fields, laser.mount);
  fields.number("range_min", laser.range_min_m);
  fields.number("range_max", laser.range_max_m);
  return laser;
}

void read_robot(HeaderFields& header, RobotDescription& robot, std::string& fault) {
  constexpr std::size_t max_lasers = 64;
  const json* found = header.find("robot");
  if (found == nullptr) return;
  HeaderFields fields(*found, "robot", fault);
  fields.text("name", robot.name);
  fields.number("radius_m", robot.radius_m);
  std::vector<Sensor> sensors;
  // One more than allowed, so that SensorArray has the say.
  fields.list("sensors", "a sensor", SensorArray::max_sensors + 1,
              [&](HeaderFields& sensor) { sensors.push_back(read_sensor(sensor)); });
  fields.list("lasers", "a laser", max_lasers, [&](HeaderFields& laser) { robot.lasers.push_back(read_laser(laser)); });
  Result<SensorArray> array = SensorArray::make(std::move(sensors));
  if (array)
    robot.sensors = std::move(*array);
  else
    fields.fail(fmt::format("{}; {}", array.error().message, array.error().remedy));
}

Result<void> check_version(HeaderFields& header, const std::string& place) {
  double version = 0.0;
  header.number("version", version);
  if (version >= jsonl_version + 1)
    return Error{ErrorCode::unsupported,
                 fmt::format("the log has version {}, this echoarc reads version {}", version, jsonl_version), place,
                 "use a newer echoarc, or convert the log with the one that wrote it"};
  if (!(version >= 1.0)) header.fail("version of the header is missing or less than 1");
  return {};
}

ordered_json mount_json(const Mount& mount) {
  return {{"x", mount.x_m},
          {"y", mount.y_m},
          {"z", mount.z_m},
          {"roll", mount.roll.rad()},
          {"pitch", mount.pitch.rad()},
          {"yaw", mount.yaw.rad()}};
}

ordered_json sensor_json(const Sensor& sensor) {
  ordered_json out = {{"id", sensor.id}};
  out.update(mount_json(sensor.mount));
  const SensorModel& model = sensor.model;
  if (!model.preset.empty()) out["preset"] = model.preset;
  out["beam_width"] = model.beam_width.rad();
  out["range_min"] = model.range_min_m;
  out["range_max"] = model.range_max_m;
  out["trusted_range"] = model.trusted_range_m;
  if (model.no_echo.kind == NoEchoRule::Kind::above) out["no_echo"] = {{"above", model.no_echo.above_m}};
  for (const NoEchoName& known : no_echo_names)
    if (known.kind == model.no_echo.kind) out["no_echo"] = known.name;
  return out;
}

ordered_json laser_json(const LaserMount& laser) {
  ordered_json out = {{"id", laser.id}};
  out.update(mount_json(laser.mount));
  out["range_min"] = laser.range_min_m;
  out["range_max"] = laser.range_max_m;
  return out;
}

/// JSON has no spelling for infinity and NaN; the library would write null.
bool all_finite(const ordered_json& value) {
  if (value.is_number_float()) return std::isfinite(value.get<double>());
  if (!value.is_structured()) return true;
  for (const ordered_json& element : value)
    if (!all_finite(element)) return false;
  return true;
}

}  // namespace

Result<void> read_jsonl_header(std::string_view line, const std::string& place, Log& log) {
  const json parsed = json::parse(line, nullptr, false);
  const auto bad = [&](std::string cause) {
    return Error{ErrorCode::bad_format, std::move(cause), place, header_remedy};
  };
  if (!parsed.is_object()) return bad("the first line is not the header of an echoarc log: not a JSON object");
  std::string fault;
  HeaderFields header(parsed, "the header", fault);
  std::string type;
  std::string format;
  header.text("type", type);
  header.text("format", format);
  if (type != "header" || format != format_name) return bad("the first line is not the header of an echoarc log");
  if (Result<void> version = check_version(header, place); !version) return version;
  header.text("frame", log.frame);
  header.number("temperature_k", log.temperature_k);
  read_robot(header, log.robot, fault);
  if (!fault.empty()) return bad("bad header: " + fault);
  return {};
}

Result<std::string> jsonl_header(const Log& log) {
  ordered_json robot = {{"name", log.robot.name}, {"radius_m", log.robot.radius_m}};
  robot["sensors"] = ordered_json::array();
  for (const Sensor& sensor : log.robot.sensors.sensors()) robot["sensors"].push_back(sensor_json(sensor));
  robot["lasers"] = ordered_json::array();
  for (const LaserMount& laser : log.robot.lasers) robot["lasers"].push_back(laser_json(laser));
  ordered_json header = {{"type", "header"},
                         {"format", format_name},
                         {"version", jsonl_version},
                         {"frame", log.frame},
                         {"temperature_k", log.temperature_k}};
  header["robot"] = std::move(robot);
  if (!all_finite(header))
    return Error{ErrorCode::bad_value, "the robot description holds a number that is not finite", log.source,
                 "correct the description"};
  return header.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace echoarc::io
