// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/sim/sonar_options.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// A piece of a scripted drive: straight to a point, or a turn on the spot by a relative angle.
struct DriveLeg {
  std::optional<Vec2> to;
  std::optional<Angle> turn;
  std::uint64_t line = 0;
};

/// How the robot goes through the scene.
///
/// With stops (`stop_step_m`, `stop_turn` > 0) it halts every so far and every sensor fires once before it goes on: the
/// experiments of [Barshan07]. Without, it drives on while the sensors fire one after another.
struct Drive {
  Pose2 start;  ///< T_world_robot at t = 0; its heading is the direction of travel
  std::vector<DriveLeg> legs;
  Angle facing;               ///< of the robot's x axis against the direction of travel (a turret turned aside)
  bool keep_heading = false;  ///< the heading of `start` stays, whatever the direction of travel
  double stop_step_m = 0.0;   ///< on straight legs; 0: no stops
  Angle stop_turn;            ///< on turns
  double speed_m_s = 0.3;
  double acceleration_m_s2 = 0.5;
  Angle turn_rate_per_s = degrees(45.0);
  Angle turn_acceleration_per_s2 = degrees(90.0);
  double dwell_s = 0.0;  ///< rest after the last leg, firing on
};

/// Drift of the wheels' odometry; the defaults are those of a small indoor robot.
struct OdometryOptions {
  bool perfect = true;
  double rate_hz = 20.0;
  double step_bias_share = 0.005;
  double step_noise_share = 0.01;
  double turn_bias_share = 0.01;
  double turn_noise_share = 0.02;
  Angle heading_noise_per_sqrt_m = degrees(0.5);
};

/// Beams of one of the robot's lasers (a lidar, or structured light).
struct LaserOptions {
  std::uint32_t laser = 0;  ///< id of the mount in the robot's description; its range limits apply
  Angle angle_min = degrees(-135.0);
  Angle angle_step = degrees(0.5);
  int beams = 541;
  double rate_hz = 5.0;  ///< with stops: one scan a stop
  double noise_m = 0.005;
  double noise_share = 0.005;
};

/// Registers read at a fixed rate instead of stamped pings ([Silver04] App. A).
struct PollingOptions {
  bool polled = false;
  double rate_hz = 30.0;
};

/// A world, a robot in it, how it goes, and how well its sensors are: everything `simulate` needs but a seed.
struct Scene {
  std::string name;
  std::string title;   ///< one line for people
  std::string source;  ///< the paper and section it follows, or empty
  WorldDescription world;
  RobotDescription robot;
  Drive drive;
  SonarOptions sonar;
  OdometryOptions odometry;
  std::vector<LaserOptions> lasers;
  PollingOptions polling;
};

}  // namespace echoarc::sim
