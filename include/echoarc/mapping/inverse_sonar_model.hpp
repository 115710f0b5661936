// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/options.hpp"

namespace echoarc {

/// How the certainty of a beam falls from its axis to its edge.
enum class BeamProfile {
  gaussian,   ///< exp(-theta^2 / 2 sigma^2), sigma a fraction of the half width
  uniform,    ///< 1 across the beam
  parabolic,  ///< 1 - (theta / half width)^2
};
constexpr std::array<Choice<BeamProfile>, 3> choices(BeamProfile /*tag*/) {
  return {
      {{BeamProfile::gaussian, "gaussian"}, {BeamProfile::uniform, "uniform"}, {BeamProfile::parabolic, "parabolic"}}};
}

/// The occupied band reaches this many standard deviations to both sides of the range.
inline constexpr double band_sigmas = 2.0;

/// What one echo says of a cell: the sonar model that Moravec and Elfes introduced, in the form that [Choset03] II-A
/// and [Silver04] 2.B describe (their Fig. 3).
///
///     |sigma - r| <= 2 sigma_r:      p = 1/2 + (p_max - 1/2) a(theta) exp(-(sigma - r)^2 / 2 sigma_r^2)
///     r_min <= sigma < r - 2 sigma_r:  p = 1/2 - (1/2 - p_min) a(theta)
///
/// with sigma the distance and theta the bearing of the cell from the beam's axis, and a(theta) the profile.
struct InverseSonarModel {
  BeamProfile profile = BeamProfile::gaussian;
  Angle half_width = degrees(12.5);
  double angular_sigma = 0.5;   ///< of the gaussian profile, as a fraction of the half width
  double range_sigma_m = 0.02;  ///< sigma_r
  double occupied_peak = 0.85;  ///< p_max, in (1/2, 1)
  double free_floor = 0.25;     ///< p_min, in (0, 1/2)

  /// a(theta) in [0, 1]; 0 outside the beam.
  [[nodiscard]] double angular_factor(Angle theta) const;
  /// p(occupied) at a distance `range_error_m` behind (negative: before) the echo; 1/2 outside the band.
  [[nodiscard]] double band_probability(double range_error_m, Angle theta) const;
  /// p(occupied) between the sensor and the band.
  [[nodiscard]] double free_probability(Angle theta) const;

  friend bool operator==(const InverseSonarModel&, const InverseSonarModel&) = default;
};

/// ln(p / (1 - p)).
[[nodiscard]] double log_odds(double probability);
/// 1 / (1 + exp(-l)).
[[nodiscard]] double probability(double log_odds);

}  // namespace echoarc
