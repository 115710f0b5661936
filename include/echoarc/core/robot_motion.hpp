// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <tuple>

#include "echoarc/core/angle.hpp"
#include "echoarc/core/options.hpp"

namespace echoarc {

/// Forward speed and turning rate, of a command or of the robot itself.
struct RobotVelocity {
  double forward_m_s = 0.0;
  Angle turn_per_s;
  friend constexpr bool operator==(const RobotVelocity&, const RobotVelocity&) = default;
};

/// What a robot's motors can do.
struct RobotLimits {
  double speed_m_s = 0.6;
  Angle turn_rate_per_s = degrees(60.0);
  double acceleration_m_s2 = 0.3;
  Angle turn_acceleration_per_s2 = degrees(90.0);

  static constexpr auto fields() {
    using L = RobotLimits;
    return std::tuple{
        field("speed_m_s", &L::speed_m_s,
              {.unit = "m/s", .min = 1e-3, .max = 10.0, .doc = "forwards and backwards", .source = "[Barshan07] 4.1"}),
        field("turn_rate_deg", &L::turn_rate_per_s,
              {.unit = "deg/s", .min = 0.1, .max = 3600.0, .doc = "to either side", .source = "[Barshan07] 4.1"}),
        field("acceleration_m_s2", &L::acceleration_m_s2,
              {.unit = "m/s^2", .min = 1e-3, .max = 100.0, .doc = "of speeding up and of braking"}),
        field("turn_acceleration_deg", &L::turn_acceleration_per_s2,
              {.unit = "deg/s^2", .min = 0.1, .max = 36'000.0, .doc = "of the turning rate"})};
  }
};

}  // namespace echoarc
