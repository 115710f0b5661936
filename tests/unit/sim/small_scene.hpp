// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <utility>
#include <vector>

#include "echoarc/sim/simulate.hpp"

namespace echoarc::sim {

/// Four walls around [0, width] x [0, height].
inline WorldDescription box_world(double width_m, double height_m) {
  WorldDescription world;
  const Vec2 corners[] = {{0.0, 0.0}, {width_m, 0.0}, {width_m, height_m}, {0.0, height_m}};
  for (std::size_t k = 0; k < 4; ++k) world.walls.push_back({.a = corners[k], .b = corners[(k + 1) % 4]});
  return world;
}

/// Nothing random, nothing rounded.
inline SonarOptions exact_sonar() {
  return {.range_noise_share = 0.0, .dropout_share = 0.0, .outlier_share = 0.0, .floor_share = 0.0};
}

/// A ring of `sensors` in a room of 4 x 3 m, at rest in (1.5, 1.2), looking along +x.
inline Scene room_scene(int sensors, const SonarOptions& sonar = exact_sonar()) {
  Scene scene;
  scene.name = "room";
  scene.world = box_world(4.0, 3.0);
  scene.robot.radius_m = 0.2;
  scene.robot.sensors = SensorArray::make(ring(sensors, 0.15, Angle{}, SensorModel{})).value();
  scene.drive.start = {{1.5, 1.2}, Angle{}};
  scene.sonar = sonar;
  return scene;
}

/// The same, driving along +x, y = 1.2, from x = 1 to 3.
inline Scene driving_scene(int sensors, const SonarOptions& sonar = exact_sonar()) {
  Scene scene = room_scene(sensors, sonar);
  scene.drive.start = {{1.0, 1.2}, Angle{}};
  scene.drive.legs = {{.to = Vec2{3.0, 1.2}}};
  return scene;
}

}  // namespace echoarc::sim
