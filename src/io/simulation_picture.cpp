// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/simulation_picture.hpp"

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/io/picture.hpp"
#include "io/world_lines.hpp"

namespace echoarc::io {
namespace {

/// Where a map that knows nothing better would put the echo.
Vec2 place_of(const Ping& ping, const Pose2& T_world_robot, const SensorArray& sensors) {
  const Pose2 T_world_tx = T_world_robot * sensors.find(ping.tx)->mount.T_robot_sensor();
  const Pose2 T_world_rx = T_world_robot * sensors.find(ping.rx)->mount.T_robot_sensor();
  const Angle aside = wrap(T_world_rx.heading - T_world_tx.heading);
  return 0.5 * (T_world_tx.position + T_world_rx.position) + ping.range_m * unit(T_world_tx.heading + 0.5 * aside);
}

std::vector<EchoMark> echoes_of(const sim::Simulation& simulation) {
  const Log& log = simulation.log;
  PoseTrack truth;
  for (const Odometry& pose : log.truth) (void)truth.push(pose);
  std::vector<EchoMark> marks;
  for (const std::vector<Ping>* pings : {&log.pings, &simulation.polled_pings})
    for (const Ping& ping : *pings) {
      if (ping.cause == EchoCause::unknown || ping.echo_index > 0) continue;
      const auto pose = truth.at(ping.time_s);
      if (const auto* T_world_robot = std::get_if<Pose2>(&pose))
        marks.push_back({place_of(ping, *T_world_robot, log.robot.sensors), ping.cause});
    }
  return marks;
}

}  // namespace

Result<void> write_simulation_picture(const std::filesystem::path& path, const sim::Scene& scene,
                                      const sim::Simulation& simulation) {
  const Polylines surfaces = surfaces_of(scene.world);
  const Polylines movers = movers_of(scene.world);
  const std::vector<EchoMark> echoes = echoes_of(simulation);
  std::vector<Vec2> way;
  for (const Odometry& pose : simulation.log.truth) way.push_back(pose.T_world_robot.position);
  return write_picture(
      path, {.title = title_of(scene), .path = way, .surfaces = surfaces, .movers = movers, .echoes = echoes});
}

}  // namespace echoarc::io
