// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::sim {

/// Everything about a scene that can be judged without its world and its way: options in their ranges, a robot with
/// sensors, lasers that it has, polling that makes sense.
[[nodiscard]] Result<void> check_scene(const Scene& scene);

/// The mount of a laser that `check_scene` found.
[[nodiscard]] const LaserMount* find_laser(const RobotDescription& robot, int id);

}  // namespace echoarc::sim
