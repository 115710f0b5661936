// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"

namespace echoarc::test {

inline constexpr double inf = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline SensorModel model_of(double range_min_m, double range_max_m, NoEchoRule rule = {}) {
  SensorModel model;
  model.range_min_m = range_min_m;
  model.range_max_m = range_max_m;
  model.trusted_range_m = range_max_m / 2;
  model.no_echo = rule;
  return model;
}

inline Odometry odometry_at(double time_s, double x_m = 0.0, Angle heading = {}) {
  return {.time_s = time_s, .T_world_robot = {{x_m, 0.0}, heading}};
}

inline Ping ping_at(double time_s, SensorId sensor, double range_m) {
  Ping ping;
  ping.time_s = time_s;
  ping.tx = sensor;
  ping.rx = sensor;
  ping.range_m = range_m;
  return ping;
}

/// A robot with a ring of `sensors`, driving along x at 0.2 m/s past walls whose ranges never repeat; every seventh
/// ping hears nothing and says `silence`. Odometry at 10 Hz, a sweep every 0.25 s, line numbers as in a file.
inline Log drive(double silence, const SensorModel& model, int sensors = 4, int sweeps = 60) {
  Log log;
  log.robot.sensors = SensorArray::make(ring(sensors, 0.2, Angle{}, model)).value();
  const double duration_s = sweeps * 0.25;
  for (int k = 0; k <= static_cast<int>(duration_s * 10) + 1; ++k)
    log.odometry.push_back({.time_s = 0.1 * k,
                            .T_world_robot = {{0.02 * k, 0.001 * k}, radians(0.01 * k)},
                            .line = static_cast<std::uint64_t>(2 * k + 1)});
  for (int k = 0; k < sweeps * sensors; ++k) {
    const double range_m = model.range_min_m + (model.range_max_m - model.range_min_m) * std::fmod(0.6180339 * k, 0.97);
    Ping ping = ping_at(0.25 * k / sensors, static_cast<SensorId>(k % sensors), k % 7 == 3 ? silence : range_m + 1e-3);
    ping.line = static_cast<std::uint64_t>(2 * k + 2);
    log.pings.push_back(ping);
  }
  return log;
}

}  // namespace echoarc::test
