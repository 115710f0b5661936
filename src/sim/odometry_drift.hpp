// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/core/pose2.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::sim {

/// What wheels measure of a drive: step by step, each too long or short, turned too far or little. Starts at the true
/// pose.
class OdometryDrift {
 public:
  OdometryDrift(const OdometryOptions& options, std::uint64_t seed, const Pose2& T_world_start);

  /// The measured pose after the robot has moved from where it was at the last call to here.
  Pose2 advance(const Pose2& T_world_robot);

 private:
  OdometryOptions options_;
  std::uint64_t seed_;
  std::uint64_t step_ = 0;
  Pose2 T_world_before_;  // true
  Pose2 T_odom_robot_;    // measured
};

}  // namespace echoarc::sim
