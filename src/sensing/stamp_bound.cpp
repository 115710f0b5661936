// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/stamp_bound.hpp"

#include <algorithm>

namespace echoarc {

StampBound stamp_bound(std::span<const Odometry> samples, const TimeInterval& fired, double lever_m) {
  double speed_m_s = 0.0;
  double turn_rad_s = 0.0;
  auto after = std::ranges::upper_bound(samples, fired.lo_s, {}, &Odometry::time_s);
  if (after == samples.begin() && after != samples.end()) ++after;
  for (; after != samples.end(); ++after) {
    const Odometry& from = *(after - 1);
    const Odometry& to = *after;
    if (from.time_s > fired.hi_s) break;
    const double lasted_s = to.time_s - from.time_s;
    speed_m_s = std::max(speed_m_s, norm(to.T_world_robot.position - from.T_world_robot.position) / lasted_s);
    const Angle turned = wrap(to.T_world_robot.heading - from.T_world_robot.heading);
    turn_rad_s = std::max(turn_rad_s, abs(turned).rad() / lasted_s);
  }
  const double w_s = fired.half_width_s();
  return {speed_m_s * w_s + lever_m * turn_rad_s * w_s, radians(turn_rad_s * w_s)};
}

}  // namespace echoarc
