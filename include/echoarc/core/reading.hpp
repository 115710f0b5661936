// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/core/log.hpp"
#include "echoarc/core/outcome.hpp"

namespace echoarc {

using PingId = std::uint64_t;  ///< index of the ping in its log, counted from 0

/// One ping with everything a mapping method may know of it. All poses are at the firing time.
struct Reading {
  PingId ping = 0;
  double time_s = 0.0;
  std::uint32_t scan = 0;  ///< readings of one sweep of the array share it
  SensorId tx = 0;
  SensorId rx = 0;
  Pose2 T_world_robot;
  Pose2 T_world_tx;                  ///< transmitter; its x axis is the acoustic axis
  Pose2 T_world_rx;                  ///< receiver; the same as the transmitter for a monostatic reading
  Angle beam_width = degrees(25.0);  ///< full angle
  double range_min_m = 0.15;
  double range_max_m = 10.7;
  double trusted_range_m = 3.0;  ///< to this range silence counts as free space
  Outcome outcome;
  bool laser_limited = false;         ///< the range was shortened to a laser return
  WallSide wall = WallSide::unknown;  ///< the wall being followed, if known

  [[nodiscard]] bool monostatic() const { return tx == rx; }
};

}  // namespace echoarc
