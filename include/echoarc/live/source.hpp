// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/eval/reference.hpp"
#include "echoarc/live/record.hpp"
#include "echoarc/sensing/no_echo.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::live {

/// What a source is before it says anything.
struct SourceDescription {
  std::string name;
  std::string title;  ///< one line for people
  std::string frame = "odom";
  double temperature_k = 293.0;
  RobotDescription robot;
  std::vector<NoEchoDecision> no_echo;      ///< one per sensor, from a whole log; empty: by the robot's description
  std::vector<Polyline> walls;              ///< true surfaces that stand still, world; empty: unknown
  std::shared_ptr<const sim::World> world;  ///< of a simulation, to tell which of them can be seen; null: unknown
  bool has_truth = false;
  std::vector<Vec2> tour;  ///< stations of the scripted drive, the start first; empty: none
  double begin_s = 0.0;
  std::optional<double> end_s;  ///< of a log
};

/// Speeds for the motors and how hard they may change.
struct MotorCommand {
  RobotVelocity wanted;
  double deceleration_m_s2 = 0.3;  ///< used while the robot brakes; speeding up keeps to the robot's own limit
};

/// A robot that can be driven. Poses are of the base, whose x axis is the direction of travel, in the odometry's frame.
class Drivable {
 public:
  virtual ~Drivable() = default;
  virtual void command(const MotorCommand& command) = 0;
  [[nodiscard]] virtual Pose2 T_world_base() const = 0;
  [[nodiscard]] virtual RobotVelocity velocity() const = 0;
  [[nodiscard]] virtual RobotLimits limits() const = 0;
};

/// Something that can be heard again from any moment.
class Seekable {
 public:
  virtual ~Seekable() = default;
  /// The next record is the first one later than `time_s`.
  virtual void seek(double time_s) = 0;
};

/// Where records come from: a simulated robot, a log that is played, later a serial line or a bridge. Its time is that
/// of its records; it reads no clock, the host says how far to go.
class Source {
 public:
  virtual ~Source() = default;
  [[nodiscard]] virtual const SourceDescription& description() const = 0;
  [[nodiscard]] virtual double time_s() const = 0;
  /// Appends what happens until `until_s`, in the order of time. Error: the source is broken and says no more.
  [[nodiscard]] virtual Result<void> advance(double until_s, std::vector<Record>& records) = 0;
  /// Whether nothing follows.
  [[nodiscard]] virtual bool ended() const { return false; }
  [[nodiscard]] virtual Drivable* drivable() { return nullptr; }
  [[nodiscard]] virtual Seekable* seekable() { return nullptr; }
};

}  // namespace echoarc::live
