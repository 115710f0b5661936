// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {

std::optional<Rejection> PoseTrack::push(const Odometry& sample) {
  if (!std::isfinite(sample.time_s)) return Rejection::bad_time;
  const Pose2& pose = sample.T_world_robot;
  const bool in_reach = std::abs(pose.position.x) <= farthest_m && std::abs(pose.position.y) <= farthest_m;
  if (!in_reach || !is_finite(pose.heading)) return Rejection::bad_pose;  // NaN is not in reach
  if (!samples_.empty()) {
    if (sample.time_s < newest_s()) return Rejection::time_backwards;
    if (sample.time_s == newest_s()) return Rejection::duplicate;
    if (sample.time_s - newest_s() > max_jump_s_) return Rejection::bad_time;
  }
  samples_.push_back(sample);
  return std::nullopt;
}

std::variant<Pose2, Rejection> PoseTrack::at(double time_s) const {
  const auto after = std::ranges::lower_bound(samples_, time_s, {}, &Odometry::time_s);
  if (after == samples_.end()) return Rejection::no_pose;
  if (after->time_s == time_s) return after->T_world_robot;
  if (after == samples_.begin()) return Rejection::no_pose;
  const auto before = after - 1;
  const double gap_s = after->time_s - before->time_s;
  if (gap_s > max_gap_s_) return Rejection::pose_gap;
  return interpolate(before->T_world_robot, after->T_world_robot, (time_s - before->time_s) / gap_s);
}

}  // namespace echoarc
