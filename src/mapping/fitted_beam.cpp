// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/fitted_beam.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "echoarc/mapping/evidence_grid.hpp"

namespace echoarc {
namespace {

// Fitted log-odds stay within half a unit of the model, so that rounding makes it one unit at most: the logit turns an
// error of 5e-6 of each factor into less than 0.1 unit at the default certainties.
constexpr double log_odds_tolerance_units = 0.3;
constexpr double factor_tolerance = 5e-6;

using Terms = std::vector<double>;

/// Coefficients in powers of x of the polynomial through f at the Chebyshev nodes of [0, high], by Newton's divided
/// differences.
Terms interpolate(const std::function<double(double)>& f, double high, int terms) {
  Terms nodes(terms);
  Terms differences(terms);
  for (int k = 0; k < terms; ++k) {
    nodes[k] = 0.5 * high * (1.0 - std::cos((k + 0.5) * std::numbers::pi / terms));
    differences[k] = f(nodes[k]);
  }
  for (int order = 1; order < terms; ++order)
    for (int k = terms - 1; k >= order; --k)
      differences[k] = (differences[k] - differences[k - 1]) / (nodes[k] - nodes[k - order]);
  Terms powers(terms, 0.0);
  for (int k = terms - 1; k >= 0; --k) {  // powers <- powers * (x - nodes[k]) + differences[k]
    for (int p = terms - 1; p > 0; --p) powers[p] = powers[p - 1] - nodes[k] * powers[p];
    powers[0] = differences[k] - nodes[k] * powers[0];
  }
  return powers;
}

float evaluate(const kernels::Polynomial& polynomial, float x) {
  float sum = 0.0F;
  for (int k = polynomial.terms - 1; k >= 0; --k) sum = sum * x + polynomial.c[k];
  return sum;
}

}  // namespace

std::optional<kernels::Polynomial> fit_polynomial(const std::function<double(double)>& function, double high,
                                                  double tolerance) {
  constexpr int checks = 200;
  for (int terms = 1; terms <= kernels::max_terms; ++terms) {
    const Terms powers = interpolate(function, high, terms);
    kernels::Polynomial polynomial{};
    polynomial.terms = terms;
    for (int k = 0; k < terms; ++k) polynomial.c[k] = static_cast<float>(powers[k]);
    double worst = 0.0;
    for (int k = 0; k <= checks; ++k) {
      const double x = high * k / checks;
      const double error = std::abs(double(evaluate(polynomial, static_cast<float>(x))) - function(x));
      worst = error <= worst ? worst : error;  // NaN counts as worst
    }
    if (worst <= tolerance) return polynomial;
  }
  return std::nullopt;
}

namespace {

/// The shortest polynomial in y = s / (1 + bend s) that follows a function of s = sin^2 theta on [0, edge]. The
/// log-odds of a gaussian beam have a singularity close behind s = 0 and others off the axis; bending s moves the first
/// away without drawing the others near.
std::optional<kernels::Polynomial> fit_angular(const std::function<double(double)>& of_sine_squared, double edge,
                                               double tolerance) {
  std::optional<kernels::Polynomial> best;
  for (const double edge_bend : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    const double bend = edge_bend / edge;
    auto fit = fit_polynomial([&](double y) { return of_sine_squared(std::min(y / (1.0 - bend * y), edge)); },
                              edge / (1.0 + edge_bend), tolerance);
    if (!fit || (best && best->terms <= fit->terms)) continue;
    fit->bend = static_cast<float>(bend);
    best = fit;
  }
  return best;
}

std::optional<kernels::BandModel> fit_band(const InverseSonarModel& model,
                                           const std::function<Angle(double)>& angle_of) {
  const double edge = sin(model.half_width) * sin(model.half_width);
  const double depth_m = band_sigmas * model.range_sigma_m;
  const auto angular = fit_angular([&](double s) { return model.angular_factor(angle_of(s)); }, edge, factor_tolerance);
  const auto radial =
      fit_polynomial([&](double e) { return std::exp(-0.5 * e / (model.range_sigma_m * model.range_sigma_m)); },
                     depth_m * depth_m, factor_tolerance);
  // The log-odds are odd in the height h. Their quotient by h is even, and a polynomial of h^2 needs half the terms.
  const double amplitude = model.occupied_peak - 0.5;
  const auto quotient = [&](double h_squared) {
    const double h = std::max(std::sqrt(h_squared), 1e-4);  // below it the quotient is flat to 1e-8
    return log_odds(0.5 + amplitude * h) / (h * log_odds_unit);
  };
  const auto logit = fit_polynomial(quotient, 1.0, log_odds_tolerance_units);
  if (!angular || !radial || !logit) return std::nullopt;
  return kernels::BandModel{*angular, *radial, *logit, 0.0F};
}

}  // namespace

FittedBeam fit_beam(const InverseSonarModel& model, double free_weight) {
  FittedBeam beam{model, free_weight, {}, {}};
  const double edge = sin(model.half_width) * sin(model.half_width);
  // Rounding must not push the last check point out of the beam, where the factor is 0.
  const auto angle_of = [&](double sin_squared) {
    return std::min(radians(std::asin(std::sqrt(std::min(sin_squared, 1.0)))), model.half_width);
  };
  beam.free =
      fit_angular([&](double s) { return free_weight * log_odds(model.free_probability(angle_of(s))) / log_odds_unit; },
                  edge, log_odds_tolerance_units);

  beam.band = fit_band(model, angle_of);
  return beam;
}

int to_units(double log_odds) {
  return static_cast<int>(std::nearbyint(log_odds / log_odds_unit));
}

}  // namespace echoarc
