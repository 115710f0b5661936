// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The smallest useful program: one echo of one sonar, mapped as a point and as an evidence grid.

#include <cstdio>
#include <span>

#include <echoarc/core/sensor_array.hpp>
#include <echoarc/mapping/centerline.hpp>
#include <echoarc/mapping/evidence_grid.hpp>

int main() {
  const echoarc::SensorArray sonars = echoarc::array_preset("nomad200").value();
  const echoarc::Pose2 T_world_robot{{1.0, 2.0}, echoarc::degrees(90.0)};
  const echoarc::Pose2 T_world_sensor = T_world_robot * sonars.sensors()[0].mount.T_robot_sensor();
  const echoarc::Reading reading{.T_world_robot = T_world_robot,
                                 .T_world_tx = T_world_sensor,
                                 .T_world_rx = T_world_sensor,
                                 .outcome = echoarc::Echo{1.5}};
  echoarc::InlineExecutor executor;
  echoarc::Centerline points;
  echoarc::EvidenceGrid grid;
  points.insert(std::span(&reading, 1), executor);
  grid.insert(std::span(&reading, 1), executor);
  grid.finish(executor);

  const echoarc::Result<echoarc::MapExport> map = grid.export_map();
  if (!map) return 1;
  std::printf("%zu point, %zu occupied cells\n", points.map().size(), map->points.size());
  return 0;
}
