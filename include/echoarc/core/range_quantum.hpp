// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>

namespace echoarc {

/// Step of the ranges of Nomad-type bases: one inch, in metres ([Silver04] 2, [Choset03] IV-B).
inline constexpr double inch_m = 0.0254;

/// How a sensor turns a distance into a whole number of steps. The papers do not say which one their robots used.
enum class Quantisation : std::uint8_t {
  round,     ///< to the nearest step, halves away from zero; the reading stands for [r - q/2, r + q/2]
  truncate,  ///< to the step below; the reading stands for [r, r + q)
};

/// `range_m` as a sensor with steps of `quantum_m` > 0 reports it.
///
/// A distance within 1e-9 steps of a half (or, truncating, of a whole) counts as that half (whole): decimal input such
/// as 1.0287 m is 40.5 inches, yet its quotient in binary may fall short of it, and a reading on a step must stay
/// there.
[[nodiscard]] inline double quantise(double range_m, double quantum_m, Quantisation mode = Quantisation::round) {
  assert(quantum_m > 0.0);
  constexpr double slack = 1e-9;
  const double steps = std::abs(range_m) / quantum_m + slack;
  const double whole = mode == Quantisation::round ? std::floor(steps + 0.5) : std::floor(steps);
  return std::copysign(whole * quantum_m, range_m);
}

}  // namespace echoarc
