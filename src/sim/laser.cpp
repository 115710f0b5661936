// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/laser.hpp"

#include <limits>

#include "sim/random_streams.hpp"

namespace echoarc::sim {

Scan scan_of(const World& world, const LaserMount& mount, const LaserOptions& options, const Pose2& T_world_robot,
             double time_s, std::uint64_t seed, std::uint64_t number) {
  const Pose2 T_world_laser = T_world_robot * mount.mount.T_robot_sensor();
  const std::vector<Disc> moving = world.moving_at(time_s);
  const std::vector<Material>& materials = world.description().materials;
  Rng rng = stream(seed, Draw::laser, number, mount.id);
  Scan scan{
      .time_s = time_s,
      .laser = mount.id,
      .angle_min = options.angle_min,
      .angle_step = options.angle_step,
      .ranges_m = std::vector<float>(static_cast<std::size_t>(options.beams), std::numeric_limits<float>::quiet_NaN())};
  for (int k = 0; k < options.beams; ++k) {
    const double noise = rng.normal(0.0, 1.0);
    const Angle beam = T_world_laser.heading + options.angle_min + static_cast<double>(k) * options.angle_step;
    const auto hit = world.first_hit(T_world_laser.position, unit(beam), mount.range_max_m, moving);
    if (!hit || hit->distance_m < mount.range_min_m || !materials[hit->material].laser_ok) continue;
    const double range_m = hit->distance_m + noise * (options.noise_m + options.noise_share * hit->distance_m);
    if (range_m > 0.0) scan.ranges_m[static_cast<std::size_t>(k)] = static_cast<float>(range_m);
  }
  return scan;
}

}  // namespace echoarc::sim
