// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/echo_paths.hpp"

#include "sim/edge_paths.hpp"
#include "sim/ping_search.hpp"
#include "sim/plane_paths.hpp"

namespace echoarc::sim {

struct PathFinder::Workspace {
  explicit Workspace(const WorldModel& world) : ping(world, paths) {}

  std::vector<EchoPath> paths;
  PingSearch ping;
  PlaneSearch planes;
  EdgeSearch edges;
};

PathFinder::PathFinder(const World& world) : workspace_(std::make_unique<Workspace>(world.model())) {}
PathFinder::PathFinder(PathFinder&&) noexcept = default;
PathFinder& PathFinder::operator=(PathFinder&&) noexcept = default;
PathFinder::~PathFinder() = default;

std::span<const EchoPath> PathFinder::find(const Transducer& transmitter, const Transducer& receiver,
                                           const PathLimits& limits, std::span<const Disc> moving) {
  workspace_->paths.clear();
  const auto stands = [](const Transducer& t) {
    return is_finite(t.position) && is_finite(t.axis) && t.half_window.rad() >= 0.0;
  };
  if (!stands(transmitter) || !stands(receiver) || !(limits.max_length_m > 0.0)) return {};
  PingSearch& ping = workspace_->ping;
  ping.start(transmitter, receiver, limits, moving);
  find_disc_paths(ping);
  find_curve_paths(ping);
  find_bump_paths(ping);
  workspace_->edges.run(ping);
  workspace_->planes.run(ping);
  order_paths(workspace_->paths);
  if (!ping.within_bounds()) ++truncated_;
  return workspace_->paths;
}

}  // namespace echoarc::sim
