// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/nav/cost_map.hpp"
#include "echoarc/nav/grid_planner.hpp"
#include "echoarc/nav/path_follower.hpp"

namespace echoarc::nav {

struct ReplannerOptions {
  double period_s = 5.0;
  double off_path_m = 0.75;
  int expansions = 10'000;

  static constexpr auto fields() {
    using O = ReplannerOptions;
    return std::tuple{
        field("period_s", &O::period_s,
              {.unit = "s", .min = 0.1, .max = 3600.0, .doc = "between plans while the path is clear"}),
        field("off_path_m", &O::off_path_m,
              {.unit = "m", .min = 0.05, .max = 100.0, .doc = "further than this from its path a robot needs another"}),
        field("expansions", &O::expansions,
              {.unit = "cells", .min = 100, .max = 100'000'000, .doc = "looked at in one step of control"})};
  }
};

/// Keeps a way to a goal while robot and map change: plans when there is no path, when the map has come to cut it, when
/// the robot has left it, and every `period_s`; a clear path is driven on while the next is planned. A plan that takes
/// long is spread over several steps.
class Replanner {
 public:
  enum class State : std::uint8_t { idle, planning, ready, failed };

  Replanner(const ReplannerOptions& options, const GridPlannerOptions& planner, const PathFollowerOptions& follower)
      : options_(options), escape_m_(planner.escape_m), planner_(planner), follower_(follower) {}

  /// Another goal, or several of which the cheapest to reach is taken; drops the path.
  void set_goals(std::vector<PlanGoal> goals);
  /// Takes a path that somebody else planned to `goal`.
  void set_path(const PlanGoal& goal, const Plan& plan, double time_s);
  void update(const CostMap& map, const Pose2& T_world_base, double time_s);

  /// `ready`: there is a path. `failed`: there is none at present; it is tried again every `retry_s`.
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] PlanFault fault() const { return fault_; }                 ///< of `failed`
  [[nodiscard]] const Following& following() const { return following_; }  ///< of `ready`
  [[nodiscard]] const std::vector<Vec2>& path() const { return follower_.path(); }
  [[nodiscard]] std::size_t goal() const { return goal_; }    ///< number of the path's goal
  [[nodiscard]] std::size_t plans() const { return plans_; }  ///< that were made
  [[nodiscard]] std::size_t cuts() const { return cuts_; }    ///< paths that the map came to cut
  static constexpr double retry_s = 0.5;

 private:
  void follow(const CostMap& map, const Pose2& T_world_base);
  void search(const CostMap& map, const Pose2& T_world_base, double time_s);
  [[nodiscard]] bool is_cut(const CostMap& map, std::span<const Vec2> path, double along_m) const;
  void drop_path();

  ReplannerOptions options_;
  double escape_m_;
  GridPlanner planner_;
  PathFollower follower_;
  double escape_end_m_ = 0.0;  // up to there the path leads out of where the robot cannot be
  std::vector<PlanGoal> goals_;
  State state_ = State::idle;
  PlanFault fault_ = PlanFault::none;
  Following following_;
  std::size_t goal_ = 0;
  std::size_t plans_ = 0;
  std::size_t cuts_ = 0;
  bool searching_ = false;
  double planned_s_ = 0.0;  // when the last plan was begun
  std::optional<std::uint64_t> checked_version_;
};

}  // namespace echoarc::nav
