// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/robot_motion.hpp"

namespace echoarc::nav {

/// The fastest from which a robot comes to rest before an obstacle: v = sqrt(2 a max(0, d_free - d_stop)), m/s.
/// `free_m`: the free way along its motion arc from the hull; `stop_distance_m`: what shall remain of it;
/// `deceleration_m_s2` > 0. A free way that is no number allows none.
[[nodiscard]] double speed_cap_m_s(double free_m, double stop_distance_m, double deceleration_m_s2);

/// The way from `speed_m_s` to rest at a constant deceleration: v^2 / (2 a), m.
[[nodiscard]] double stopping_distance_m(double speed_m_s, double deceleration_m_s2);

/// One step of acceleration control: from velocity `now` towards `wanted` as far as the motors go within `step_s` >= 0,
/// each of speed and turning rate on the ramps of a trapezoid, between the limits. What is no number counts as a wish
/// to stand; from a velocity that is no number the ramps begin at rest.
[[nodiscard]] RobotVelocity accelerated(const RobotVelocity& now, const RobotVelocity& wanted,
                                        const RobotLimits& limits, double step_s);

}  // namespace echoarc::nav
