// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

namespace echoarc {

/// Air temperature assumed where nothing else is known: 20 degrees Celsius, [Barshan07] 2.
inline constexpr double default_temperature_k = 293.0;

/// Speed of sound in air, m/s: 331.4 sqrt(T / 273), [Barshan07] 2, footnote 1. `temperature_k` > 0, in kelvin.
[[nodiscard]] inline double speed_of_sound_m_s(double temperature_k) {
  return 331.4 * std::sqrt(temperature_k / 273.0);
}

/// Range of an echo that came back after `time_s`: r = c t / 2. For receiver != transmitter it is half of the path.
[[nodiscard]] inline double range_of_flight_time_m(double time_s, double temperature_k) {
  return speed_of_sound_m_s(temperature_k) * time_s / 2.0;
}

/// Seconds until the echo of something at `range_m` is back: t = 2 r / c. At the maximum range of a sensor it is the
/// shortest interval between pings without cross-talk.
[[nodiscard]] inline double flight_time_of_range_s(double range_m, double temperature_k) {
  return 2.0 * range_m / speed_of_sound_m_s(temperature_k);
}

/// What a range has to be multiplied with that was computed for air of `recorded_k` while the air had `actual_k`:
/// c(actual) / c(recorded). Both in kelvin, > 0.
[[nodiscard]] inline double rerange_factor(double recorded_k, double actual_k) {
  return std::sqrt(actual_k / recorded_k);
}

}  // namespace echoarc
