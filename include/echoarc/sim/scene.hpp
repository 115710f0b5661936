// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/options.hpp"
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

  /// The part of the table `[drive]` that is options; `start` and `legs` are read apart.
  static constexpr auto fields() {
    return std::tuple{
        field("facing_deg", &Drive::facing,
              {.unit = "deg",
               .min = -360.0,
               .max = 360.0,
               .doc = "of the robot's x axis against the direction of travel: a turret turned aside"}),
        field("keep_heading", &Drive::keep_heading,
              {.doc = "the heading of the start stays, whatever the direction of travel"}),
        field("stop_step_m", &Drive::stop_step_m,
              {.unit = "m",
               .min = 0.0,
               .max = 1000.0,
               .doc = "distance between stops on straight legs, where every sensor fires once; 0: no stops",
               .source = "[Barshan07] 4"}),
        field("stop_turn_deg", &Drive::stop_turn,
              {.unit = "deg",
               .min = 0.0,
               .max = 360.0,
               .doc = "angle between stops on turns; 0: no stops",
               .source = "[Barshan07] 4"}),
        field("speed_m_s", &Drive::speed_m_s, {.unit = "m/s", .min = 0.001, .max = 10.0, .doc = "on straight legs"}),
        field("acceleration_m_s2", &Drive::acceleration_m_s2,
              {.unit = "m/s^2", .min = 0.001, .max = 100.0, .doc = "of starts and halts"}),
        field("turn_rate_deg", &Drive::turn_rate_per_s,
              {.unit = "deg/s", .min = 0.1, .max = 3600.0, .doc = "of turns on the spot"}),
        field("turn_acceleration_deg", &Drive::turn_acceleration_per_s2,
              {.unit = "deg/s^2", .min = 0.1, .max = 36'000.0, .doc = "of turns on the spot"}),
        field("dwell_s", &Drive::dwell_s,
              {.unit = "s", .min = 0.0, .max = 86'400.0, .doc = "rest after the last leg, firing on"})};
  }
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

  static constexpr auto fields() {
    using O = OdometryOptions;
    return std::tuple{
        field("perfect", &O::perfect, {.doc = "the odometry says the truth; the rest of this table is idle"}),
        field("rate_hz", &O::rate_hz, {.unit = "Hz", .min = 0.1, .max = 1000.0, .doc = "records per second"}),
        field("step_bias_share", &O::step_bias_share,
              {.min = -0.5, .max = 0.5, .doc = "of every distance, always the same: a wheel of wrong size"}),
        field("step_noise_share", &O::step_noise_share,
              {.min = 0.0, .max = 0.5, .doc = "of every distance, standard deviation"}),
        field("turn_bias_share", &O::turn_bias_share,
              {.min = -0.5, .max = 0.5, .doc = "of every turn, always the same"}),
        field("turn_noise_share", &O::turn_noise_share,
              {.min = 0.0, .max = 0.5, .doc = "of every turn, standard deviation"}),
        field("heading_noise_deg", &O::heading_noise_per_sqrt_m,
              {.unit = "deg/sqrt(m)",
               .min = 0.0,
               .max = 90.0,
               .doc = "the heading wanders on straight lines: standard deviation after one metre"})};
  }
};

/// Beams of one of the robot's lasers (a lidar, or structured light).
struct LaserOptions {
  int laser = 0;  ///< id of the mount in the robot's description; its range limits apply
  Angle angle_min = degrees(-135.0);
  Angle angle_step = degrees(0.5);
  int beams = 541;
  double rate_hz = 5.0;  ///< with stops: one scan a stop
  double noise_m = 0.005;
  double noise_share = 0.005;

  static constexpr auto fields() {
    using O = LaserOptions;
    return std::tuple{
        field("laser", &O::laser, {.min = 0, .max = 1'000'000, .doc = "id of the laser in the robot's description"}),
        field("angle_min_deg", &O::angle_min,
              {.unit = "deg", .min = -360.0, .max = 360.0, .doc = "bearing of the first beam in the laser's frame"}),
        field("angle_step_deg", &O::angle_step,
              {.unit = "deg", .min = -360.0, .max = 360.0, .doc = "from beam to beam"}),
        field("beams", &O::beams, {.min = 1, .max = 100'000, .doc = "of one scan"}),
        field("rate_hz", &O::rate_hz,
              {.unit = "Hz", .min = 0.01, .max = 1000.0, .doc = "scans per second; with stops: one scan a stop"}),
        field("noise_m", &O::noise_m,
              {.unit = "m", .min = 0.0, .max = 1.0, .doc = "standard deviation of a range, the constant part"}),
        field("noise_share", &O::noise_share,
              {.min = 0.0, .max = 1.0, .doc = "of the range: the part that grows with it"})};
  }
};

/// Registers read at a fixed rate instead of stamped pings ([Silver04] App. A).
struct PollingOptions {
  bool polled = false;
  double rate_hz = 30.0;

  static constexpr auto fields() {
    return std::tuple{
        field(
            "polled", &PollingOptions::polled,
            {.doc = "the log holds registers read at a fixed rate, not stamped pings", .source = "[Silver04] App. A"}),
        field("rate_hz", &PollingOptions::rate_hz,
              {.unit = "Hz", .min = 0.1, .max = 1000.0, .doc = "of reading them", .source = "[Silver04] App. A"})};
  }
};

/// A world, a robot in it, how it goes, and how well its sensors are: everything `simulate` needs but a seed.
struct Scene {
  std::string name;
  std::string title;   ///< one line for people
  std::string source;  ///< the paper and section it follows, or empty
  std::string file;    ///< what it was read from, for messages; or empty
  WorldDescription world;
  RobotDescription robot;
  Drive drive;
  SonarOptions sonar;
  OdometryOptions odometry;
  std::vector<LaserOptions> lasers;
  PollingOptions polling;
};

}  // namespace echoarc::sim
