// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/robot_toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files.hpp"
#include "io/sensor_toml.hpp"

namespace echoarc::io {

Result<RobotDescription> parse_robot_toml(std::string_view text, std::string_view source) {
  const Result<toml::table> table = parse_toml(text, source);
  if (!table) return table.error();
  Result<RobotDescription> robot = read_robot_table(*table, source);
  if (robot && robot->sensors.empty())
    return Error{ErrorCode::bad_value, "the robot has no sensors", std::string(source),
                 "add [[sensors]], ring = { ... } or row = { ... }; `echoarc init` writes an example"};
  return robot;
}

Result<RobotDescription> read_robot_toml(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, max_description_bytes);
  if (!text) return text.error();
  return parse_robot_toml(*text, path.string());
}

}  // namespace echoarc::io
