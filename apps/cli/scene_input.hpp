// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/io/scene_toml.hpp"

namespace echoarc::cli {

/// A scene by name or file: a file if there is one of that name, otherwise one of the scenes the program carries along.
[[nodiscard]] Result<io::SceneFile> load_scene(const std::string& name);

/// The same for a robot.
[[nodiscard]] Result<RobotDescription> load_robot(const std::string& name);

/// Puts `TABLE.OPTION=VALUE` into a scene, one after the other; tables are sonar, drive, odometry, polling, laser (all
/// of the robot's). A bare OPTION goes to the one table that has it.
[[nodiscard]] Result<void> apply_scene_settings(sim::Scene& scene, const std::vector<std::string>& settings);

}  // namespace echoarc::cli
