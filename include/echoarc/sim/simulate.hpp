// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "echoarc/core/echo_cause.hpp"
#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::sim {

/// What a run of the simulator counted. A window is one receiver listening after one firing.
struct SimulationReport {
  std::uint64_t firings = 0;
  std::uint64_t windows = 0;
  std::uint64_t silent_windows = 0;                             ///< in which nothing was heard
  std::array<std::uint64_t, echo_cause_names.size()> echoes{};  ///< first echoes by cause
  std::uint64_t truncated_pings = 0;                            ///< searches for paths that met their bound
  double path_m = 0.0;
  double duration_s = 0.0;
};

struct Simulation {
  Log log;                         ///< with truth, and the cause of every echo in its pings
  std::vector<Ping> polled_pings;  ///< of a log with polls: the pings behind them, which it does not hold
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
/// runs into a surface (says where and when), has a leg without length, or more than 10^7 firings; options out of
/// range; a laser that the robot does not have; polled registers with stops or with all sensors listening.
[[nodiscard]] Result<Simulation> simulate(const Scene& scene, std::uint64_t seed, const SimulationHost& host = {});

}  // namespace echoarc::sim
