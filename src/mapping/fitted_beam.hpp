// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <optional>

#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "mapping/evidence_kernels.hpp"

namespace echoarc {

/// The lowest polynomial that follows `function` on [0, high] within `tolerance`, evaluated in single precision; none
/// when `kernels::max_terms` do not suffice. Interpolates at Chebyshev nodes.
[[nodiscard]] std::optional<kernels::Polynomial> fit_polynomial(const std::function<double(double)>& function,
                                                                double high, double tolerance);

/// An inverse sonar model in the form the kernels evaluate, in units of the grid. A part that no polynomial follows
/// closely enough (beams near 180 degrees, certainties near 1) is absent, and its cells are computed one by one from
/// the model.
struct FittedBeam {
  InverseSonarModel model;
  double free_weight = 1.0;
  std::optional<kernels::Polynomial> free;  ///< of sin^2 theta; a single term for the uniform profile
  std::optional<kernels::BandModel> band;   ///< `range_m` is set per reading
};

/// `free_weight` multiplies the log-odds of free cells (silence clears with less weight than an echo).
[[nodiscard]] FittedBeam fit_beam(const InverseSonarModel& model, double free_weight);

/// Log-odds in whole units of the grid, ties to even as in the kernels.
[[nodiscard]] int to_units(double log_odds);

}  // namespace echoarc
