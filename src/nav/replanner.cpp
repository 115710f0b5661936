// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/replanner.hpp"

#include <algorithm>
#include <utility>

#include "echoarc/nav/path.hpp"

namespace echoarc::nav {
namespace {

/// How far along its path a plan leads out of where the robot cannot be.
double escape_end_of(const Plan& plan) {
  return plan.escape == 0 ? 0.0 : length_m(std::span(plan.path).first(plan.escape + 1));
}

PathFollower::Sight sight(const CostMap& map) {
  return [&map](Vec2 a, Vec2 b) { return straight_cost(map.cost_per_m(), a, b).has_value(); };
}

}  // namespace

void Replanner::set_goals(std::vector<PlanGoal> goals) {
  goals_ = std::move(goals);
  drop_path();
  searching_ = false;
  state_ = goals_.empty() ? State::idle : State::planning;
}

void Replanner::set_path(const PlanGoal& goal, const Plan& plan, double time_s) {
  set_goals({goal});
  follower_.follow(plan.path);
  escape_end_m_ = escape_end_of(plan);
  goal_ = 0;
  planned_s_ = time_s;
  state_ = State::ready;
}

void Replanner::update(const CostMap& map, const Pose2& T_world_base, double time_s) {
  if (state_ == State::idle) return;
  if (state_ == State::ready) follow(map, T_world_base);
  const double waited_s = time_s - planned_s_;
  const bool due = state_ == State::planning || (state_ == State::ready && waited_s >= options_.period_s) ||
                   (state_ == State::failed && waited_s >= retry_s);
  if (!searching_ && due) {
    planner_.begin(map, T_world_base.position, goals_);
    planned_s_ = time_s;
    searching_ = true;
  }
  if (searching_) search(map, T_world_base, time_s);
}

void Replanner::follow(const CostMap& map, const Pose2& T_world_base) {
  following_ = follower_.update(T_world_base, sight(map));
  const bool off_path = following_.off_path_m > options_.off_path_m;
  const bool cut =
      checked_version_ != map.version() && is_cut(map, follower_.path(), std::max(follower_.along_m(), escape_end_m_));
  checked_version_ = map.version();
  if (cut) ++cuts_;
  if (!cut && !off_path) return;
  drop_path();
  searching_ = false;  // what is being planned began elsewhere, or with costs that no longer hold
  state_ = State::planning;
}

void Replanner::search(const CostMap& map, const Pose2& T_world_base, double time_s) {
  if (!planner_.advance(std::size_t(options_.expansions))) return;
  searching_ = false;
  ++plans_;
  planned_s_ = time_s;
  const Plan& plan = planner_.result();
  fault_ = plan.fault;
  if (plan.fault != PlanFault::none) {
    drop_path();
    state_ = State::failed;
    return;
  }
  const double escape_end_m = escape_end_of(plan);
  if (is_cut(map, plan.path, escape_end_m)) {  // by what the map has come to show meanwhile: once more
    if (state_ != State::ready) state_ = State::planning;
    return;
  }
  goal_ = plan.goal;
  follower_.follow(plan.path);
  escape_end_m_ = escape_end_m;
  state_ = State::ready;
  following_ = follower_.update(T_world_base, sight(map));
}

/// Whether the path from `along_m` on leads where the robot cannot be. It may begin there: that is the way out.
bool Replanner::is_cut(const CostMap& map, std::span<const Vec2> path, double along_m) const {
  const auto& cost_per_m = map.cost_per_m();
  const double step_m = map.geometry().cell_m;
  const double longest_m = along_m + escape_m_ + step_m;
  double begin_m = along_m;
  Vec2 from = point_at(path, begin_m);
  while (begin_m < longest_m && !straight_cost(cost_per_m, from, from)) from = point_at(path, begin_m += step_m);
  double leg_end_m = 0.0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    leg_end_m += norm(path[k + 1] - path[k]);
    if (leg_end_m < begin_m) continue;
    if (!straight_cost(cost_per_m, from, path[k + 1])) return true;
    from = path[k + 1];
  }
  return !straight_cost(cost_per_m, from, from).has_value();
}

void Replanner::drop_path() {
  follower_.follow({});
  escape_end_m_ = 0.0;
  following_ = {};
  checked_version_.reset();
}

}  // namespace echoarc::nav
