// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/scene_input.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "echoarc/io/builtin.hpp"
#include "echoarc/io/config.hpp"
#include "echoarc/io/robot_toml.hpp"

namespace echoarc::cli {
namespace {

namespace fs = std::filesystem;

std::vector<io::OptionSection> scene_sections() {
  return {{"sonar", option_specs<sim::SonarOptions>()},
          {"drive", option_specs<sim::Drive>()},
          {"odometry", option_specs<sim::OdometryOptions>()},
          {"polling", option_specs<sim::PollingOptions>()},
          {"laser", option_specs<sim::LaserOptions>()}};
}

Result<void> set_in(sim::Scene& scene, const io::Setting& setting) {
  if (setting.section == "sonar") return set_option(scene.sonar, setting.option, setting.value);
  if (setting.section == "drive") return set_option(scene.drive, setting.option, setting.value);
  if (setting.section == "odometry") return set_option(scene.odometry, setting.option, setting.value);
  if (setting.section == "polling") return set_option(scene.polling, setting.option, setting.value);
  for (sim::LaserOptions& laser : scene.lasers)
    if (Result<void> set = set_option(laser, setting.option, setting.value); !set) return set;
  return {};
}

/// `text` with the table that has its option, if it names none and there is only one.
Result<std::string> with_section(const std::string& text, const std::vector<io::OptionSection>& sections) {
  const std::string key = text.substr(0, text.find('='));
  if (text.find('=') == std::string::npos || key.find('.') != std::string::npos) return text;
  std::vector<std::string> owners;
  std::vector<OptionSpec> known;
  for (const io::OptionSection& section : sections) {
    if (std::ranges::find(section.specs, key, &OptionSpec::name) != section.specs.end()) owners.push_back(section.name);
    known.insert(known.end(), section.specs.begin(), section.specs.end());
  }
  if (owners.size() == 1) return owners.front() + "." + text;
  if (owners.empty()) return unknown_option(key, known);
  return Error{ErrorCode::bad_value, fmt::format("{} is an option of {}", key, fmt::join(owners, " and ")),
               "--set " + text, fmt::format("say which: {}.{}", owners.front(), text)};
}

}  // namespace

Result<io::SceneFile> load_scene(const std::string& name) {
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored)) return io::read_scene_file(name);
  if (const std::optional<std::string_view> text = io::builtin_scene(name)) return io::read_scene(*text, name);
  std::vector<std::string_view> names;
  for (const io::BuiltinText& scene : io::builtin_scenes()) names.push_back(scene.name);
  return Error{ErrorCode::not_found, "there is no such file, and no scene of that name", name,
               fmt::format("give a scene.toml, or one of {}", fmt::join(names, ", "))};
}

Result<RobotDescription> load_robot(const std::string& name) {
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored)) return io::read_robot_toml(name);
  if (const std::optional<std::string_view> text = io::builtin_robot(name)) return io::parse_robot_toml(*text, name);
  std::vector<std::string_view> names;
  for (const io::BuiltinText& robot : io::builtin_robots()) names.push_back(robot.name);
  return Error{ErrorCode::not_found, "there is no such file, and no robot of that name", name,
               fmt::format("give a robot.toml, or one of {}", fmt::join(names, ", "))};
}

Result<void> apply_scene_settings(sim::Scene& scene, const std::vector<std::string>& settings) {
  const std::vector<io::OptionSection> sections = scene_sections();
  for (const std::string& text : settings) {
    const Result<std::string> full = with_section(text, sections);
    if (!full) return full.error();
    const Result<io::Setting> setting = io::parse_setting(*full, sections);
    if (!setting) return setting.error();
    if (const Result<void> set = set_in(scene, *setting); !set) return set;
  }
  return {};
}

}  // namespace echoarc::cli
