// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/echo_paths.hpp"

#include "sim/ping_search.hpp"

namespace echoarc::sim {

std::span<const EchoPath> PathFinder::find(const Transducer& transmitter, const Transducer& receiver,
                                           const PathLimits& limits, std::span<const Disc> moving) {
  paths_.clear();
  PingSearch ping(world_->model(), transmitter, receiver, limits, moving, paths_);
  find_plane_paths(ping);
  find_disc_paths(ping);
  find_curve_paths(ping);
  find_edge_paths(ping);
  find_wall_edge_paths(ping);
  find_bump_paths(ping);
  order_paths(paths_);
  return paths_;
}

}  // namespace echoarc::sim
