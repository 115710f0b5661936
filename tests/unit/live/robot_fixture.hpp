// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/io/builtin.hpp"
#include "echoarc/io/scene_toml.hpp"
#include "echoarc/live/live_robot.hpp"
#include "echoarc/live/simulated_source.hpp"

namespace echoarc::live {

inline sim::Scene scene_named(std::string_view name) {
  const auto text = io::builtin_scene(name);
  return io::read_scene(text.value_or(""), name).value().scene;
}

/// A room of 6 x 4 m and a round robot of 0.2 m radius in (1, 2) that looks along +x, its ring of 16 without errors.
inline sim::Scene plain_room() {
  sim::Scene scene;
  scene.name = "room";
  const Vec2 corners[] = {{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}};
  for (std::size_t k = 0; k < 4; ++k) scene.world.walls.push_back({.a = corners[k], .b = corners[(k + 1) % 4]});
  scene.robot.radius_m = 0.2;
  scene.robot.sensors = SensorArray::make(ring(16, 0.15, Angle{}, SensorModel{})).value();
  scene.drive.start = {{1.0, 2.0}, Angle{}};
  scene.sonar.range_noise_share = scene.sonar.dropout_share = scene.sonar.outlier_share = 0.0;
  scene.sonar.floor_share = 0.0;
  return scene;
}

/// A live robot of a scene whose host's clock runs with the simulation's.
class Driven {
 public:
  explicit Driven(sim::Scene scene, std::uint64_t seed = 1)
      : Driven(SimulatedSource::make(std::move(scene), seed).value()) {}

  /// Goes on in steps of 20 ms, and tells before each what `before_step` makes of it.
  template <class BeforeStep>
  void run(double duration_s, const BeforeStep& before_step) {
    constexpr double step_s = 0.02;
    for (int k = static_cast<int>(duration_s / step_s + 0.5); k > 0; --k) {
      before_step();
      host_s_ += step_s;
      ASSERT_TRUE(robot.step(host_s_, host_s_, records));
    }
  }
  void run(double duration_s) {
    run(duration_s, [] {});
  }
  /// Drives as someone does who holds a key.
  void drive(double duration_s, double forward_m_s, Angle turn_per_s) {
    run(duration_s, [&] { control().drive({forward_m_s, turn_per_s}, host_s_); });
  }

  [[nodiscard]] RobotControl& control() { return *robot.control(); }
  [[nodiscard]] const sim::SteppedSimulation& simulation() const { return source_->simulation(); }
  [[nodiscard]] Vec2 place() const { return simulation().T_world_base().position; }
  [[nodiscard]] double speed_m_s() const { return simulation().velocity().forward_m_s; }
  [[nodiscard]] double host_s() const { return host_s_; }

 private:
  explicit Driven(std::unique_ptr<SimulatedSource> source) : source_(source.get()), robot(std::move(source)) {}

  const SimulatedSource* source_;
  double host_s_ = 0.0;

 public:
  LiveRobot robot;
  std::vector<Record> records;
};

}  // namespace echoarc::live
