// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "echoarc/io/robot_toml.hpp"

/// Whatever is read must have passed every check of a robot.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto robot = echoarc::io::parse_robot_toml({reinterpret_cast<const char*>(data), size}, "robot.toml");
  if (!robot) return 0;
  const auto sensors = robot->sensors.sensors();
  if (sensors.empty() || !echoarc::SensorArray::make({sensors.begin(), sensors.end()})) std::abort();
  return 0;
}
