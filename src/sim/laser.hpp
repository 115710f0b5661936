// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/core/log.hpp"
#include "echoarc/sim/scene.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// One scan: the nearest surface along every beam, with noise; no return beyond the mount's range limits, nor from
/// surfaces that swallow light. `number` counts the scans of this laser; noise is drawn by it.
[[nodiscard]] Scan scan_of(const World& world, const LaserMount& mount, const LaserOptions& options,
                           const Pose2& T_world_robot, double time_s, std::uint64_t seed, std::uint64_t number);

}  // namespace echoarc::sim
