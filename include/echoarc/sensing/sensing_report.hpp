// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "echoarc/core/reading.hpp"
#include "echoarc/sensing/no_echo.hpp"
#include "echoarc/sensing/poll_stamper.hpp"
#include "echoarc/sensing/rejection.hpp"

namespace echoarc {

/// What one receiver gave.
struct SensorTally {
  SensorId sensor = 0;
  std::uint64_t echoes = 0;
  std::uint64_t no_echoes = 0;
  std::uint64_t too_close = 0;
  std::array<std::uint64_t, rejection_count> rejected{};  ///< by reason, in the order of the enum

  [[nodiscard]] std::uint64_t accepted() const { return echoes + no_echoes + too_close; }
  friend bool operator==(const SensorTally&, const SensorTally&) = default;
};

/// Where every record went. At any time: pings == accepted() + rejected_pings.total() + waiting.
struct SensingReport {
  std::uint64_t pings = 0;     ///< offered
  std::uint64_t odometry = 0;  ///< offered
  std::uint64_t walls = 0;     ///< offered
  std::uint64_t waiting = 0;   ///< pings that odometry does not reach yet
  std::uint64_t echoes = 0;
  std::uint64_t no_echoes = 0;
  std::uint64_t too_close = 0;
  std::uint64_t scans = 0;          ///< laser scans offered
  std::uint64_t laser_limited = 0;  ///< readings that a laser shortened
  PollStamper::Counters polls;      ///< of polled registers; the pings made from them are counted as pings
  RejectionCounters rejected_pings;
  RejectionCounters rejected_odometry;
  RejectionCounters rejected_walls;
  RejectionCounters rejected_scans;
  std::vector<SensorTally> sensors;     ///< in order of id; pings of unknown sensors are in none of them
  std::vector<NoEchoDecision> no_echo;  ///< in order of id

  [[nodiscard]] std::uint64_t accepted() const { return echoes + no_echoes + too_close; }
};

}  // namespace echoarc
