// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/acoustics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "echoarc/core/speed_of_sound.hpp"

namespace echoarc::sim {

namespace {

// Cubic pieces between exact values and slopes: the error is below step^4 / 384 times the fourth derivative, which is
// at most 1/8, so below 6e-11.
constexpr double step = 0.02;
constexpr double first_zero_of_j1 = 3.831705970207512;
// sin(25 degrees) / (lambda / a) of the transducer the papers use.
constexpr double window_factor = 1.2161827;

double wave_number_radius(const SonarOptions& options) {
  return 2.0 * std::numbers::pi * options.frequency_hz * options.aperture_radius_m /
         speed_of_sound_m_s(options.temperature_k);
}

}  // namespace

PistonBeam::PistonBeam(double wave_number_radius) : wave_number_radius_(wave_number_radius) {
  assert(wave_number_radius > 0.0 && wave_number_radius <= 10000.0);
  const auto pieces = static_cast<std::size_t>(wave_number_radius / step) + 2;
  knots_.push_back({1.0, 0.0});
  for (std::size_t i = 1; i <= pieces; ++i) {
    const double x = step * static_cast<double>(i);
    knots_.push_back({2.0 * std::cyl_bessel_j(1, x) / x, -2.0 * std::cyl_bessel_j(2, x) / x * step});
  }
}

double PistonBeam::amplitude(Angle off_axis) const {
  const Angle theta = abs(wrap(off_axis));
  if (theta.rad() >= std::numbers::pi / 2.0) return 0.0;
  const double x = wave_number_radius_ * sin(theta) / step;
  const auto piece = static_cast<std::size_t>(x);
  const double u = x - static_cast<double>(piece);
  const Knot& left = knots_[piece];
  const Knot& right = knots_[piece + 1];
  const double rise = right.value - left.value;
  const double cubic = left.slope + right.slope - 2.0 * rise;
  const double square = 3.0 * rise - 2.0 * left.slope - right.slope;
  return left.value + u * (left.slope + u * (square + u * cubic));
}

Angle PistonBeam::first_null() const {
  return radians(std::asin(std::min(1.0, first_zero_of_j1 / wave_number_radius_)));
}

namespace {

Angle half_window_of(const SonarOptions& options, const PistonBeam& beam) {
  if (options.listening == Listening::all) return degrees(90.0);
  return radians(std::asin(std::min(1.0, window_factor * 2.0 * std::numbers::pi / beam.wave_number_radius())));
}

}  // namespace

Acoustics::Acoustics(const SonarOptions& options)
    : speed_of_sound_m_s_(echoarc::speed_of_sound_m_s(options.temperature_k)),
      beam_(sim::wave_number_radius(options)),
      half_window_(half_window_of(options, beam_)),
      threshold_db_(options.threshold_db),
      flat_range_m_(options.flat_range_m),
      residual_db_per_m_(options.residual_db_per_m),
      max_order_(options.max_order),
      edge_gain_db_(options.edge_gain_db) {}

double Acoustics::level_db(const EchoPath& path, Angle transmitter_axis, Angle receiver_axis) const {
  const double both =
      beam_.amplitude(path.departure - transmitter_axis) * beam_.amplitude(path.arrival - receiver_axis);
  const double residual_db = residual_db_per_m_ * std::max(0.0, path.length_m / 2.0 - flat_range_m_);
  return 20.0 * std::log10(std::abs(both)) + path.gain_db - residual_db;
}

PathLimits Acoustics::limits(double max_length_m) const {
  return {max_order_, max_length_m, edge_gain_db_};
}

}  // namespace echoarc::sim
