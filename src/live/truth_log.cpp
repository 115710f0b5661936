// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/truth_log.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace echoarc::live {

void TruthLog::push(const Odometry& pose) {
  if (!std::isfinite(pose.time_s) || !is_finite(pose.T_world_robot.position) || !is_finite(pose.T_world_robot.heading))
    return;
  if (poses_.size() == 0 || pose.time_s > poses_[poses_.size() - 1].time_s) poses_.append(pose);
}

std::optional<Pose2> TruthLog::at(double time_s) const {
  const auto places = std::views::iota(std::size_t{0}, poses_.size());
  const auto after = std::ranges::lower_bound(places, time_s, {}, [&](std::size_t k) { return poses_[k].time_s; });
  if (after == places.end()) return std::nullopt;
  const Odometry& late = poses_[*after];
  if (late.time_s == time_s) return late.T_world_robot;
  if (*after == 0 || !(time_s > poses_[*after - 1].time_s)) return std::nullopt;
  const Odometry& early = poses_[*after - 1];
  return interpolate(early.T_world_robot, late.T_world_robot, (time_s - early.time_s) / (late.time_s - early.time_s));
}

}  // namespace echoarc::live
