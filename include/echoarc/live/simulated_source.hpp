// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/live/source.hpp"
#include "echoarc/sim/stepped_simulation.hpp"

namespace echoarc::live {

/// The simulated robot of a scene, driven by commands. The stations of its tour are those of the scene's drive.
/// Where an earlier run of the same robot ended, which this one continues: its records follow those of that run.
struct Continuation {
  double time_s = 0.0;  ///< of the first record
  Pose2 T_world_true;
  Pose2 T_world_odometry;  ///< where the robot believed to be there
};

class SimulatedSource final : public Source, public Drivable {
 public:
  /// Errors: those of `SteppedSimulation::make`. What moves in the scene starts anew with a continuation.
  [[nodiscard]] static Result<std::unique_ptr<SimulatedSource>> make(
      sim::Scene scene, std::uint64_t seed, const RobotLimits& limits = {},
      const std::optional<Continuation>& continued = std::nullopt);

  [[nodiscard]] const SourceDescription& description() const override { return description_; }
  [[nodiscard]] double time_s() const override { return begin_s_ + simulation_.time_s(); }
  [[nodiscard]] Result<void> advance(double until_s, std::vector<Record>& records) override;
  [[nodiscard]] Drivable* drivable() override { return this; }

  void command(const MotorCommand& command) override;
  [[nodiscard]] Pose2 T_world_base() const override { return T_odometry_simulated_ * simulation_.T_odom_base(); }
  [[nodiscard]] RobotVelocity velocity() const override { return simulation_.velocity(); }
  [[nodiscard]] RobotLimits limits() const override { return limits_; }

  /// For what only a simulation knows: truth and the bumper.
  [[nodiscard]] const sim::SteppedSimulation& simulation() const { return simulation_; }

 private:
  SimulatedSource(sim::SteppedSimulation simulation, const RobotLimits& limits);
  void shift(Record& record) const;

  sim::SteppedSimulation simulation_;
  double begin_s_ = 0.0;        // of the simulation's own time
  Pose2 T_odometry_simulated_;  // from the frame of the simulation's odometry to that of the run it continues
  RobotLimits limits_;
  SourceDescription description_;
  std::vector<sim::SteppedRecord> said_;
};

}  // namespace echoarc::live
