// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::test {

inline Vec2 grid_position(const GridGeometry& grid, Vec2 p) {
  return {(p.x - grid.origin.x) / grid.cell_m, (p.y - grid.origin.y) / grid.cell_m};
}

/// Adds where a coordinate passes a whole number between `low` and `high`. Between such fine steps it either goes one
/// way, or turns once: then both ways to the turning point are searched.
template <class Coordinate>
void collect_crossings(const Coordinate& coordinate, double low, double high, std::vector<double>& ts) {
  const double ends[] = {coordinate(low), coordinate(high)};
  const double bend = coordinate(0.5 * (low + high)) - 0.5 * (ends[0] + ends[1]);
  const double margin = 2.0 * std::abs(bend);  // more than the arc can leave the range of its ends
  if (std::floor(std::min(ends[0], ends[1]) - margin) == std::floor(std::max(ends[0], ends[1]) + margin)) return;
  double turn = low;
  double a = low;
  double b = high;
  for (int n = 0; n < 60; ++n) {  // ternary search of the extremum
    const double p = a + (b - a) / 3;
    const double q = b - (b - a) / 3;
    ((bend > 0) == (coordinate(p) < coordinate(q)) ? a : b) = (bend > 0) == (coordinate(p) < coordinate(q)) ? p : q;
    turn = 0.5 * (a + b);
  }
  for (const auto& [from, to] : {std::pair(low, turn), std::pair(turn, high)}) {
    double lo = from;
    double hi = to;
    if (std::floor(coordinate(lo)) == std::floor(coordinate(hi))) continue;
    const bool rising = coordinate(hi) > coordinate(lo);
    const double line = std::floor(std::max(coordinate(lo), coordinate(hi)));
    for (int n = 0; n < 60; ++n) {
      const double mid = 0.5 * (lo + hi);
      ((coordinate(mid) < line) == rising ? lo : hi) = mid;
    }
    ts.push_back(0.5 * (lo + hi));
  }
}

/// The definition, step by step: every parameter at which the arc meets a grid line, found by bisection between fine
/// steps, sorted; the middle between two neighbours marks its cell.
inline std::set<Cell> slow_exact_cells(const GridGeometry& grid, const Arc& arc) {
  const auto point = [&](double t) { return grid_position(grid, arc.point_at(radians(t))); };
  const double begin = arc.t_begin().rad();
  const double end = arc.t_end().rad();
  const int steps = 64 + int(arc.range_m() * (end - begin) / grid.cell_m * 16.0);
  std::vector<double> ts{begin, end};
  for (int k = 0; k < steps; ++k)
    for (const bool vertical : {false, true}) {
      const auto coordinate = [&](double t) { return vertical ? point(t).x : point(t).y; };
      collect_crossings(coordinate, begin + (end - begin) * k / steps, begin + (end - begin) * (k + 1) / steps, ts);
    }
  std::ranges::sort(ts);
  std::set<Cell> cells;
  for (std::size_t k = 1; k < ts.size(); ++k)
    if (ts[k] - ts[k - 1] > 1e-11) cells.insert(grid.cell_of(arc.point_at(radians(0.5 * (ts[k - 1] + ts[k])))));
  return cells;
}

}  // namespace echoarc::test
