// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/sim/scene.hpp"
#include "echoarc/sim/simulated_robot.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// Where a simulated robot truly is.
struct TruePose {
  Odometry pose;
};

/// What a robot that is simulated step by step says.
using SteppedRecord = std::variant<Odometry, TruePose, Ping, Scan, Poll>;

/// The robot of a scene, driven by commands instead of the scene's script. Time goes on in ticks of 5 ms, on which
/// commands take effect; sensors fire one after another all the time. The same commands at the same times give the same
/// records, byte for byte, however `advance` is sliced; a robot at rest says what `simulate` records of it.
///
/// It does not drive through what stands there: at contact it is held, as by a bumper, until it is told to go another
/// way. Old firings are forgotten, so that it may run for days.
class SteppedSimulation {
 public:
  /// Errors: those of `simulate` but for the scripted drive, of which the start alone is looked at.
  [[nodiscard]] static Result<SteppedSimulation> make(Scene scene, std::uint64_t seed, const RobotLimits& limits = {});
  SteppedSimulation(SteppedSimulation&&) noexcept;
  SteppedSimulation& operator=(SteppedSimulation&&) noexcept;
  ~SteppedSimulation();

  /// Holds from the next tick until another one does; see `SimulatedRobot::command`.
  void command(const RobotVelocity& wanted, std::optional<double> deceleration_m_s2 = {});
  /// Goes on to `until_s` and appends what is said on the way, in the order of time. Earlier times and what is no
  /// number are ignored.
  void advance(double until_s, std::vector<SteppedRecord>& records);

  [[nodiscard]] double time_s() const;
  /// Truth. The base's x axis is the direction of travel; a turret may look elsewhere (`Drive::facing`,
  /// `Drive::keep_heading`).
  [[nodiscard]] Pose2 T_world_base() const;
  [[nodiscard]] Pose2 T_world_robot() const;
  /// The base where odometry believes it to be.
  [[nodiscard]] Pose2 T_odom_base() const;
  [[nodiscard]] RobotVelocity velocity() const;
  [[nodiscard]] double travelled_m() const;

  [[nodiscard]] bool touching() const;           ///< held by the bumper
  [[nodiscard]] std::uint64_t contacts() const;  ///< how often it came to be held

  [[nodiscard]] const Scene& scene() const;
  [[nodiscard]] std::shared_ptr<const World> world() const;

 private:
  struct State;
  explicit SteppedSimulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace echoarc::sim
