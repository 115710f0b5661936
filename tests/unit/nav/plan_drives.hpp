// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstdint>

#include "echoarc/core/pose2.hpp"
#include "echoarc/core/robot_motion.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/nav/strategy.hpp"

namespace echoarc::nav {

/// A robot that does at once what is wanted of it.
inline Pose2 driven(const Pose2& T_world_base, const RobotVelocity& velocity, double step_s) {
  const Angle middle = T_world_base.heading + 0.5 * step_s * velocity.turn_per_s;
  return {T_world_base.position + step_s * velocity.forward_m_s * unit(middle),
          wrap(T_world_base.heading + step_s * velocity.turn_per_s)};
}

/// A robot in a place that it maps by sight: all cells up to the first obstacle, in all directions.
struct Drive {
  DenseGrid<CellState> truth;
  Pose2 T_world_base;
  double sight_m = 2.0;
  DenseGrid<CellState> known{};
  std::uint64_t version = 0;
  double time_s = 0.0;
  double nearest_m = 1e9;  ///< that its centre came to an occupied cell's
  Steering steering{};
  static constexpr double step_s = 0.1;

  void look() {
    if (!is_finite(T_world_base.position)) return;  // nobody knows what it would see
    const GridGeometry& geometry = truth.geometry();
    if (known.empty()) known = DenseGrid<CellState>(geometry, truth.width(), truth.height());
    for (int k = 0; k < 180; ++k)
      for (double range_m = 0.0; range_m < sight_m; range_m += 0.5 * geometry.cell_m) {
        const Cell c = geometry.cell_of(T_world_base.position + range_m * unit(degrees(2.0 * k)));
        if (!truth.box().contains(c)) break;
        known.at(c) = truth.at(c);
        if (truth.at(c) == CellState::occupied) break;
      }
    ++version;
  }

  /// Until the strategy ends, or for so long; looks about every half second.
  void run(Strategy& strategy, double longest_s) {
    for (int step = 0; step * step_s < longest_s; ++step) {
      if (step % 5 == 0 && sight_m > 0.0) look();
      once(strategy);
      if (steering.status != Status::running) return;
    }
  }

  void once(Strategy& strategy) {
    steering = strategy.update({.time_s = time_s,
                                .T_world_base = T_world_base,
                                .velocity = steering.wanted,
                                .map = known.empty() ? nullptr : &known,
                                .map_version = version});
    T_world_base = driven(T_world_base, steering.wanted, step_s);
    time_s += step_s;
    if (!is_finite(T_world_base.position)) return;
    const GridGeometry& geometry = truth.geometry();
    const Cell here = geometry.cell_of(T_world_base.position);
    if (!truth.box().contains(here)) return;
    for (std::int32_t j = here.j - 5; j <= here.j + 5; ++j)
      for (std::int32_t i = here.i - 5; i <= here.i + 5; ++i)
        if (truth.box().contains({i, j}) && truth.at({i, j}) == CellState::occupied)
          nearest_m = std::min(nearest_m, norm(geometry.centre({i, j}) - T_world_base.position));
  }
};

}  // namespace echoarc::nav
