// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/ping_search.hpp"

namespace echoarc::sim {

/// Reflections on straight walls by the image method, order by order.
///
/// Forth from the sender go beams that are mirrored on whatever they light; back from the listener come the walls that
/// it may hear. They meet at the last wall, so a search to order k sweeps beams after up to k - 2 reflections only.
class PlaneSearch {
 public:
  void run(PingSearch& ping);

 private:
  struct Level {
    BeamDepth depth;
    std::vector<Lit> lit;
  };
  void reflect(PingSearch& ping, const Beam& beam, const std::vector<Lit>& lit, std::size_t depth);
  void listen(PingSearch& ping, Vec2 source, std::size_t depth);
  void follow_back(PingSearch& ping, std::size_t order);
  [[nodiscard]] EchoCause cause(const WorldModel& world, std::size_t order) const;

  std::vector<std::uint32_t> last_walls_;
  std::array<Level, PathLimits::highest_order> levels_;
  std::array<std::uint32_t, PathLimits::highest_order> walls_{};
  std::array<Vec2, PathLimits::highest_order> images_{};
  std::array<Vec2, PathLimits::highest_order> bounces_{};
};

}  // namespace echoarc::sim
