// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/exploration_picture.hpp"

#include <vector>

#include "echoarc/io/picture.hpp"
#include "io/world_lines.hpp"

namespace echoarc::io {

Result<void> write_exploration_picture(const std::filesystem::path& path, const sim::Scene& scene, const Log& log,
                                       const DenseGrid<CellState>& map, const nav::Sketch& sketch) {
  const Polylines surfaces = surfaces_of(scene.world);
  const Polylines movers = movers_of(scene.world);
  std::vector<Vec2> way;
  for (const Odometry& pose : log.truth) way.push_back(pose.T_world_robot.position);
  std::vector<Vec2> nodes;
  for (const nav::Sketch::Node& node : sketch.nodes) nodes.push_back(node.place);
  return write_picture(path, {.title = title_of(scene),
                              .states = map.empty() ? nullptr : &map,
                              .path = way,
                              .surfaces = surfaces,
                              .movers = movers,
                              .graph = sketch.edges,
                              .nodes = nodes});
}

}  // namespace echoarc::io
