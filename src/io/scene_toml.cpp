// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/scene_toml.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "echoarc/io/builtin.hpp"
#include "echoarc/io/robot_toml.hpp"
#include "io/files.hpp"
#include "io/option_toml.hpp"
#include "io/scene_drive.hpp"
#include "io/scene_office.hpp"
#include "io/scene_scoring_toml.hpp"
#include "io/scene_world.hpp"
#include "io/sensor_toml.hpp"
#include "io/toml_points.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_lasers = 64;

/// A table that holds options and nothing else.
template <OptionStruct S>
S read_option_table(const toml::table* table, TomlFields& scene, std::string_view what) {
  S options;
  if (table == nullptr) return options;
  TomlFields fields(*table, scene.source(), what);
  read_options(fields, options);
  if (const Result<void> done = fields.finish(); !done) scene.fail(done.error());
  return options;
}

Result<RobotDescription> builtin_robot_at(TomlFields& scene, const toml::node& node, const std::string& name) {
  if (const std::optional<std::string_view> text = builtin_robot(name)) return parse_robot_toml(*text, name + ".toml");
  std::vector<std::string_view> names;
  for (const BuiltinText& robot : builtin_robots()) names.push_back(robot.name);
  fail_unknown(scene, &node, "built-in robot", name, names);
  return RobotDescription{};
}

/// `robot = "scout2"`, or a whole `[robot]`.
RobotDescription read_robot(TomlFields& scene) {
  const toml::node* node = scene.node("robot");
  if (node == nullptr) {
    scene.fail(nullptr, "the scene has no robot", R"(write robot = "nomad200", or a table [robot])");
    return {};
  }
  Result<RobotDescription> robot = RobotDescription{};
  if (const toml::table* table = node->as_table())
    robot = read_robot_table(*table, scene.source());
  else if (const auto name = scene.text("robot"))
    robot = builtin_robot_at(scene, *node, *name);
  if (!robot) {
    scene.fail(robot.error());
    return {};
  }
  if (robot->sensors.empty())
    scene.fail(node, "the robot has no sensors", R"(add array = "nomad200", ring, row or [[robot.sensors]])");
  return *robot;
}

std::vector<sim::LaserOptions> read_lasers(TomlFields& scene, const RobotDescription& robot) {
  std::vector<sim::LaserOptions> lasers;
  for (const toml::table* table : scene.tables("laser", max_lasers)) {
    lasers.push_back(read_option_table<sim::LaserOptions>(table, scene, "laser"));
    const auto id = static_cast<std::uint32_t>(lasers.back().laser);
    if (std::ranges::find(robot.lasers, id, &LaserMount::id) == robot.lasers.end())
      scene.fail(table, fmt::format("the robot has no laser {}", id), "add it to the robot as [[robot.lasers]]");
  }
  return lasers;
}

/// `[explore]`: goals = [[x, y], ...]
std::vector<Vec2> read_goals(TomlFields& scene) {
  const toml::table* table = scene.table("explore");
  if (table == nullptr) return {};
  TomlFields fields(*table, scene.source(), "explore");
  std::vector<Vec2> goals;
  for (const TomlPoint& goal : read_points(fields, "goals", 1)) goals.push_back(goal.point);
  if (const Result<void> done = fields.finish(); !done) scene.fail(done.error());
  return goals;
}

/// Whether a simulator will take the world; an error names file and line.
Result<void> check_world(const sim::WorldDescription& description, std::string_view source) {
  const Result<sim::World> world = sim::World::make(description);
  if (world) return {};
  Error error = world.error();
  constexpr std::string_view line = "line ";
  const bool at_line = error.where.starts_with(line);
  error.where = at_line ? fmt::format("{}:{}", source, error.where.substr(line.size())) : std::string(source);
  return error;
}

}  // namespace

Result<SceneFile> read_scene(std::string_view text, std::string_view source) {
  const Result<toml::table> root = parse_toml(text, source);
  if (!root) return root.error();
  TomlFields fields(*root, source, "scene");
  SceneFile file;
  sim::Scene& scene = file.scene;
  scene.name = fields.text("name").value_or("scene");
  scene.title = fields.text("title").value_or("");
  scene.source = fields.text("source").value_or("");
  scene.file = source;
  scene.world = read_world(fields);
  scene.robot = read_robot(fields);
  scene.drive = read_drive(fields);
  read_office(fields, scene);
  scene.sonar = read_option_table<sim::SonarOptions>(fields.table("sonar"), fields, "sonar");
  scene.odometry = read_option_table<sim::OdometryOptions>(fields.table("odometry"), fields, "odometry");
  scene.polling = read_option_table<sim::PollingOptions>(fields.table("polling"), fields, "polling");
  scene.lasers = read_lasers(fields, scene.robot);
  file.scoring = read_scoring(fields);
  file.goals = read_goals(fields);
  if (const Result<void> done = fields.finish(); !done) return done.error();
  if (const Result<void> checked = check_world(scene.world, source); !checked) return checked.error();
  return file;
}

Result<SceneFile> read_scene_file(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, max_scene_bytes);
  if (!text) return text.error();
  return read_scene(*text, path.string());
}

}  // namespace echoarc::io
