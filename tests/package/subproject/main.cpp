// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdio>

#include <echoarc/core/sensor_array.hpp>

int main() {
  const auto sonars = echoarc::array_preset("nomad200");
  if (!sonars) return 1;
  std::printf("%zu sonars\n", sonars->sensors().size());
  return 0;
}
