// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

#include "echoarc/core/log.hpp"
#include "echoarc/sensing/poll_stamper.hpp"

namespace echoarc {

/// How far a sensor's pose may be off when its ping is stamped with the middle of an interval.
struct StampBound {
  double position_m = 0.0;
  Angle turn;
};

/// position <= v w + lever omega w, turn <= omega w, with w half the interval and v, omega the largest speeds of the
/// odometry in it ([Silver04] App. A). `lever_m`: the sensor's distance from the robot's centre. Samples in the order
/// of time.
[[nodiscard]] StampBound stamp_bound(std::span<const Odometry> samples, const TimeInterval& fired, double lever_m);

}  // namespace echoarc
