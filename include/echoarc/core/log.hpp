// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "echoarc/core/echo_cause.hpp"
#include "echoarc/core/sensor_array.hpp"

namespace echoarc {

/// The side of the robot on which it follows a wall.
enum class WallSide : std::uint8_t { unknown, left, right };

struct LaserMount {
  std::uint32_t id = 0;
  Mount mount;
  double range_min_m = 0.0;
  double range_max_m = 8.0;
  friend bool operator==(const LaserMount&, const LaserMount&) = default;
};

struct RobotDescription {
  std::string name = "robot";
  double radius_m = 0.25;
  SensorArray sensors;
  std::vector<LaserMount> lasers;
  friend bool operator==(const RobotDescription&, const RobotDescription&) = default;
};

// `line` is the line of the source file a record came from, counted from 1; 0 where there is none.

struct Odometry {
  double time_s = 0.0;
  Pose2 T_world_robot;
  std::uint64_t line = 0;
  friend bool operator==(const Odometry&, const Odometry&) = default;
};

/// One transmission as one receiver reported it, before any interpretation. `range_m` is what the hardware said, in
/// metres, special values included; a log that states an outcome in words is held in REP 117 form (+Inf, -Inf, NaN).
struct Ping {
  double time_s = 0.0;
  SensorId tx = 0;
  SensorId rx = 0;
  double range_m = 0.0;
  double time_of_flight_s = std::numeric_limits<double>::quiet_NaN();
  std::uint32_t echo_index = 0;          ///< 0: the first echo this receiver heard of the transmission
  EchoCause cause = EchoCause::unknown;  ///< simulation only
  std::uint64_t line = 0;
};

struct Scan {
  double time_s = 0.0;
  std::uint32_t laser = 0;
  Angle angle_min;
  Angle angle_step;
  std::vector<float> ranges_m;  ///< NaN: no return
  std::uint64_t line = 0;
};

/// Raw range registers of hardware that does not stamp its pings.
struct Poll {
  double time_s = 0.0;
  std::vector<double> ranges_m;
  std::uint64_t line = 0;
};

struct WallNote {
  double time_s = 0.0;
  WallSide side = WallSide::unknown;
  std::uint64_t line = 0;
};

struct BadLine {
  std::uint64_t line = 0;
  std::string message;
};

/// What reading a file met on the way.
struct ReadReport {
  std::uint64_t lines = 0;
  std::uint64_t bad_lines = 0;
  std::vector<BadLine> first_bad;     ///< at most 10
  std::vector<std::string> warnings;  ///< a truncated last line, an unknown record type, ...
};

/// A drive: robot description, then odometry, pings and the rest, each in the order of the file.
struct Log {
  std::string source;  ///< where it came from, for messages
  std::string frame = "odom";
  double temperature_k = 293.0;
  RobotDescription robot;
  std::vector<Odometry> odometry;
  std::vector<Ping> pings;
  std::vector<Scan> scans;
  std::vector<Poll> polls;
  std::vector<Odometry> truth;  ///< simulation only
  std::vector<WallNote> walls;
  std::vector<std::string> unknown_lines;  ///< records of types this version does not know; `convert` keeps them
  ReadReport report;
};

}  // namespace echoarc
