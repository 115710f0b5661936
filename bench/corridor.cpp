// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/corridor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "echoarc/core/range_quantum.hpp"
#include "echoarc/core/rng.hpp"

namespace echoarc::bench {
namespace {

constexpr double half_corridor_m = 1.0;
constexpr double recess_depth_m = 0.3;
constexpr double recess_period_m = 3.0;
constexpr double recess_m = 0.9;
constexpr double echoes_per_m = 90.0;
constexpr double range_max_m = 3.8;
constexpr double range_step_m = 0.01;
constexpr Angle beam = degrees(20.0);

struct SonarMount {
  double x_m, y_m, yaw_deg;
};
constexpr std::array<SonarMount, 8> mounts{{{0.100, -0.200, -90.0},
                                            {0.125, -0.100, -37.5},
                                            {0.150, -0.050, -22.5},
                                            {0.150, -0.025, -7.5},
                                            {0.150, 0.025, 7.5},
                                            {0.150, 0.050, 22.5},
                                            {0.125, 0.100, 37.5},
                                            {0.100, 0.200, 90.0}}};

/// Whether a point lies in the wall. The recesses of the right side lie between those of the left.
bool in_wall(Vec2 p) {
  const double along_m = p.y > 0.0 ? p.x : p.x + 0.5 * recess_period_m;
  const bool recess = along_m - recess_period_m * std::floor(along_m / recess_period_m) < recess_m;
  return std::abs(p.y) > half_corridor_m + (recess ? recess_depth_m : 0.0);
}

/// The nearest wall that some ray of the beam meets.
std::optional<double> nearest_wall_m(const Pose2& sensor) {
  constexpr int rays = 9;
  constexpr double step_m = 0.01;
  for (double r = step_m; r < range_max_m; r += step_m)
    for (int k = 0; k < rays; ++k)
      if (in_wall(sensor.position + r * unit(sensor.heading + (double(k) / (rays - 1) - 0.5) * beam))) return r;
  return std::nullopt;
}

}  // namespace

std::vector<Reading> corridor_echoes(std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Reading> readings;
  readings.reserve(count);
  for (std::size_t ping = 0; readings.size() < count; ++ping) {
    const std::size_t sensor = ping % mounts.size();
    const double x_m = double(readings.size()) / echoes_per_m;
    Reading reading;
    reading.T_world_robot = {{x_m, 0.15 * std::sin(0.7 * x_m)}, degrees(4.0 * std::sin(0.9 * x_m))};
    const SonarMount& mount = mounts[sensor];
    reading.T_world_tx = reading.T_world_robot * Pose2{{mount.x_m, mount.y_m}, degrees(mount.yaw_deg)};
    reading.T_world_rx = reading.T_world_tx;
    reading.ping = ping;
    reading.scan = std::uint32_t(ping / mounts.size());
    reading.time_s = 0.027 * double(ping);
    reading.tx = reading.rx = SensorId(sensor);
    reading.beam_width = beam;
    const auto wall_m = nearest_wall_m(reading.T_world_tx);
    if (!wall_m) continue;
    reading.outcome = Echo{quantise(*wall_m + rng.normal(0.0, 0.01), range_step_m)};
    readings.push_back(reading);
  }
  return readings;
}

}  // namespace echoarc::bench
