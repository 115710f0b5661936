// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/mapping/bayes_update.hpp"
#include "echoarc/maps/grid_geometry.hpp"
#include "support/slow_arc_cells.hpp"

/// Slow, obvious versions of the methods, straight from the papers: whole grids, one cell at a time, atan2 everywhere.
/// For testing purposes only.
namespace echoarc::oracle {

using Counts = std::map<Cell, int>;

/// [Barshan07] 3.2: counts each arc once in every cell it crosses.
inline Counts votes(std::span<const Reading> readings, const GridGeometry& geometry) {
  Counts counts;
  for (const Reading& reading : readings)
    if (const auto arc = arc_of(reading))
      for (const Cell cell : test::slow_exact_cells(geometry, *arc)) ++counts[cell];
  return counts;
}

/// [Barshan07] 3.3 for one line of counts, from the robot outward: all maxima, then the median one.
inline std::optional<Cell> line_survivor(const std::vector<Cell>& line, const Counts& counts, int threshold) {
  int maximum = threshold;
  for (const Cell c : line)
    if (const auto found = counts.find(c); found != counts.end()) maximum = std::max(maximum, found->second);
  std::vector<Cell> maxima;
  for (const Cell c : line)
    if (const auto found = counts.find(c); found != counts.end() && found->second == maximum) maxima.push_back(c);
  if (maxima.empty()) return std::nullopt;
  return maxima[(maxima.size() - 1) / 2];
}

/// The cells a segment crosses, ordered along it: every cell of the box is clipped against the segment.
inline std::vector<Cell> crossed_cells(Vec2 origin, Vec2 direction, double length_m, const CellBox& box,
                                       const GridGeometry& geometry) {
  std::vector<std::pair<double, Cell>> entered;
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j)
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const Vec2 low = geometry.corner({i, j});
      const Vec2 high = geometry.corner({i + 1, j + 1});
      const double x0 = (low.x - origin.x) / direction.x;
      const double x1 = (high.x - origin.x) / direction.x;
      const double y0 = (low.y - origin.y) / direction.y;
      const double y1 = (high.y - origin.y) / direction.y;
      const double in = std::max({0.0, std::min(x0, x1), std::min(y0, y1)});
      const double out = std::min({length_m, std::max(x0, x1), std::max(y0, y1)});
      if (out > in) entered.emplace_back(in, Cell{i, j});
    }
  std::ranges::sort(entered, {}, &std::pair<double, Cell>::first);
  std::vector<Cell> cells;
  for (const auto& [at, cell] : entered) cells.push_back(cell);
  return cells;
}

/// [Barshan07] eqs. 1 to 8 in every cell of the box.
inline std::map<Cell, BayesCell> bayes(std::span<const Reading> readings, const CellBox& box,
                                       const BayesUpdateOptions& options) {
  const GridGeometry geometry = geometry_of(options);
  std::map<Cell, BayesCell> cells;
  for (const Reading& reading : readings) {
    const auto arc = arc_of(reading);
    if (!arc) continue;
    const double r = arc->range_m();
    const double r_min = options.near_field_m;
    const double r_eps = options.range_error_m;
    const double theta_o = arc->half_width().rad();
    for (std::int32_t j = box.j_begin; j < box.j_end; ++j)
      for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
        const Vec2 p = geometry.centre({i, j});
        const double sigma = (norm(p - arc->transmitter()) + norm(p - arc->receiver())) / 2.0;
        const double theta = wrap(bearing(p - arc->centre()) - arc->axis()).rad();
        if (std::abs(theta) > theta_o) continue;
        const double angular = 1.0 - (theta / theta_o) * (theta / theta_o);
        double empty = 0.0;
        double occupied = 0.0;
        if (r - r_eps > r_min && sigma >= r_min && sigma <= r - r_eps)
          empty = (1.0 - std::pow((sigma - r_min) / (r - r_eps - r_min), 2)) * angular;
        if (sigma >= r - r_eps && sigma <= r + r_eps) occupied = (1.0 - std::pow((sigma - r) / r_eps, 2)) * angular;
        BayesCell& cell = cells[{i, j}];
        cell.empty = cell.empty + empty - cell.empty * empty;
        cell.occupied = cell.occupied + occupied - cell.occupied * occupied;
      }
  }
  return cells;
}

}  // namespace echoarc::oracle
