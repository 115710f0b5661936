// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/simulated_drive.hpp"

#include <utility>

#include "echoarc/sensing/sensing.hpp"
#include "echoarc/sim/simulate.hpp"

namespace echoarc::studies {

Result<SimulatedDrive> simulate_drive(const sim::Scene& scene, std::uint64_t seed, const SensingOptions& sensing) {
  Result<sim::Simulation> simulation = sim::simulate(scene, seed);
  if (!simulation) return simulation.error();
  SimulatedDrive drive;
  drive.readings = sense(simulation->log, sensing).readings;
  drive.log = std::move(simulation->log);
  return drive;
}

double path_length_m(const Log& log) {
  const std::vector<Odometry>& path = log.truth.empty() ? log.odometry : log.truth;
  double length_m = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k)
    length_m += norm(path[k].T_world_robot.position - path[k - 1].T_world_robot.position);
  return length_m;
}

}  // namespace echoarc::studies
