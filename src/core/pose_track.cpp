// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc {

PoseTrack::PoseTrack(std::span<const Odometry> odometry) {
  records_.reserve(odometry.size());
  for (const Odometry& record : odometry) {
    if (!std::isfinite(record.time_s) || !is_finite(record.T_world_robot))
      ++not_finite_;
    else if (!records_.empty() && record.time_s <= records_.back().time_s)
      ++out_of_order_;
    else
      records_.push_back(record);
  }
}

std::optional<Pose2> PoseTrack::T_world_robot(double time_s, double max_gap_s) const {
  const auto after = std::lower_bound(records_.begin(), records_.end(), time_s,
                                      [](const Odometry& record, double t) { return record.time_s < t; });
  if (after == records_.end()) return std::nullopt;  // a NaN finds the first record
  if (after->time_s == time_s) return after->T_world_robot;
  if (after == records_.begin()) return std::nullopt;
  const auto before = after - 1;
  const double gap_s = after->time_s - before->time_s;
  if (gap_s > max_gap_s) return std::nullopt;
  return interpolate(before->T_world_robot, after->T_world_robot, (time_s - before->time_s) / gap_s);
}

}  // namespace echoarc
