// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/sim/simulate.hpp"
#include "echoarc/sim/world.hpp"
#include "sim/drive_plan.hpp"
#include "sim/firing_schedule.hpp"

namespace echoarc::sim {

/// A scene on its way: what every kind of record is made from.
struct Run {
  const Scene& scene;
  const World& world;
  const DrivePlan& plan;
  const FiringSchedule& schedule;
  std::uint64_t seed;
  const SimulationHost& host;
};

/// Truth and odometry, at the rate of the odometry and whenever a stop begins or ends. Errors: more than `max_firings`
/// records; a moving disc that hits the robot.
[[nodiscard]] Result<void> record_poses(const Run& run, Log& log);

/// The pings of every firing, in order. False: cancelled.
[[nodiscard]] bool record_pings(const Run& run, Simulation& simulation);

/// Laser scans, at their rates or one a stop. Error: more than 10^9 beams.
[[nodiscard]] Result<void> record_scans(const Run& run, Log& log);

/// The side on which a drive with stops has its wall, if the robot looks straight to one side.
void record_wall(const Run& run, Log& log);

}  // namespace echoarc::sim
