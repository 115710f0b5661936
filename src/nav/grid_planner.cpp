// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/grid_planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "echoarc/nav/path.hpp"
#include "nav/escape.hpp"
#include "nav/grid_steps.hpp"

namespace echoarc::nav {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// The earliest first, the lower index of two alike, so that a search is the same everywhere.
constexpr auto later = [](const auto& a, const auto& b) {
  return a.estimate != b.estimate ? a.estimate > b.estimate : a.index > b.index;
};

}  // namespace

std::string_view text(PlanFault fault) {
  constexpr std::array<std::string_view, 9> texts{
      "there is a way",           "there is no map",       "the robot's place is not a number",
      "the robot is off the map", "the robot is boxed in", "the goal is not a number",
      "the goal is off the map",  "the goal is in a wall", "the goal cannot be reached"};
  return texts[static_cast<std::size_t>(fault)];
}

void GridPlanner::begin(const CostMap& map, Vec2 start, std::span<const PlanGoal> goals) {
  plan_ = {};
  escape_.clear();
  goals_.clear();
  goal_cells_.clear();
  goal_box_ = {};
  open_.clear();
  done_ = false;
  if (map.empty()) return fail(PlanFault::no_map);
  prepare(map);
  start_ = start;
  if (!is_finite(start)) return fail(PlanFault::bad_start);
  const Cell cell = map.geometry().cell_of(start);
  if (!map.cells().box().contains(cell)) return fail(PlanFault::start_off_map);
  if (!admit_goals(map, goals)) return;
  const std::optional<Cell> from = depart(map, cell);
  if (!from) return fail(PlanFault::boxed_in);
  start_cell_ = *from;
  open({index_of(*from), *from, 0.0F, 0});
}

bool GridPlanner::advance(std::size_t expansions) {
  while (!done_ && expansions > 0) {
    if (open_.empty()) {
      fail(left_surroundings_ ? PlanFault::unreachable : PlanFault::boxed_in);
      break;
    }
    if (options_.order != SearchOrder::depth_first) std::ranges::pop_heap(open_, later);
    const std::uint32_t index = open_.back().index;
    open_.pop_back();
    Node& here = nodes_[index];
    if (here.closed) continue;
    here.closed = true;
    if (here.goal) {
      finish(index);
      break;
    }
    ++plan_.expanded;
    --expansions;
    expand(index);
  }
  return done_;
}

Plan GridPlanner::plan(const CostMap& map, Vec2 start, Vec2 goal) {
  const PlanGoal goals[] = {{goal, 0.0}};
  return plan(map, start, goals);
}

Plan GridPlanner::plan(const CostMap& map, Vec2 start, std::span<const PlanGoal> goals) {
  begin(map, start, goals);
  advance(std::numeric_limits<std::size_t>::max());
  return plan_;
}

/// Takes the costs over; nodes of searches before count as unwritten by their number.
void GridPlanner::prepare(const CostMap& map) {
  cost_per_m_ = map.cost_per_m();
  if (nodes_.size() != cost_per_m_.values().size() || search_ == std::numeric_limits<std::uint32_t>::max()) {
    nodes_.assign(cost_per_m_.values().size(), Node{});
    search_ = 0;
  }
  ++search_;
  left_surroundings_ = false;
  for (std::size_t k = 0; k < grid_steps.size(); ++k)
    step_m_[k] = float(grid_steps[k].length_cells * cost_per_m_.geometry().cell_m);
}

/// The cell from which the search begins: the robot's own, or where an escape ends.
std::optional<Cell> GridPlanner::depart(const CostMap& map, Cell start) {
  const auto pocket = pocket_around(map, start, options_.escape_m);
  if (!pocket) return start;
  const bool has_goal = std::ranges::any_of(*pocket, [&](Cell c) { return node(index_of(c)).goal; });
  if (has_goal) return start;
  if (const std::optional<EscapeWay> way = shortest_escape(map, start, *pocket, options_.escape_m)) {
    for (const Cell c : way->cells) escape_.push_back(c == start ? start_ : map.geometry().centre(c));
    return way->end;
  }
  return pocket->empty() ? std::nullopt : std::optional(start);
}

bool GridPlanner::admit_goals(const CostMap& map, std::span<const PlanGoal> goals) {
  PlanFault fault = PlanFault::bad_goal;
  for (std::size_t number = 0; number < goals.size(); ++number) {
    goals_.push_back(goals[number].place);
    if (!is_finite(goals[number].place)) continue;
    if (!map.cells().box().contains(map.geometry().cell_of(goals[number].place)))
      fault = std::max(fault, PlanFault::goal_off_map);
    else if (!mark_goal(map, number, goals[number]))
      fault = std::max(fault, PlanFault::goal_in_wall);
  }
  if (goal_cells_.empty()) fail(fault);
  return !goal_cells_.empty();
}

bool GridPlanner::mark_goal(const CostMap& map, std::size_t number, const PlanGoal& goal) {
  const GridGeometry& geometry = map.geometry();
  const Cell cell = geometry.cell_of(goal.place);
  if (cost_per_m_.at(cell) > 0.0F) {
    mark_cell(cell, number);
    return true;
  }
  const double reach_m = std::isfinite(goal.reach_m) ? std::clamp(goal.reach_m, 0.0, 10.0) : 0.0;
  const auto reach_cells = std::int32_t(std::ceil(reach_m / geometry.cell_m));
  bool marked = false;
  for (std::int32_t j = cell.j - reach_cells; j <= cell.j + reach_cells; ++j)
    for (std::int32_t i = cell.i - reach_cells; i <= cell.i + reach_cells; ++i) {
      const Cell c{i, j};
      if (!cost_per_m_.box().contains(c) || cost_per_m_.at(c) <= 0.0F) continue;
      if (norm(geometry.centre(c) - goal.place) > reach_m) continue;
      if (!in_sight(map.cells(), geometry.centre(c), goal.place)) continue;
      mark_cell(c, number);
      marked = true;
    }
  return marked;
}

void GridPlanner::mark_cell(Cell c, std::size_t number) {
  const std::uint32_t index = index_of(c);
  node(index).goal = true;
  goal_cells_.emplace_back(index, std::uint32_t(number));
  goal_box_ = unite(goal_box_, {c.i, c.j, c.i + 1, c.j + 1});
}

void GridPlanner::expand(std::uint32_t index) {
  const Cell c = cell_of(index);
  const auto aside_cells = std::max(std::abs(c.i - start_cell_.i), std::abs(c.j - start_cell_.j));
  left_surroundings_ = left_surroundings_ || aside_cells * cost_per_m_.geometry().cell_m > options_.escape_m;
  const CellBox box = cost_per_m_.box();
  const bool at_border = c.i == 0 || c.j == 0 || c.i + 1 == box.i_end || c.j + 1 == box.j_end;
  const std::span<const float> costs_per_m = std::as_const(cost_per_m_).values();
  const float cost = nodes_[index].cost;
  std::array<bool, 8> passable{};
  std::array<Candidate, 8> candidates{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < grid_steps.size(); ++k) {
    const Cell next = c + grid_steps[k];
    if (at_border && !box.contains(next)) continue;
    const std::uint32_t there = index_of(next);
    passable[k] = costs_per_m[there] > 0.0F;
    if (!passable[k] || (k >= 4 && !(passable[beside(k)[0]] && passable[beside(k)[1]]))) continue;
    const float step_cost = 0.5F * (costs_per_m[index] + costs_per_m[there]) * step_m_[k];
    candidates[count++] = {there, next, cost + step_cost, std::uint8_t(k)};
  }
  const std::span<Candidate> reached(candidates.data(), count);
  if (options_.order == SearchOrder::depth_first)  // the last to be opened is looked at first
    std::ranges::sort(reached, std::ranges::greater{},
                      [&](const Candidate& n) { return std::pair(estimate(n.cell), n.step); });
  for (const Candidate& candidate : reached) open(candidate);
}

void GridPlanner::open(const Candidate& candidate) {
  Node& there = node(candidate.index);
  const bool depth_first = options_.order == SearchOrder::depth_first;
  if (there.closed || (!depth_first && candidate.cost >= there.cost)) return;
  there.cost = candidate.cost;
  there.from = candidate.step;
  if (depth_first) {
    open_.push_back({0.0F, candidate.index});
    return;
  }
  open_.push_back({candidate.cost + estimate(candidate.cell), candidate.index});
  std::ranges::push_heap(open_, later);
}

/// No way from here to a goal costs less: the octile distance to the box around all goals.
float GridPlanner::estimate(Cell c) const {
  if (options_.order == SearchOrder::dijkstra) return 0.0F;
  const auto beyond = [](std::int32_t x, std::int32_t begin, std::int32_t end) {
    return std::max({begin - x, x - (end - 1), 0});
  };
  const auto di = beyond(c.i, goal_box_.i_begin, goal_box_.i_end);
  const auto dj = beyond(c.j, goal_box_.j_begin, goal_box_.j_end);
  return float(std::abs(di - dj)) * step_m_[0] + float(std::min(di, dj)) * step_m_[4];
}

GridPlanner::Node& GridPlanner::node(std::uint32_t index) {
  Node& node = nodes_[index];
  if (node.search != search_) node = {infinite, search_, 0, false, false};
  return node;
}

void GridPlanner::finish(std::uint32_t index) {
  const Cell end = cell_of(index);
  const GridGeometry& geometry = cost_per_m_.geometry();
  std::vector<Vec2> way;
  for (Cell c = end; c != start_cell_;) {
    way.push_back(geometry.centre(c));
    const GridStep& step = grid_steps[nodes_[index_of(c)].from];
    c = {c.i - step.di, c.j - step.dj};
  }
  way.push_back(geometry.centre(start_cell_));
  if (escape_.empty() && way.back() != start_) way.push_back(start_);
  std::ranges::reverse(way);
  plan_.goal = std::ranges::find(goal_cells_, index, &GoalCell::index)->number;
  const Vec2 goal = goals_[plan_.goal];
  if (geometry.cell_of(goal) == end && way.back() != goal) way.push_back(goal);
  plan_.path = escape_;
  plan_.escape = escape_.size();
  const std::vector<Vec2> straightened = options_.straighten ? shortcut(cost_per_m_, way) : way;
  plan_.path.insert(plan_.path.end(), straightened.begin(), straightened.end());
  plan_.cost_m = nodes_[index].cost;
  done_ = true;
}

void GridPlanner::fail(PlanFault fault) {
  plan_.fault = fault;
  plan_.path.clear();
  done_ = true;
}

std::uint32_t GridPlanner::index_of(Cell c) const {
  return std::uint32_t(c.j) * std::uint32_t(cost_per_m_.width()) + std::uint32_t(c.i);
}

Cell GridPlanner::cell_of(std::uint32_t index) const {
  const auto width = std::uint32_t(cost_per_m_.width());
  return {std::int32_t(index % width), std::int32_t(index / width)};
}

}  // namespace echoarc::nav
