// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/grid_planner.hpp"
#include "echoarc/nav/path.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

CostMap costs_of(const DenseGrid<CellState>& map, double radius_m = 0.0, CostMapOptions options = {}) {
  options.margin_m = 0.0;
  CostMap costs(options, radius_m);
  costs.update(map);
  return costs;
}

Plan planned(const CostMap& costs, Vec2 start, Vec2 goal, const GridPlannerOptions& options = {}) {
  return GridPlanner(options).plan(costs, start, goal);
}

/// The textbook's way: of all cells that are not done, the cheapest; no heap, no estimate.
double slow_cost(const CostMap& costs, Vec2 start, Vec2 goal) {
  const DenseGrid<float>& cost_per_m = costs.cost_per_m();
  const auto blocked = [&](Cell c) { return !cost_per_m.box().contains(c) || cost_per_m.at(c) <= 0.0F; };
  const Cell from = costs.geometry().cell_of(start);
  const Cell to = costs.geometry().cell_of(goal);
  if (blocked(from) || blocked(to)) return infinite;
  DenseGrid<double> cost(costs.geometry(), cost_per_m.width(), cost_per_m.height(), infinite);
  std::set<std::pair<double, Cell>> open{{0.0, from}};
  cost.at(from) = 0.0;
  while (!open.empty()) {
    const Cell c = open.begin()->second;
    open.erase(open.begin());
    if (c == to) return cost.at(c);
    for (std::int32_t dj = -1; dj <= 1; ++dj)
      for (std::int32_t di = -1; di <= 1; ++di) {
        const Cell next{c.i + di, c.j + dj};
        if (blocked(next) || blocked({c.i + di, c.j}) || blocked({c.i, c.j + dj})) continue;
        const double mean = 0.5 * (double(cost_per_m.at(c)) + double(cost_per_m.at(next)));
        const double there = cost.at(c) + mean * std::hypot(di, dj) * costs.geometry().cell_m;
        if (there >= cost.at(next)) continue;
        open.erase({cost.at(next), next});
        cost.at(next) = there;
        open.emplace(there, next);
      }
  }
  return infinite;
}

TEST(GridPlanner, StraightInTheOpen) {
  const CostMap costs = costs_of(free_map(30, 30));
  const Plan plan = planned(costs, {0.31, 0.32}, {2.35, 1.25});
  ASSERT_EQ(plan.fault, PlanFault::none);
  EXPECT_EQ(plan.path.front(), (Vec2{0.31, 0.32}));
  EXPECT_EQ(plan.path.back(), (Vec2{2.35, 1.25}));
  EXPECT_NEAR(plan.cost_m, 0.1 * (9 * std::numbers::sqrt2 + 11), 1e-5) << "9 cells up, 20 across";
  EXPECT_LT(length_m(plan.path), 2.3);
}

TEST(GridPlanner, GoesThroughTheMiddleOfADoor) {
  DenseGrid<CellState> map = free_map(40, 40);
  occupy(map, {{2.0, 0.0}, {2.1, 1.5}});
  occupy(map, {{2.0, 2.4}, {2.1, 4.0}});
  const CostMap costs = costs_of(map, 0.225);
  const Plan plan = planned(costs, {0.55, 3.55}, {3.55, 3.55});
  ASSERT_EQ(plan.fault, PlanFault::none);
  const auto crossing = std::ranges::find_if(plan.path, [](Vec2 p) { return p.x > 1.95; });
  ASSERT_NE(crossing, plan.path.begin());
  const Vec2 before = *(crossing - 1);
  const double y = before.y + (2.05 - before.x) / (crossing->x - before.x) * (crossing->y - before.y);
  EXPECT_NEAR(y, 1.95, 0.15);
}

TEST(GridPlanner, SaysWhyThereIsNoWay) {
  DenseGrid<CellState> map = free_map(30, 30);
  occupy(map, {{1.4, 0.0}, {1.5, 3.0}});
  const CostMap costs = costs_of(map, 0.25);
  const Vec2 here{0.55, 0.55};
  const double nan = std::nan("");
  EXPECT_EQ(planned(CostMap({}, 0.2), here, {1.0, 1.0}).fault, PlanFault::no_map);
  EXPECT_EQ(planned(costs, {nan, 0.0}, {1.0, 1.0}).fault, PlanFault::bad_start);
  EXPECT_EQ(planned(costs, {-3.0, 0.0}, {1.0, 1.0}).fault, PlanFault::start_off_map);
  EXPECT_EQ(planned(costs, here, {1.0, nan}).fault, PlanFault::bad_goal);
  EXPECT_EQ(planned(costs, here, {1.0, 1e300}).fault, PlanFault::goal_off_map);
  EXPECT_EQ(planned(costs, here, {1.45, 1.0}).fault, PlanFault::goal_in_wall);
  EXPECT_EQ(planned(costs, here, {1.25, 1.0}).fault, PlanFault::goal_in_wall) << "the robot has no room there";
  EXPECT_EQ(planned(costs, here, {2.55, 1.0}).fault, PlanFault::unreachable);
  EXPECT_EQ(GridPlanner().plan(costs, here, std::span<const PlanGoal>{}).fault, PlanFault::bad_goal);
  for (const PlanFault fault : {PlanFault::no_map, PlanFault::boxed_in, PlanFault::unreachable})
    EXPECT_FALSE(text(fault).empty());
  EXPECT_EQ(text(PlanFault::goal_in_wall), "the goal is in a wall");
}

TEST(GridPlanner, ARobotIsBoxedIn) {
  DenseGrid<CellState> map = free_map(40, 40);
  occupy(map, {{1.5, 1.5}, {2.5, 2.5}});
  occupy(map, {{1.6, 1.6}, {2.4, 2.4}}, CellState::free);
  EXPECT_EQ(planned(costs_of(map, 0.2), {2.05, 2.05}, {0.55, 0.55}).fault, PlanFault::boxed_in);
  EXPECT_EQ(planned(costs_of(map, 0.6), {2.05, 2.05}, {0.55, 0.55}).fault, PlanFault::boxed_in)
      << "nowhere even to stand";
}

TEST(GridPlanner, LeavesInflationByTheShortestWay) {
  DenseGrid<CellState> map = free_map(40, 40);
  occupy(map, {{0.0, 2.0}, {4.0, 2.1}});
  const CostMap costs = costs_of(map, 0.35);
  const Vec2 start{1.05, 1.87};
  const Plan plan = planned(costs, start, {3.55, 0.55});
  ASSERT_EQ(plan.fault, PlanFault::none);
  EXPECT_EQ(plan.path.front(), start);
  ASSERT_EQ(plan.escape, 2U) << "two cells down, away from the wall";
  for (std::size_t k = 0; k <= plan.escape; ++k) EXPECT_NEAR(plan.path[k].x, 1.05, 1e-9);
  EXPECT_TRUE(path_cost(costs.cost_per_m(), std::span(plan.path).subspan(plan.escape)));
  EXPECT_EQ(planned(costs, start, {3.55, 0.55}, {.escape_m = 0.1}).fault, PlanFault::boxed_in);
}

TEST(GridPlanner, LeavesAPocketInInflation) {
  DenseGrid<CellState> map = free_map(40, 40);
  for (const Vec2 post : {Vec2{1.0, 1.0}, Vec2{1.65, 1.0}, Vec2{1.0, 1.65}, Vec2{1.65, 1.65}})
    occupy(map, {post, post + Vec2{0.1, 0.1}});
  const CostMap costs = costs_of(map, 0.38);
  const Vec2 start{1.35, 1.35};
  ASSERT_GT(costs.cost_per_m().at(map.geometry().cell_of(start)), 0.0F);
  const Plan plan = planned(costs, start, {3.55, 3.55});
  ASSERT_EQ(plan.fault, PlanFault::none);
  EXPECT_GT(plan.escape, 0U);
  EXPECT_EQ(planned(costs, start, {1.36, 1.36}).escape, 0U) << "the goal lies within";
}

TEST(GridPlanner, AnObstacleUnderTheRobotIsTheMapsError) {
  DenseGrid<CellState> map = free_map(40, 40);
  occupy(map, {{1.0, 1.0}, {1.3, 1.3}});
  const CostMap costs = costs_of(map, 0.25);
  EXPECT_EQ(planned(costs, {1.15, 1.15}, {3.05, 3.05}).fault, PlanFault::none);
}

TEST(GridPlanner, TakesTheNearestOfSeveralGoals) {
  DenseGrid<CellState> map = free_map(60, 20);
  const CostMap costs = costs_of(map);
  const PlanGoal goals[] = {{{5.5, 1.0}, 0.0}, {{std::nan(""), 0.0}, 0.0}, {{2.0, 1.0}, 0.0}, {{9.0, 9.0}, 0.0}};
  for (const SearchOrder order : {SearchOrder::a_star, SearchOrder::dijkstra}) {
    const Plan plan = GridPlanner({.order = order}).plan(costs, {1.0, 1.0}, goals);
    ASSERT_EQ(plan.fault, PlanFault::none);
    EXPECT_EQ(plan.goal, 2U);
    EXPECT_EQ(plan.path.back(), goals[2].place);
  }
}

TEST(GridPlanner, ReachesAGoalBesideAWallOnItsOwnSide) {
  DenseGrid<CellState> map = free_map(40, 40);
  occupy(map, {{2.0, 0.0}, {2.1, 3.0}});
  const CostMap costs = costs_of(map, 0.3);
  const PlanGoal goals[] = {{{2.15, 1.0}, 0.5}};
  const Plan plan = GridPlanner().plan(costs, {0.55, 1.0}, goals);
  ASSERT_EQ(plan.fault, PlanFault::none);
  EXPECT_GT(plan.path.back().x, 2.1) << "what is behind the wall is near but not there";
  EXPECT_LE(norm(plan.path.back() - goals[0].place), 0.5);
}

TEST(GridPlanner, OptionsAreLegal) {
  EXPECT_TRUE(validate(GridPlannerOptions{}));
  EXPECT_TRUE(validate(CostMapOptions{}));
  EXPECT_FALSE(validate(GridPlannerOptions{.escape_m = -1.0}));
  EXPECT_EQ(to_text(option_values(GridPlannerOptions{.order = SearchOrder::depth_first}).at("order")), "depth_first");
}

struct Problem {
  DenseGrid<CellState> map;
  CostMap costs;
  Vec2 start;
  Vec2 goal;
};

Problem random_problem(std::uint64_t seed) {
  Rng rng(seed);
  const DenseGrid<CellState> map = random_map(rng);
  const CostMapOptions options{.clearance_weight = rng.uniform(0.0, 5.0), .unknown_passable = rng.uniform() < 0.5};
  const double radius_m = rng.uniform() < 0.3 ? 0.0 : rng.uniform(0.0, 0.4);
  return {map, costs_of(map, radius_m, options), random_place(rng, map), random_place(rng, map)};
}

bool starts_free(const Problem& problem) {
  return problem.costs.cost_per_m().at(problem.map.geometry().cell_of(problem.start)) > 0.0F;
}

RC_GTEST_PROP(GridPlannerProperty, CostsWhatTheSlowFormCosts, (std::uint64_t seed)) {
  const Problem problem = random_problem(seed);
  if (!starts_free(problem)) return;
  const double cost_m = slow_cost(problem.costs, problem.start, problem.goal);
  for (const SearchOrder order : {SearchOrder::a_star, SearchOrder::dijkstra, SearchOrder::depth_first}) {
    const Plan plan = planned(problem.costs, problem.start, problem.goal, {.order = order, .escape_m = 0.0});
    RC_ASSERT((plan.fault == PlanFault::none) == std::isfinite(cost_m));
    if (plan.fault != PlanFault::none) continue;
    if (order == SearchOrder::depth_first)
      RC_ASSERT(plan.cost_m > cost_m - 1e-4 * (1.0 + cost_m));
    else
      RC_ASSERT(std::abs(plan.cost_m - cost_m) < 1e-4 * (1.0 + cost_m));
  }
}

RC_GTEST_PROP(GridPlannerProperty, NeverCrossesInflatedObstacles, (std::uint64_t seed)) {
  const Problem problem = random_problem(seed);
  for (const SearchOrder order : {SearchOrder::a_star, SearchOrder::dijkstra, SearchOrder::depth_first}) {
    const Plan plan = planned(problem.costs, problem.start, problem.goal, {.order = order});
    if (plan.fault != PlanFault::none) {
      RC_ASSERT(plan.path.empty());
      continue;
    }
    RC_ASSERT(plan.path.front() == problem.start);
    RC_ASSERT(plan.path.back() == problem.goal);
    if (!starts_free(problem)) RC_ASSERT(plan.escape > 0U);
    for (std::size_t k = plan.escape; k + 1 < plan.path.size(); ++k)
      for (double t = 0.0; t <= 1.0; t += 1.0 / 64.0) {
        const Vec2 p = plan.path[k] + t * (plan.path[k + 1] - plan.path[k]);
        const Cell c = problem.map.geometry().cell_of(p);
        RC_ASSERT(problem.map.box().contains(c));
        RC_ASSERT(problem.costs.cost_per_m().at(c) > 0.0F);
        RC_ASSERT(double(problem.costs.clearance_m().at(c)) >= float(problem.costs.inflation_m()));
      }
  }
}

RC_GTEST_PROP(GridPlannerProperty, StraighteningIsNeverLongerNorDearer, (std::uint64_t seed)) {
  const Problem problem = random_problem(seed);
  const Plan straight = planned(problem.costs, problem.start, problem.goal);
  const Plan cells = planned(problem.costs, problem.start, problem.goal, {.straighten = false});
  RC_ASSERT(straight.fault == cells.fault);
  RC_ASSERT(length_m(straight.path) <= length_m(cells.path) + 1e-9);
  if (straight.fault != PlanFault::none) return;
  const auto after_escape = [](const Plan& plan) { return std::span(plan.path).subspan(plan.escape); };
  const auto straight_m = path_cost(problem.costs.cost_per_m(), after_escape(straight));
  const auto cells_m = path_cost(problem.costs.cost_per_m(), after_escape(cells));
  RC_ASSERT(straight_m.has_value() && cells_m.has_value());
  RC_ASSERT(*straight_m <= *cells_m * (1.0 + 1e-6) + 1e-9);
}

RC_GTEST_PROP(GridPlannerProperty, SpreadOverCallsAndRepeatedItIsTheSame, (std::uint64_t seed)) {
  const Problem problem = random_problem(seed);
  GridPlanner planner;
  const Plan whole = planner.plan(problem.costs, problem.start, problem.goal);
  const PlanGoal goals[] = {{problem.goal, 0.0}};
  planner.begin(problem.costs, problem.start, goals);
  std::size_t calls = 0;
  while (!planner.advance(7)) RC_ASSERT(++calls < 10'000U);
  RC_ASSERT(planner.result().path == whole.path);
  RC_ASSERT(planner.result().fault == whole.fault);
  RC_ASSERT(planner.result().expanded == whole.expanded);
}

}  // namespace
}  // namespace echoarc::nav
