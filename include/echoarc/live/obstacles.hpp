// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>

#include "echoarc/core/pose2.hpp"
#include "echoarc/core/robot_motion.hpp"

namespace echoarc::live {

/// What may stand in the way of a robot.
class Obstacles {
 public:
  virtual ~Obstacles() = default;
  /// The free way of a disc from its rim along the arc it drives on, m; none: nothing stands in it as far as is known.
  /// With more than one of `least_hits`, what only a single echo tells of does not count: it may be noise.
  [[nodiscard]] virtual std::optional<double> free_along(const Pose2& T_world_base, const RobotVelocity& velocity,
                                                         double hull_radius_m, int least_hits = 1) const = 0;
};

}  // namespace echoarc::live
