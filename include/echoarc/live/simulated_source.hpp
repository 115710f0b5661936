// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/live/source.hpp"
#include "echoarc/sim/stepped_simulation.hpp"

namespace echoarc::live {

/// The simulated robot of a scene, driven by commands. The stations of its tour are those of the scene's drive.
class SimulatedSource final : public Source, public Drivable {
 public:
  /// Errors: those of `SteppedSimulation::make`.
  [[nodiscard]] static Result<std::unique_ptr<SimulatedSource>> make(sim::Scene scene, std::uint64_t seed,
                                                                     const sim::RobotLimits& limits = {});

  [[nodiscard]] const SourceDescription& description() const override { return description_; }
  [[nodiscard]] double time_s() const override { return simulation_.time_s(); }
  [[nodiscard]] Result<void> advance(double until_s, std::vector<Record>& records) override;
  [[nodiscard]] Drivable* drivable() override { return this; }

  void command(const MotorCommand& command) override;
  [[nodiscard]] Pose2 T_world_base() const override { return simulation_.T_odom_base(); }
  [[nodiscard]] sim::RobotVelocity velocity() const override { return simulation_.velocity(); }
  [[nodiscard]] sim::RobotLimits limits() const override { return limits_; }

  /// For what only a simulation knows: truth and the bumper.
  [[nodiscard]] const sim::SteppedSimulation& simulation() const { return simulation_; }

 private:
  SimulatedSource(sim::SteppedSimulation simulation, const sim::RobotLimits& limits);

  sim::SteppedSimulation simulation_;
  sim::RobotLimits limits_;
  SourceDescription description_;
  std::vector<sim::SteppedRecord> said_;
};

}  // namespace echoarc::live
