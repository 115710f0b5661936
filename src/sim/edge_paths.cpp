// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/ping_search.hpp"

namespace echoarc::sim {

void find_edge_paths(PingSearch& ping) {
  const Vec2 from = ping.sender.position;
  const Vec2 to = ping.listener.position;
  for (const Vertex& vertex : ping.world.topology.vertices) {
    const double length_m = norm(vertex.point - from) + norm(vertex.point - to);
    if (length_m > ping.limits.max_length_m || !vertex.echoes_to(from) || !vertex.echoes_to(to)) continue;
    if (!ping.sender.hears(vertex.point) || !ping.listener.hears(vertex.point)) continue;
    if (ping.sees(from, vertex.point) && ping.sees(vertex.point, to))
      ping.add(vertex.point, vertex.point, length_m, ping.limits.edge_gain_db, EchoCause::edge, 1);
  }
}

}  // namespace echoarc::sim
