// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "echoarc/io/scene_toml.hpp"

/// Whatever is read must be a world that the simulator takes, with a robot that has sensors and options in range.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = echoarc::io::read_scene({reinterpret_cast<const char*>(data), size}, "scene.toml");
  if (!file) return 0;
  const echoarc::sim::Scene& scene = file->scene;
  const bool sound = echoarc::sim::World::make(scene.world) && !scene.robot.sensors.empty() &&
                     echoarc::validate(scene.sonar) && echoarc::validate(scene.drive) &&
                     echoarc::validate(scene.odometry);
  if (!sound) std::abort();
  return 0;
}
