// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/maps/grid_geometry.hpp"

/// The integration example V5.3 of the method specification: eleven arcs of 1 m range along a wall at y = 1.005 m.
namespace echoarc::test {

inline constexpr int v53_arcs = 11;

inline GridGeometry v53_geometry() {
  return {0.01, {-0.30, 0.0}};
}

/// The region of the example; columns are its directions of interest.
inline CellBox v53_region() {
  return {0, 0, 121, 130};
}

/// Sets the grid members of a method's options to the example's grid.
template <class Options>
Options with_v53_grid(Options options = {}) {
  options.cell_m = v53_geometry().cell_m;
  options.origin_x_m = v53_geometry().origin.x;
  options.origin_y_m = v53_geometry().origin.y;
  return options;
}

/// A monostatic reading; robot and sensor share the pose.
inline Reading monostatic_reading(Pose2 T_world_sensor, Outcome outcome, Angle beam_width = degrees(25.0)) {
  Reading reading;
  reading.T_world_robot = reading.T_world_tx = reading.T_world_rx = T_world_sensor;
  reading.beam_width = beam_width;
  reading.outcome = outcome;
  return reading;
}

/// S = (0.005 + 0.05 k, 0.005), r = 1 m, line of sight +y, half beam 12.5 degrees, k = 0 ... 10.
inline std::vector<Reading> v53_readings() {
  std::vector<Reading> readings;
  for (int k = 0; k < v53_arcs; ++k) {
    Reading reading = monostatic_reading({{0.005 + 0.05 * k, 0.005}, degrees(90.0)}, Echo{1.0});
    reading.ping = PingId(k);
    reading.scan = std::uint32_t(k);
    reading.time_s = 0.1 * k;
    readings.push_back(reading);
  }
  return readings;
}

/// Points (x, 1.005), x = 0 ... 0.52 in steps of 2 mm.
inline std::vector<Vec2> v53_reference() {
  std::vector<Vec2> points;
  for (int k = 0; k <= 260; ++k) points.push_back({0.002 * k, 1.005});
  return points;
}

}  // namespace echoarc::test
