// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/sensor_toml.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace echoarc::io {
namespace {

constexpr std::int64_t max_sensor_id = 1'000'000;
constexpr std::size_t max_lasers = 64;

struct NoEchoWord {
  std::string_view word;
  NoEchoRule::Kind kind;
};
constexpr std::array no_echo_words = {
    NoEchoWord{"auto", NoEchoRule::Kind::automatic}, NoEchoWord{"inf", NoEchoRule::Kind::inf},
    NoEchoWord{"nan", NoEchoRule::Kind::nan},        NoEchoWord{"zero", NoEchoRule::Kind::zero},
    NoEchoWord{"max", NoEchoRule::Kind::max},
};
constexpr std::string_view no_echo_remedy = R"(use "auto", "inf", "nan", "zero", "max" or { above = 5.0 })";

std::optional<NoEchoRule> read_no_echo(TomlFields& fields) {
  const toml::node* node = fields.node("no_echo");
  if (node == nullptr) return std::nullopt;
  if (const auto* word = node->as_string()) {
    const auto found = std::ranges::find(no_echo_words, std::string_view(word->get()), &NoEchoWord::word);
    if (found != no_echo_words.end()) return NoEchoRule{found->kind, 0.0};
  } else if (const auto* table = node->as_table()) {
    TomlFields rule(*table, fields.source(), "no_echo");
    const std::optional<double> above = rule.length_m("above", 0.0, 1000.0);
    if (const Result<void> done = rule.finish(); !done) fields.fail(done.error());
    if (above) return NoEchoRule{NoEchoRule::Kind::above, *above};
  }
  fields.fail(node, "no_echo is none of the known spellings", std::string(no_echo_remedy));
  return std::nullopt;
}

std::vector<std::string_view> names_of(const auto& presets) {
  std::vector<std::string_view> names;
  for (const auto& preset : presets) names.push_back(preset.name);
  return names;
}

SensorModel read_preset(TomlFields& fields, const SensorModel& defaults) {
  const std::optional<std::string> name = fields.text("preset");
  if (!name) return defaults;
  if (const std::optional<SensorModel> model = sensor_preset(*name)) return *model;
  fields.fail(fields.node("preset"), fmt::format("there is no sensor preset \"{}\"", *name),
              fmt::format("use one of {}, or give beam_width_deg, range_min and range_max yourself",
                          fmt::join(names_of(sensor_presets()), ", ")));
  return defaults;
}

Mount read_mount(TomlFields& fields) {
  Mount mount;
  mount.x_m = fields.length_m("x").value_or(0.0);
  mount.y_m = fields.length_m("y").value_or(0.0);
  mount.z_m = fields.length_m("z").value_or(0.0);
  mount.roll = fields.angle("roll").value_or(Angle{});
  mount.pitch = fields.angle("pitch").value_or(Angle{});
  mount.yaw = fields.angle("yaw").value_or(Angle{});
  return mount;
}

/// Collects the sensors of a robot table, from all the ways to give them.
class SensorCollector {
 public:
  explicit SensorCollector(TomlFields& robot) : robot_(robot) {
    const toml::table* table = robot.table("sensor_defaults");
    if (table == nullptr) return;
    TomlFields fields(*table, robot.source(), "sensor_defaults");
    defaults_ = read_sensor_model(fields, defaults_);
    keep_error(fields);
  }

  void add_array() {
    const std::optional<std::string> name = robot_.text("array");
    if (!name) return;
    if (const std::optional<SensorArray> array = array_preset(*name)) {
      sensors_.insert(sensors_.end(), array->sensors().begin(), array->sensors().end());
      return;
    }
    robot_.fail(robot_.node("array"), fmt::format("there is no sensor array \"{}\"", *name),
                fmt::format("use one of {}, or describe the sensors", fmt::join(names_of(array_presets()), ", ")));
  }

  void add_explicit() {
    for (const toml::table* table : robot_.tables("sensors", SensorArray::max_sensors)) {
      TomlFields fields(*table, robot_.source(), "sensor");
      Sensor sensor;
      sensor.id = static_cast<SensorId>(fields.integer("id", 0, max_sensor_id).value_or(next_id()));
      sensor.mount = read_mount(fields);
      sensor.model = read_sensor_model(fields, defaults_);
      add_sensor(fields, std::move(sensor));
      keep_error(fields);
    }
  }

  void add_rings() {
    for (const toml::table* table : robot_.tables("ring", SensorArray::max_sensors)) {
      TomlFields fields(*table, robot_.source(), "ring");
      const int count = read_count(fields);
      const double radius_m = fields.length_m("radius", 0.0, 1000.0).value_or(0.0);
      const Angle start = fields.angle("start").value_or(Angle{});
      add_group(fields, [&](const SensorModel& model) { return ring(count, radius_m, start, model); });
    }
  }

  void add_rows() {
    for (const toml::table* table : robot_.tables("row", SensorArray::max_sensors)) {
      TomlFields fields(*table, robot_.source(), "row");
      const int count = read_count(fields);
      const double spacing_m = fields.length_m("spacing", 0.0, 1000.0).value_or(0.0);
      const double x_m = fields.length_m("x", -1000.0, 1000.0).value_or(0.0);
      add_group(fields, [&](const SensorModel& model) { return row(count, spacing_m, x_m, model); });
    }
  }

  [[nodiscard]] std::vector<Sensor> take() { return std::move(sensors_); }

 private:
  static int read_count(TomlFields& fields) {
    const bool given = fields.has("count");
    const auto count = fields.integer("count", 1, std::int64_t{SensorArray::max_sensors});
    if (!given) fields.fail(nullptr, "count is missing", "write count = 8, the number of sensors");
    return static_cast<int>(count.value_or(0));
  }

  /// Adds what `place` makes of the model keys of `fields`, with ids from `first_id` on. Nothing is made after an
  /// error.
  template <class Place>
  void add_group(TomlFields& fields, const Place& place) {
    const auto first_id = fields.integer("first_id", 0, max_sensor_id).value_or(next_id());
    const SensorModel model = read_sensor_model(fields, defaults_);
    if (!keep_error(fields) || sensors_.size() > SensorArray::max_sensors) return;
    for (Sensor& sensor : place(model)) {
      sensor.id += static_cast<SensorId>(first_id);
      add_sensor(fields, std::move(sensor));
    }
    keep_error(fields);
  }

  /// Checks the sensor by itself and its id against the others, so that an error names the line of its table.
  void add_sensor(TomlFields& fields, Sensor sensor) {
    if (const Result<SensorArray> alone = SensorArray::make({sensor}); !alone)
      fields.fail(nullptr, alone.error().message, alone.error().remedy);
    if (std::ranges::find(sensors_, sensor.id, &Sensor::id) != sensors_.end())
      fields.fail(nullptr, fmt::format("two sensors have the id {}", sensor.id), "give every sensor an id of its own");
    sensors_.push_back(std::move(sensor));
  }

  bool keep_error(TomlFields& fields) {
    const Result<void> done = fields.finish();
    if (!done) robot_.fail(done.error());
    return done.has_value();
  }

  [[nodiscard]] std::int64_t next_id() const {
    return sensors_.empty() ? 0 : std::int64_t{std::ranges::max(sensors_, {}, &Sensor::id).id} + 1;
  }

  TomlFields& robot_;
  SensorModel defaults_;
  std::vector<Sensor> sensors_;
};

std::vector<LaserMount> read_lasers(TomlFields& robot) {
  std::vector<LaserMount> lasers;
  for (const toml::table* table : robot.tables("lasers", max_lasers)) {
    TomlFields fields(*table, robot.source(), "laser");
    LaserMount laser;
    laser.id = static_cast<std::uint32_t>(
        fields.integer("id", 0, max_sensor_id).value_or(static_cast<std::int64_t>(lasers.size())));
    laser.mount = read_mount(fields);
    laser.range_min_m = fields.length_m("range_min", 0.0, 1000.0).value_or(laser.range_min_m);
    laser.range_max_m = fields.length_m("range_max", 0.0, 1000.0).value_or(laser.range_max_m);
    if (std::ranges::find(lasers, laser.id, &LaserMount::id) != lasers.end())
      fields.fail(nullptr, fmt::format("two lasers have the id {}", laser.id), "give each laser an id of its own");
    if (const Result<void> done = fields.finish(); !done) robot.fail(done.error());
    lasers.push_back(laser);
  }
  return lasers;
}

}  // namespace

SensorModel read_sensor_model(TomlFields& fields, const SensorModel& defaults) {
  SensorModel model = read_preset(fields, defaults);
  if (const auto beam = fields.angle("beam_width")) model.beam_width = *beam;
  if (const auto range = fields.length_m("range_min", 0.0)) model.range_min_m = *range;
  const std::optional<double> range_max = fields.length_m("range_max", 0.0);
  if (range_max) model.range_max_m = *range_max;
  const std::optional<double> trusted = fields.length_m("trusted_range", 0.0);
  // A shorter reach than the preset's takes the trusted range along.
  model.trusted_range_m = trusted.value_or(std::min(model.trusted_range_m, model.range_max_m));
  if (const auto rule = read_no_echo(fields)) model.no_echo = *rule;
  return model;
}

Result<RobotDescription> read_robot_table(const toml::table& table, std::string_view source) {
  TomlFields fields(table, source, "robot");
  RobotDescription robot;
  robot.name = fields.text("name").value_or(robot.name);
  robot.radius_m = fields.length_m("radius", 0.0, 1000.0).value_or(robot.radius_m);
  SensorCollector collector(fields);
  collector.add_array();
  collector.add_rings();
  collector.add_rows();
  collector.add_explicit();
  robot.lasers = read_lasers(fields);
  if (const Result<void> done = fields.finish(); !done) return done.error();
  Result<SensorArray> sensors = SensorArray::make(collector.take());
  if (!sensors) {
    Error error = sensors.error();
    error.where = toml_place(source, table.source()) + (error.where.empty() ? "" : ", " + error.where);
    return error;
  }
  robot.sensors = std::move(*sensors);
  return robot;
}

}  // namespace echoarc::io
