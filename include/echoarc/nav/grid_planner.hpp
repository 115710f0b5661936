// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/nav/cost_map.hpp"

namespace echoarc::nav {

/// Why there is no way.
enum class PlanFault : std::uint8_t {
  none,
  no_map,
  bad_start,
  start_off_map,
  boxed_in,
  bad_goal,
  goal_off_map,
  goal_in_wall,
  unreachable
};
[[nodiscard]] std::string_view text(PlanFault fault);  ///< for people: "the goal is in a wall"

enum class SearchOrder : std::uint8_t { a_star, dijkstra, depth_first };
constexpr std::array<Choice<SearchOrder>, 3> choices(SearchOrder) {
  return {{{SearchOrder::a_star, "a_star"},
           {SearchOrder::dijkstra, "dijkstra"},
           {SearchOrder::depth_first, "depth_first"}}};
}

struct GridPlannerOptions {
  SearchOrder order = SearchOrder::a_star;
  double escape_m = 1.0;
  bool straighten = true;

  static constexpr auto fields() {
    using O = GridPlannerOptions;
    return std::tuple{field("order", &O::order,
                            {.doc = "of the search: a_star and dijkstra give the cheapest way, depth_first gives any",
                             .source = "[Yamauchi97]"}),
                      field("escape_m", &O::escape_m,
                            {.unit = "m",
                             .min = 0.0,
                             .max = 10.0,
                             .doc = "the longest way out of where the robot cannot be or is shut in"}),
                      field("straighten", &O::straighten, {.doc = "whether a way is shortened by line of sight"})};
  }
};

/// Where to go: the cell of `place`, or, if the robot cannot be there, a cell within `reach_m` that has it in sight.
struct PlanGoal {
  Vec2 place;
  double reach_m = 0.0;
};

struct Plan {
  PlanFault fault = PlanFault::none;
  std::vector<Vec2> path;    ///< from the start's place on, world, m; empty if there is none
  std::size_t escape = 0;    ///< the first points of the path that lie where the robot cannot be
  double cost_m = 0.0;       ///< of the way from cell to cell, before it was straightened, without the escape
  std::size_t goal = 0;      ///< which of the goals was reached
  std::size_t expanded = 0;  ///< cells
};

/// The cheapest way over the 8 neighbours of cells to one of several goals. A step costs its length times the mean cost
/// per metre of both cells; one across a corner needs both cells beside it passable. A search can be spread over
/// several calls: it works on a copy of the costs, so that the map may change meanwhile.
class GridPlanner {
 public:
  explicit GridPlanner(const GridPlannerOptions& options = {}) : options_(options) {}

  void begin(const CostMap& map, Vec2 start, std::span<const PlanGoal> goals);
  /// Looks at so many more cells; whether the search is over.
  bool advance(std::size_t expansions);
  [[nodiscard]] bool done() const { return done_; }
  /// Once it is over.
  [[nodiscard]] const Plan& result() const { return plan_; }

  /// All at once.
  [[nodiscard]] Plan plan(const CostMap& map, Vec2 start, Vec2 goal);
  [[nodiscard]] Plan plan(const CostMap& map, Vec2 start, std::span<const PlanGoal> goals);

 private:
  struct Node {
    float cost = 0.0F;
    std::uint32_t search = 0;  // the search that wrote it; others are as good as unwritten
    std::uint8_t from = 0;     // the step that led here
    bool closed = false;
    bool goal = false;
  };
  struct Open {
    float estimate = 0.0F;  // of the whole way through the cell
    std::uint32_t index = 0;
  };
  struct Candidate {
    std::uint32_t index = 0;
    Cell cell;
    float cost = 0.0F;
    std::uint8_t step = 0;
  };
  struct GoalCell {
    std::uint32_t index = 0;
    std::size_t number = 0;  // of the goal
  };

  void prepare(const CostMap& map);
  [[nodiscard]] std::optional<Cell> depart(const CostMap& map, Cell start);
  [[nodiscard]] bool admit_goals(const CostMap& map, std::span<const PlanGoal> goals);
  bool mark_goal(const CostMap& map, std::size_t number, const PlanGoal& goal);
  void mark_cell(Cell c, std::size_t number);
  void expand(std::uint32_t index);
  void open(const Candidate& candidate);
  [[nodiscard]] float estimate(Cell c) const;
  [[nodiscard]] Node& node(std::uint32_t index);
  [[nodiscard]] std::uint32_t index_of(Cell c) const;
  [[nodiscard]] Cell cell_of(std::uint32_t index) const;
  void finish(std::uint32_t index);
  void fail(PlanFault fault);

  GridPlannerOptions options_;
  DenseGrid<float> cost_per_m_;  // a copy
  std::vector<Node> nodes_;
  std::vector<Open> open_;  // a heap, or a stack for depth_first
  std::uint32_t search_ = 0;
  std::array<float, 8> step_m_{};
  Vec2 start_;
  Cell start_cell_;           // the first that is passable
  std::vector<Vec2> escape_;  // from the start to the last point where the robot cannot be
  bool left_surroundings_ = false;
  std::vector<Vec2> goals_;
  std::vector<GoalCell> goal_cells_;
  CellBox goal_box_;  // of all goal cells
  Plan plan_;
  bool done_ = true;
};

}  // namespace echoarc::nav
