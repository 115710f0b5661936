// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "nav/escape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "nav/grid_steps.hpp"

namespace echoarc::nav {
namespace {

struct Reached {
  double length_m = std::numeric_limits<double>::infinity();
  Cell from;
  bool closed = false;
};
using Reach = std::map<Cell, Reached>;

EscapeWay way_to(const Reach& reached, Cell start, Cell end) {
  EscapeWay way{{}, end};
  for (Cell c = end; c != start;) {
    c = reached.at(c).from;
    way.cells.push_back(c);
  }
  std::ranges::reverse(way.cells);
  return way;
}

}  // namespace

std::optional<std::set<Cell>> pocket_around(const CostMap& map, Cell start, double reach_m) {
  const auto passable = [&](Cell c) { return map.cells().box().contains(c) && map.cost_per_m().at(c) > 0.0F; };
  std::set<Cell> pocket;
  if (!passable(start)) return pocket;
  std::vector<Cell> open{start};
  pocket.insert(start);
  while (!open.empty()) {
    const Cell c = open.back();
    open.pop_back();
    if (std::max(std::abs(c.i - start.i), std::abs(c.j - start.j)) * map.geometry().cell_m > reach_m)
      return std::nullopt;
    // A step across a corner needs both cells beside it, so that it joins nothing that these do not.
    for (std::size_t k = 0; k < 4; ++k)
      if (const Cell next = c + grid_steps[k]; passable(next) && pocket.insert(next).second) open.push_back(next);
  }
  return pocket;
}

std::optional<EscapeWay> shortest_escape(const CostMap& map, Cell start, const std::set<Cell>& pocket,
                                         double longest_m) {
  const DenseGrid<CellState>& cells = map.cells();
  const double cell_m = map.geometry().cell_m;
  const bool on_obstacle = cells.at(start) == CellState::occupied;
  const auto open_to_robot = [&](Cell c) {
    if (!cells.box().contains(c)) return false;
    if (cells.at(c) != CellState::occupied) return true;
    return on_obstacle && std::hypot(c.i - start.i, c.j - start.j) * cell_m <= map.inflation_m();
  };
  Reach reached;
  std::priority_queue<std::tuple<double, Cell>, std::vector<std::tuple<double, Cell>>, std::greater<>> open;
  reached[start].length_m = 0.0;
  open.emplace(0.0, start);
  while (!open.empty()) {
    const Cell c = std::get<Cell>(open.top());
    open.pop();
    Reached& here = reached[c];
    if (here.closed) continue;
    here.closed = true;
    if (map.cost_per_m().at(c) > 0.0F && !pocket.contains(c)) return way_to(reached, start, c);
    for (std::size_t k = 0; k < grid_steps.size(); ++k) {
      const Cell next = c + grid_steps[k];
      if (!open_to_robot(next)) continue;
      if (k >= 4 && !(open_to_robot(c + grid_steps[beside(k)[0]]) && open_to_robot(c + grid_steps[beside(k)[1]])))
        continue;
      const double length_m = here.length_m + grid_steps[k].length_cells * cell_m;
      if (length_m > longest_m || length_m >= reached[next].length_m) continue;
      reached[next].length_m = length_m;
      reached[next].from = c;
      open.emplace(length_m, next);
    }
  }
  return std::nullopt;
}

}  // namespace echoarc::nav
