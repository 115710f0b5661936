// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/inverse_sonar_model.hpp"

#include <cmath>

namespace echoarc {

double InverseSonarModel::angular_factor(Angle theta) const {
  if (abs(theta) > half_width) return 0.0;
  switch (profile) {
    case BeamProfile::gaussian: {
      const double z = theta / (angular_sigma * half_width);
      return std::exp(-0.5 * z * z);
    }
    case BeamProfile::uniform: return 1.0;
    case BeamProfile::parabolic: {
      const double z = theta / half_width;
      return 1.0 - z * z;
    }
  }
  return 0.0;
}

double InverseSonarModel::band_probability(double range_error_m, Angle theta) const {
  const double z = range_error_m / range_sigma_m;
  if (std::abs(z) > band_sigmas) return 0.5;
  return 0.5 + (occupied_peak - 0.5) * angular_factor(theta) * std::exp(-0.5 * z * z);
}

double InverseSonarModel::free_probability(Angle theta) const {
  return 0.5 - (0.5 - free_floor) * angular_factor(theta);
}

double log_odds(double probability) {
  return std::log(probability / (1.0 - probability));
}

double probability(double log_odds) {
  return 1.0 / (1.0 + std::exp(-log_odds));
}

}  // namespace echoarc
