// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"
#include "echoarc/sim/world.hpp"
#include "sim/trajectory.hpp"

namespace echoarc::sim {

/// A scripted drive, worked out.
struct DrivePlan {
  Trajectory trajectory;
  std::vector<double> stops_s;  ///< when each stop begins; empty: a drive without stops
  bool with_stops = false;
};

/// Bound on the stops of a drive, and on its firings.
inline constexpr std::size_t max_firings = 10'000'000;

/// The poses of a drive over time. Every stop rests for `stop_rest_s`; the drive ends when the last leg does, or the
/// last stop. Errors, at the leg's line: a leg without length or direction, with coordinates that are not finite, and
/// more than `max_firings` stops.
[[nodiscard]] Result<DrivePlan> plan_drive(const Drive& drive, double stop_rest_s);

/// An error, with place, time and remedy, if the robot's hull touches a surface on its way.
[[nodiscard]] Result<void> check_clearance(const World& world, const Trajectory& trajectory, double hull_radius_m);

}  // namespace echoarc::sim
