// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

#include "echoarc/core/result.hpp"
#include "echoarc/sim/simulate.hpp"

namespace echoarc::io {

/// Draws a simulated drive: the world, the robot's true path, and the first echo of every window, coloured by what it
/// came from. An echo is put on the axis of its sensor at its range (of another sensor's ping: on the middle bearing,
/// from the middle of both), so that what misleads a map stands where it does. Errors: those of `write_picture`.
[[nodiscard]] Result<void> write_simulation_picture(const std::filesystem::path& path, const sim::Scene& scene,
                                                    const sim::Simulation& simulation);

}  // namespace echoarc::io
