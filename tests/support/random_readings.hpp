// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/core/rng.hpp"
#include "support/v53_scene.hpp"

/// Made-up readings for property tests. Positions are generic: no arc end, cell corner or tie falls on a boundary.
namespace echoarc::test {

/// Anything a ping can give, anywhere within a few metres; every third reading is bistatic.
inline Reading random_reading(Rng& rng, PingId ping) {
  Reading reading;
  reading.ping = ping;
  reading.scan = std::uint32_t(ping / 4);
  reading.time_s = 0.05 * double(ping);
  reading.T_world_robot = {{rng.uniform(-2, 2), rng.uniform(-2, 2)}, degrees(rng.uniform(-180, 180))};
  const Angle yaw = degrees(rng.uniform(-180, 180));
  reading.T_world_tx = reading.T_world_robot * Pose2{0.23 * unit(yaw), yaw};
  reading.T_world_rx = reading.T_world_tx;
  reading.tx = reading.rx = SensorId(rng.below(8));
  if (rng.below(3) == 0) {
    reading.rx = reading.tx + 8;
    const Angle neighbour = yaw + degrees(rng.uniform(-60, 60));
    reading.T_world_rx = reading.T_world_robot * Pose2{0.23 * unit(neighbour), neighbour};
  }
  reading.beam_width = degrees(rng.uniform(5, 60));
  reading.outcome = Echo{rng.uniform(0.3, 3.0)};
  return reading;
}

inline std::vector<Reading> random_readings(Rng& rng, int count) {
  std::vector<Reading> readings;
  for (int k = 0; k < count; ++k) readings.push_back(random_reading(rng, PingId(k)));
  return readings;
}

inline constexpr double wall_y_m = 1.537;  ///< the wall of `wall_drive`

/// A drive along +x past a wall on the left: five sensors look at it 22.5 degrees apart, each echo comes from the point
/// of the wall that is perpendicular to the beam's nearest ray, with 5 mm of noise.
inline std::vector<Reading> wall_drive(Rng& rng, int stops) {
  std::vector<Reading> readings;
  for (int stop = 0; stop < stops; ++stop)
    for (int k = -2; k <= 2; ++k) {
      Reading reading;
      reading.ping = readings.size();
      reading.scan = std::uint32_t(stop);
      reading.time_s = 0.1 * stop + 0.01 * k;
      reading.tx = reading.rx = SensorId(k + 2);
      reading.T_world_robot = {{0.0067 + 0.0231 * stop, 0.0117}, Angle{}};
      const Angle yaw = degrees(90.0 + 22.5 * k);
      reading.T_world_tx = reading.T_world_rx = reading.T_world_robot * Pose2{0.23 * unit(yaw), yaw};
      const double distance_m = wall_y_m - reading.T_world_tx.position.y;
      const double slant = std::max(0.0, std::abs(22.5 * k) - 12.5);  // nearest ray of the beam to the wall's normal
      reading.outcome = Echo{distance_m / cos(degrees(slant)) + rng.normal(0.0, 0.005)};
      readings.push_back(reading);
    }
  return readings;
}

}  // namespace echoarc::test
