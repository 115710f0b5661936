// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "echoarc/mapping/inverse_sonar_model.hpp"
#include "mapping/evidence_kernels.hpp"

namespace echoarc {

/// The lowest polynomial that follows `function` on [0, high] within `tolerance`, evaluated in single precision; none
/// when `most_terms` do not suffice. Interpolates at Chebyshev nodes.
[[nodiscard]] std::optional<kernels::Polynomial> fit_polynomial(const std::function<double(double)>& function,
                                                                double high, double tolerance,
                                                                int most_terms = kernels::max_terms);

/// The log-odds of free cells across the beam, in units of the grid, in the cheapest form that follows the model: a
/// constant (uniform profile), 16-bit fixed point (usual beams and certainties), single precision, or none (beams near
/// 180 degrees, certainties near 1): then cells are computed one by one from the model.
using FittedFree = std::variant<std::monostate, std::int16_t, kernels::FixedPolynomial, kernels::Polynomial>;

/// A model and what multiplies its log-odds of free cells (silence clears with less weight than an echo).
struct WeightedModel {
  InverseSonarModel model;
  double free_weight = 1.0;

  friend bool operator==(const WeightedModel&, const WeightedModel&) = default;
};

/// An inverse sonar model in the form the kernels evaluate, in units of the grid.
struct FittedBeam : WeightedModel {
  FittedFree free;
  std::optional<kernels::BandModel> band;  ///< absent like `free`

  [[nodiscard]] bool complete() const { return free.index() != 0 && band.has_value(); }
};

[[nodiscard]] FittedBeam fit_beam(const InverseSonarModel& model, double free_weight);

/// What the kernel makes of z, in units.
[[nodiscard]] int fixed_value(const kernels::FixedPolynomial& polynomial, std::int16_t z);

/// Log-odds in whole units of the grid, ties to even as in the kernels.
[[nodiscard]] int to_units(double log_odds);

}  // namespace echoarc
