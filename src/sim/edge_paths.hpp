// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <vector>

#include "sim/ping_search.hpp"

namespace echoarc::sim {

/// Points that throw sound back: edges, bumps of rough surfaces, and edges seen in a wall.
class EdgeSearch {
 public:
  void run(PingSearch& ping);

 private:
  void see_vertices(PingSearch& ping, const Ear& ear, const View& view, bool outward, std::vector<std::uint32_t>& seen);
  void find_edges(PingSearch& ping);
  void find_wall_edges(PingSearch& ping, bool wall_first);
  void find_wall_edge(PingSearch& ping, std::uint32_t wall, const Vertex& vertex, bool wall_first);

  std::vector<std::uint32_t> from_sender_;    // vertices that the sender sees
  std::vector<std::uint32_t> from_listener_;  // that see the listener
  std::vector<std::uint32_t> walls_;
};

}  // namespace echoarc::sim
