// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/fitted_beam.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "echoarc/mapping/evidence_grid.hpp"

namespace echoarc {
namespace {

// Fitted log-odds stay within half a unit of the model, so that rounding makes it one unit at most: the logit turns an
// error of 5e-6 of each factor into less than 0.1 unit at the default certainties.
constexpr double log_odds_tolerance_units = 0.3;
constexpr double factor_tolerance = 5e-6;
// In fixed point every place rounds in its own way. Where one in 64 stays so near, none strays by one and a half: that
// is the unit beside the rounded model's.
constexpr double fixed_tolerance_units = 0.95;
constexpr double fine_check_step = 64.0;
constexpr double coarse_check_step = 1024.0;  // refuses most of what does not do, cheaply

/// The bends that are tried, in reciprocals of the edge's s.
constexpr double edge_bends[] = {0.0, 0.5, 1.0, 1.5, 2.0};

using Terms = std::vector<double>;

/// Coefficients in powers of x of the polynomial through f at the Chebyshev nodes of [low, high], by Newton's divided
/// differences.
Terms interpolate(const std::function<double(double)>& f, double low, double high, int terms) {
  Terms nodes(terms);
  Terms differences(terms);
  for (int k = 0; k < terms; ++k) {
    nodes[k] = low + 0.5 * (high - low) * (1.0 - std::cos((k + 0.5) * std::numbers::pi / terms));
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
                                                  double tolerance, int most_terms) {
  constexpr int checks = 200;
  for (int terms = 1; terms <= most_terms; ++terms) {
    const Terms powers = interpolate(function, 0.0, high, terms);
    kernels::Polynomial polynomial{};
    polynomial.terms = terms;
    for (int k = 0; k < terms; ++k) polynomial.c[k] = static_cast<float>(powers[k]);
    const auto follows = [&](int check) {
      const double x = high * check / checks;
      return std::abs(double(evaluate(polynomial, static_cast<float>(x))) - function(x)) <= tolerance;  // no NaN
    };
    int check = checks;
    while (check >= 0 && follows(check)) --check;
    if (check < 0) return polynomial;
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
  for (const double edge_bend : edge_bends) {
    const double bend = edge_bend / edge;
    auto fit = fit_polynomial([&](double y) { return of_sine_squared(std::min(y / (1.0 - bend * y), edge)); },
                              edge / (1.0 + edge_bend), tolerance, best ? best->terms - 1 : kernels::max_terms);
    if (!fit) continue;
    fit->bend = static_cast<float>(bend);
    best = fit;
  }
  return best;
}

/// A polynomial of z with room for its intermediate sums in 16 bits.
std::optional<kernels::FixedPolynomial> in_fixed_point(const Terms& powers) {
  double largest = 0.0;
  for (const double c : powers) largest += std::abs(c);
  const double unit = std::ceil(1.01 * largest);
  if (!(unit <= 32767.0)) return std::nullopt;
  kernels::FixedPolynomial polynomial{};
  polynomial.terms = static_cast<int>(powers.size());
  polynomial.unit = static_cast<std::int16_t>(unit);
  for (std::size_t k = 0; k < powers.size(); ++k)
    polynomial.c[k] = static_cast<std::int16_t>(std::lrint(powers[k] * 32768.0 / unit));
  return polynomial;
}

/// The shortest polynomial in fixed point that follows a function of y on [0, edge] to within a whole unit, all
/// rounding included.
std::optional<kernels::FixedPolynomial> fit_fixed(const std::function<double(double)>& of_y, double edge,
                                                  int most_terms) {
  constexpr double places = 32768.0;
  const double begin = kernels::fixed_begin;
  const double end = kernels::fixed_end;
  const auto of_place = [&](double place) {
    return of_y(edge * std::clamp((place - begin) / (end - begin), 0.0, 1.0));
  };
  const auto follows = [&](const kernels::FixedPolynomial& polynomial, double step) {
    for (double place = begin; place <= end; place += step)
      if (!(std::abs(fixed_value(polynomial, std::int16_t(place)) - of_place(place)) <= fixed_tolerance_units))
        return false;
    return true;
  };
  const auto of_z = [&](double z) { return of_place(z * places); };
  for (int terms = 2; terms <= most_terms; ++terms) {
    const auto polynomial = in_fixed_point(interpolate(of_z, begin / places, end / places, terms));
    if (polynomial && follows(*polynomial, coarse_check_step) && follows(*polynomial, fine_check_step))
      return polynomial;
  }
  return std::nullopt;
}

/// As `fit_angular`, in fixed point. None for beams so narrow that single precision blurs their edge.
std::optional<kernels::FixedPolynomial> fit_fixed_angular(const std::function<double(double)>& of_sine_squared,
                                                          double edge) {
  if (edge < 1e-6) return std::nullopt;
  std::optional<kernels::FixedPolynomial> best;
  for (const double edge_bend : edge_bends) {
    const double bend = edge_bend / edge;
    const double y_edge = edge / (1.0 + edge_bend);
    auto fit = fit_fixed([&](double y) { return of_sine_squared(std::min(y / (1.0 - bend * y), edge)); }, y_edge,
                         best ? best->terms - 1 : kernels::max_fixed_terms);
    if (!fit) continue;
    const double stretch = (double(kernels::fixed_end) - double(kernels::fixed_begin)) / y_edge;
    fit->across_scale = static_cast<float>(std::sqrt(stretch));
    fit->bend = static_cast<float>(bend / stretch);
    best = fit;
  }
  return best;
}

FittedFree fit_free(const std::function<double(double)>& of_sine_squared, double edge) {
  if (const auto flat = fit_polynomial(of_sine_squared, edge, log_odds_tolerance_units, 1))
    return static_cast<std::int16_t>(std::lrint(flat->c[0]));
  if (const auto fixed = fit_fixed_angular(of_sine_squared, edge)) return *fixed;
  if (const auto floating = fit_angular(of_sine_squared, edge, log_odds_tolerance_units)) return *floating;
  return {};
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
  return kernels::BandModel{*angular, *radial, *logit};
}

}  // namespace

FittedBeam fit_beam(const InverseSonarModel& model, double free_weight) {
  FittedBeam beam{{model, free_weight}, {}, {}};
  const double edge = sin(model.half_width) * sin(model.half_width);
  // Rounding must not push the last check point out of the beam, where the factor is 0.
  const auto angle_of = [&](double sin_squared) {
    return std::min(radians(std::asin(std::sqrt(std::min(sin_squared, 1.0)))), model.half_width);
  };
  beam.free = fit_free(
      [&](double s) { return free_weight * log_odds(model.free_probability(angle_of(s))) / log_odds_unit; }, edge);
  beam.band = fit_band(model, angle_of);
  return beam;
}

int fixed_value(const kernels::FixedPolynomial& polynomial, std::int16_t z) {
  const auto product = [](int a, int b) { return std::int16_t((a * b + (1 << 14)) >> 15); };
  std::int16_t sum = polynomial.c[polynomial.terms - 1];
  for (int k = polynomial.terms - 2; k >= 0; --k) sum = std::int16_t(product(sum, z) + polynomial.c[k]);
  return product(sum, polynomial.unit);
}

int to_units(double log_odds) {
  return static_cast<int>(std::nearbyint(log_odds / log_odds_unit));
}

}  // namespace echoarc
