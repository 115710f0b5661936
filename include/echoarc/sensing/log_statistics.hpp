// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/sensing/no_echo.hpp"

namespace echoarc {

/// What one receiver reported, whether or not the pose at that moment is known.
struct SensorStatistics {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  SensorId sensor = 0;
  std::uint64_t pings = 0;
  std::uint64_t echoes = 0;
  std::uint64_t no_echoes = 0;
  std::uint64_t too_close = 0;
  std::uint64_t unusable = 0;       ///< failed measurements and ranges outside the sensor's limits
  double rate_hz = unknown;         ///< pings per second between its first and last; NaN for fewer than two times
  double range_min_m = unknown;     ///< of its echoes; NaN without any
  double range_median_m = unknown;  ///< the lower middle one
  double range_max_m = unknown;
};

/// A log in numbers.
struct LogStatistics {
  double begin_s = SensorStatistics::unknown;  ///< first and last finite time of pings, odometry and scans
  double end_s = SensorStatistics::unknown;
  double path_m = 0.0;                     ///< length of the way through all usable odometry
  std::vector<SensorStatistics> sensors;   ///< in order of id, one per described sensor
  std::uint64_t unknown_sensor_pings = 0;  ///< of sensors that nobody described

  [[nodiscard]] double duration_s() const { return end_s - begin_s; }
};

/// `no_echo` as `decide_no_echo` gives it for the log's robot.
[[nodiscard]] LogStatistics log_statistics(const Log& log, std::span<const NoEchoDecision> no_echo);

}  // namespace echoarc
