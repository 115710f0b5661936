// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/studies/experiment.hpp"

namespace echoarc::studies::test {

/// A wall at y = 1 from x = -0.5 to 0.5, with a wall at y = 1.4 behind it, past which three sonars drive along y = 0.
inline StudyScene wall_scene() {
  StudyScene scene;
  scene.scene.name = "wall";
  scene.scene.world.walls = {{{-0.5, 1.0}, {0.5, 1.0}}, {{-0.4, 1.4}, {0.4, 1.4}}};
  scene.scene.robot.sensors = array_preset("nomad200_front3").value();
  scene.scene.drive.start = {{-0.3, 0.0}, degrees(0.0)};
  scene.scene.drive.facing = degrees(90.0);
  scene.scene.drive.legs = {{.to = Vec2{0.3, 0.0}, .turn = {}, .line = 0}};
  scene.scene.drive.stop_step_m = 0.05;
  scene.scene.sonar.listening = sim::Listening::all;
  scene.scoring.region = {{-0.755, 0.0}, {0.755, 2.0}};
  scene.scoring.axis = degrees(90.0);
  return scene;
}

}  // namespace echoarc::studies::test
