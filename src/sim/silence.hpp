// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>

#include "echoarc/core/sensor_array.hpp"

namespace echoarc::sim {

/// What a sensor reports when it heard nothing, in its own spelling; +Inf where it has none.
[[nodiscard]] inline double silence_m(const SensorModel& model) {
  switch (model.no_echo.kind) {
    case NoEchoRule::Kind::automatic:
    case NoEchoRule::Kind::inf: break;
    case NoEchoRule::Kind::nan: return std::numeric_limits<double>::quiet_NaN();
    case NoEchoRule::Kind::zero: return 0.0;
    case NoEchoRule::Kind::max: return model.range_max_m;
    case NoEchoRule::Kind::above: return model.no_echo.above_m;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace echoarc::sim
