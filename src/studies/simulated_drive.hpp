// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/reading.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::studies {

/// A simulated log and its readings.
struct SimulatedDrive {
  Log log;
  std::vector<Reading> readings;
};

/// Errors: those of `simulate`.
[[nodiscard]] Result<SimulatedDrive> simulate_drive(const sim::Scene& scene, std::uint64_t seed,
                                                    const SensingOptions& sensing = {});

/// How far a drive went, by its true poses (its odometry where there are none), metres.
[[nodiscard]] double path_length_m(const Log& log);

}  // namespace echoarc::studies
