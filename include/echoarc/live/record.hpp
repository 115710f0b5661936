// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <variant>

#include "echoarc/core/log.hpp"
#include "echoarc/sim/simulated_robot.hpp"

namespace echoarc::live {

/// The true pose of a simulated robot.
struct Truth {
  Odometry pose;
};

/// What the robot was told to do, as the session log keeps it.
struct CommandNote {
  double time_s = 0.0;
  std::string mode;  ///< "drive", "stand", "tour", "goto", "stop"
  RobotVelocity wanted;
};

/// Whatever a running robot says, in the order in which it says it.
using Record = std::variant<Odometry, Truth, Ping, Scan, Poll, WallNote, CommandNote>;

}  // namespace echoarc::live
