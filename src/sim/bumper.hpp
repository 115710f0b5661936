// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/sim/simulated_robot.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// What keeps a driven robot out of walls and of whoever moves about.
class Bumper {
 public:
  /// `world` must outlive it.
  Bumper(const World& world, double hull_radius_m) : world_(&world), hull_radius_m_(hull_radius_m) {}

  /// Holds the robot at `before_m`, where it was, if it has come to touch something or has got closer to what it
  /// touches. Nothing pushes it.
  void check(SimulatedRobot& robot, Vec2 before_m, double time_s);

  [[nodiscard]] bool touching() const { return touching_; }
  [[nodiscard]] std::uint64_t contacts() const { return contacts_; }

 private:
  [[nodiscard]] double clearance(Vec2 place, double time_s);

  const World* world_;
  double hull_radius_m_;
  // What stands still is looked for again only when the robot may have come near it.
  Vec2 looked_at_;
  double looked_free_m_ = -1.0;
  bool touching_ = false;
  std::uint64_t contacts_ = 0;
};

}  // namespace echoarc::sim
