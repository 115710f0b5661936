// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/ping_search.hpp"

namespace echoarc::sim {

namespace {

/// Sound that a point throws back.
void echo_of_point(PingSearch& ping, Vec2 point, double gain_db, EchoCause cause) {
  const Vec2 from = ping.sender.position;
  const Vec2 to = ping.listener.position;
  const double length_m = norm(point - from) + norm(point - to);
  if (length_m > ping.limits.max_length_m || !ping.sender.hears(point) || !ping.listener.hears(point)) return;
  if (ping.sees(from, point) && ping.sees(point, to)) ping.add(point, point, length_m, gain_db, cause, 1);
}

void echo_of_wall_and_edge(PingSearch& ping, const Wall& wall, const Vertex& vertex, bool wall_first) {
  const Ear& near_wall = wall_first ? ping.sender : ping.listener;
  const Ear& near_edge = wall_first ? ping.listener : ping.sender;
  const Mirror mirror(wall);
  if (!mirror.reflects(near_wall.position) || !mirror.reflects(vertex.point)) return;
  const Vec2 image = mirror.image(near_wall.position);
  const double length_m = norm(image - vertex.point) + norm(vertex.point - near_edge.position);
  Vec2 bounce;
  if (length_m > ping.limits.max_length_m || !mirror.bounce(vertex.point, image, bounce)) return;
  if (!near_wall.hears(bounce) || !near_edge.hears(vertex.point)) return;
  if (!vertex.echoes_to(bounce) || !vertex.echoes_to(near_edge.position)) return;
  const Vec2 first = wall_first ? bounce : vertex.point;
  const Vec2 last = wall_first ? vertex.point : bounce;
  if (!ping.sees(ping.sender.position, first) || !ping.sees(first, last) || !ping.sees(last, ping.listener.position))
    return;
  ping.add(first, last, length_m, ping.limits.edge_gain_db - ping.world.loss_db(wall.material), EchoCause::wall_edge,
           2);
}

}  // namespace

void find_edge_paths(PingSearch& ping) {
  for (const Vertex& vertex : ping.world.topology.vertices)
    if (vertex.echoes_to(ping.sender.position) && vertex.echoes_to(ping.listener.position))
      echo_of_point(ping, vertex.point, ping.limits.edge_gain_db, EchoCause::edge);
}

void find_wall_edge_paths(PingSearch& ping) {
  if (ping.limits.max_order < 2) return;
  for (const Wall& wall : ping.world.description.walls)
    for (const Vertex& vertex : ping.world.topology.vertices)
      for (const bool wall_first : {true, false}) echo_of_wall_and_edge(ping, wall, vertex, wall_first);
}

void find_bump_paths(PingSearch& ping) {
  for (const Scatterer& bump : ping.world.bumps.points)
    echo_of_point(ping, bump.point, bump.gain_db, EchoCause::scatterer);
}

}  // namespace echoarc::sim
