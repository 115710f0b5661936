// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/result.hpp"

/// How well crossing arcs fix a point: the formulas of [Choset03] IV and [Silver04] 2.D, 5.C. Ranges, widths and
/// baselines in metres; `quantum_m` is the band of distances a range stands for, the step of the ranges.
namespace echoarc {

/// Length of the interval, along an arc, that an arc crossing it at `angle` leaves: q (1/sin + 1/tan) = q cot(angle/2)
/// ([Choset03] IV-B, [Silver04] eq. 5.4). Infinite at 0.
[[nodiscard]] double crossing_interval_m(double quantum_m, Angle angle);

/// By how much crossings at `angle` improve the resolution of an arc: n = d phi / w(angle) ([Choset03] eq. 2).
[[nodiscard]] double resolution_gain(double range_m, Angle beam_width, double quantum_m, Angle angle);

/// The least crossing angle that gives a resolution gain n: angle = 2 atan(n q / (d phi)), eq. 2 solved. Error when it
/// exceeds 90 degrees: arcs never cross at more.
[[nodiscard]] Result<Angle> angle_for_gain(double gain, double range_m, Angle beam_width, double quantum_m);

/// How far apart two sensors with ranges r1, r2 to the same point must be for their arcs to cross at `angle`:
/// D^2 = r1^2 + r2^2 - 2 r1 r2 cos(angle); with equal ranges 2 r sin(angle/2) ([Silver04] eq. 2.2).
[[nodiscard]] double crossing_baseline_m(double range_1_m, double range_2_m, Angle angle);

/// The chance that n crossings spread evenly over an arc of `arc` all fall into one given interval of it:
/// (interval/arc)^n ([Choset03] eq. 1).
[[nodiscard]] double chance_of_cluster(Angle interval, Angle arc, std::size_t n);

}  // namespace echoarc
