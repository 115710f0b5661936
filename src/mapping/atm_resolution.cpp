// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/atm_resolution.hpp"

#include <cmath>

namespace echoarc {

double crossing_interval_m(double quantum_m, Angle angle) {
  return quantum_m / tan(0.5 * angle);
}

double resolution_gain(double range_m, Angle beam_width, double quantum_m, Angle angle) {
  return range_m * beam_width.rad() / crossing_interval_m(quantum_m, angle);
}

Result<Angle> angle_for_gain(double gain, double range_m, Angle beam_width, double quantum_m) {
  const Angle angle = radians(2.0 * std::atan(gain * quantum_m / (range_m * beam_width.rad())));
  if (angle <= degrees(90.0)) return angle;
  return Error{ErrorCode::bad_value, "arcs would have to cross at more than 90 degrees for this resolution gain",
               "gain", "ask for less, or at a larger range"};
}

double crossing_baseline_m(double range_1_m, double range_2_m, Angle angle) {
  const double difference = range_1_m - range_2_m;
  const double half_sine = sin(0.5 * angle);
  return std::sqrt(difference * difference + 4.0 * range_1_m * range_2_m * half_sine * half_sine);
}

double chance_of_cluster(Angle interval, Angle arc, std::size_t n) {
  return std::pow(interval / arc, double(n));
}

}  // namespace echoarc
