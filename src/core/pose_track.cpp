// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {

std::optional<PoseTrack::Refusal> PoseTrack::push(const Odometry& sample) {
  if (!std::isfinite(sample.time_s)) return Refusal::bad_time;
  const Pose2& pose = sample.T_world_robot;
  const bool in_reach = std::abs(pose.position.x) <= farthest_m && std::abs(pose.position.y) <= farthest_m;
  if (!in_reach || !is_finite(pose.heading)) return Refusal::bad_pose;  // NaN is not in reach
  if (!samples_.empty()) {
    if (sample.time_s < newest_s()) return Refusal::backwards;
    if (sample.time_s == newest_s()) return Refusal::duplicate;
    if (sample.time_s - newest_s() > max_jump_s_) return Refusal::bad_time;
  }
  samples_.push_back(sample);
  return std::nullopt;
}

std::variant<Pose2, PoseTrack::Missing> PoseTrack::at(double time_s) const {
  const auto after = std::ranges::lower_bound(samples_, time_s, {}, &Odometry::time_s);
  if (after == samples_.end()) return Missing::outside;
  if (after->time_s == time_s) return after->T_world_robot;
  if (after == samples_.begin()) return Missing::outside;
  const auto before = after - 1;
  const double gap_s = after->time_s - before->time_s;
  if (gap_s > max_gap_s_) return Missing::gap;
  return interpolate(before->T_world_robot, after->T_world_robot, (time_s - before->time_s) / gap_s);
}

}  // namespace echoarc
