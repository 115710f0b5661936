// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/core/log.hpp"

namespace echoarc::sim {

/// The range registers of an array without time stamps ([Silver04] App. A), read at a fixed rate from 0 to `end_s`. A
/// sensor's register takes its new value when the echo arrives, or at the time-out 2 r_max / c if none does; before
/// that, and before the first firing, it holds the old one. `pings` in order of time, each heard by its own sensor,
/// with their times of flight; later echoes do not reach a register.
[[nodiscard]] std::vector<Poll> poll_registers(const SensorArray& array, std::span<const Ping> pings, double rate_hz,
                                               double end_s, double speed_of_sound_m_s);

}  // namespace echoarc::sim
