// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::nav {

/// Crossings of a row and a column this near to each other, in parts of the way, are taken for a corner.
inline constexpr double corner_tolerance = 1e-9;

/// Calls `visit(cell, length in it, m)` for every cell that the way from `a` to `b` touches, in their order; through a
/// corner of cells, for the two beside it as well, with length 0. Ends early when `visit` gives false; whether it went
/// to the end. Both ends lie within reach of the grid ([AmanatidesWoo87], with corners).
template <class Visit>
bool for_cells_on_way(const GridGeometry& geometry, Vec2 a, Vec2 b, Visit&& visit) {
  const Vec2 from = (a - geometry.origin) / geometry.cell_m;
  const Vec2 way = (b - a) / geometry.cell_m;
  const double length_m = norm(b - a);
  Cell c = geometry.cell_of(a);
  const Cell end = geometry.cell_of(b);
  const std::int32_t step_i = way.x > 0.0 ? 1 : -1;
  const std::int32_t step_j = way.y > 0.0 ? 1 : -1;
  const auto crossing = [](std::int32_t cell, std::int32_t step, double start, double along) {
    return along == 0.0 ? std::numeric_limits<double>::infinity() : (cell + (step > 0 ? 1 : 0) - start) / along;
  };
  double t = 0.0;
  while (c != end) {
    // What is left in either direction bounds the way, so that no rounding leads past the end.
    const double next_i = c.i == end.i ? 2.0 : crossing(c.i, step_i, from.x, way.x);
    const double next_j = c.j == end.j ? 2.0 : crossing(c.j, step_j, from.y, way.y);
    const double next = std::clamp(std::min(next_i, next_j), t, 1.0);
    if (!visit(c, (next - t) * length_m)) return false;
    t = next;
    if (std::abs(next_i - next_j) <= corner_tolerance) {
      if (!visit(Cell{c.i + step_i, c.j}, 0.0) || !visit(Cell{c.i, c.j + step_j}, 0.0)) return false;
      c = {c.i + step_i, c.j + step_j};
    } else if (next_i < next_j) {
      c.i += step_i;
    } else {
      c.j += step_j;
    }
  }
  return visit(c, (1.0 - t) * length_m);
}

}  // namespace echoarc::nav
