// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/sim/scene.hpp"
#include "studies/simulated_drive.hpp"

namespace echoarc::studies {

/// The legs of a drive `laps` times, one after the other.
[[nodiscard]] sim::Drive repeated(sim::Drive drive, int laps);

/// The drive from its leg `first` on, no longer than `length_m`: the last leg ends early. Requires `first` to be one.
[[nodiscard]] sim::Drive window_of(const sim::Drive& drive, std::size_t first, double length_m);

/// A leg to begin with, each as likely, of those with `length_m` of way still ahead; the first where there is none.
[[nodiscard]] std::size_t any_leg(const sim::Drive& drive, double length_m, std::uint64_t seed);

/// The robot is lifted at `after_s` and put down where it would have been `ahead_s` later; its odometry does not
/// notice. What it would have heard on the way is gone, and all times after it are earlier by `ahead_s`.
void carry_away(SimulatedDrive& drive, double after_s, double ahead_s);

}  // namespace echoarc::studies
