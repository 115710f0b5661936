// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::sim {

/// What a run of the simulator counted.
struct SimulationReport {
  std::uint64_t firings = 0;
  std::uint64_t truncated_pings = 0;  ///< pings whose search for paths met its bound
};

struct Simulation {
  Log log;  ///< with truth, and the cause of every echo in its pings
  SimulationReport report;
};

/// What a host may be told or ask; every part may be left out.
struct SimulationHost {
  std::function<void(double fraction)> progress;
  std::function<bool()> cancelled;
};

/// Drives the scene's robot through its world and records what its sensors say. The same scene and seed give the same
/// log, byte for byte; every ping draws from its own stream of random numbers, so that a change of one option leaves
/// the noise of the rest as it was. Errors: those of `World::make`; a robot without sensors; a drive that starts in or
/// runs into a surface (says where and when); options out of range.
[[nodiscard]] Result<Simulation> simulate(const Scene& scene, std::uint64_t seed, const SimulationHost& host = {});

}  // namespace echoarc::sim
