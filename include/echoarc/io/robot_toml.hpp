// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// Reads a robot description. Unknown keys, wrong types and impossible sensors are errors that name line and remedy; a
/// file larger than 1 MiB is refused.
[[nodiscard]] Result<RobotDescription> read_robot_toml(const std::filesystem::path& path);
/// The same from text; `source` names it in messages.
[[nodiscard]] Result<RobotDescription> parse_robot_toml(std::string_view text, std::string_view source);

enum class SensorLayout { ring, row };

/// A commented robot.toml of `count` sensors of a preset, that reads back as it stands. Errors: an unknown preset, a
/// count outside 1 to `SensorArray::max_sensors`.
[[nodiscard]] Result<std::string> robot_toml_template(std::string_view preset, int count, SensorLayout layout);

}  // namespace echoarc::io
