// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/go_to.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace echoarc::nav {

RobotVelocity follow_velocity(const Surroundings& surroundings, const Following& following, const RobotLimits& limits,
                              const PathFollowerOptions& options, const Avoidance& avoidance) {
  const Pose2& T_world_base = surroundings.T_world_base;
  if (!avoidance) return steer_to(T_world_base, following.target, following.remaining_m, limits, options);
  RobotVelocity wanted = avoidance(surroundings, following.target);
  const double most_m_s = std::sqrt(2.0 * limits.acceleration_m_s2 * std::max(following.remaining_m, 0.0));
  if (wanted.forward_m_s <= most_m_s) return wanted;
  const double slower = most_m_s / wanted.forward_m_s;  // on the same arc
  return {most_m_s, slower * wanted.turn_per_s};
}

GoTo::GoTo(std::vector<Vec2> goals, const RobotBody& body, const GoToOptions& options, Avoidance avoidance,
           std::string_view name)
    : goals_(std::move(goals)),
      body_(body),
      options_(options),
      avoidance_(std::move(avoidance)),
      name_(name),
      pose_watch_(body.limits),
      map_(options.map, body.radius_m),
      replanner_(options.replanner, options.planner, options.follower),
      progress_(options.no_progress_s),
      recovery_(body, options.recovery) {
  if (!goals_.empty()) head_for(0);
}

Steering GoTo::update(const Surroundings& surroundings) {
  if (ended_) return *ended_;
  if (std::string fault = pose_watch_.fault(surroundings); !fault.empty()) return end(Status::failed, std::move(fault));
  if (goals_.empty()) return end(Status::finished, "there is no goal");
  if (!is_finite(goals_[goal_])) return end(Status::failed, std::string(text(PlanFault::bad_goal)));
  if (surroundings.map == nullptr || surroundings.map->empty()) return wait(surroundings.time_s, PlanFault::no_map);
  if (map_version_ != surroundings.map_version) map_.update(*surroundings.map);
  map_version_ = surroundings.map_version;
  const Vec2 here = surroundings.T_world_base.position;
  map_.drive_through(std::exchange(here_, here).value_or(here), here);
  replanner_.update(map_, surroundings.T_world_base, surroundings.time_s);
  switch (replanner_.state()) {
    case Replanner::State::failed: return wait(surroundings.time_s, replanner_.fault());
    case Replanner::State::ready: return go(surroundings);
    default: return plan(surroundings.time_s);
  }
}

/// A search takes several steps, but not for ever, as it would if the map cut every path while it was planned.
Steering GoTo::plan(double time_s) {
  if (!planning_since_s_) planning_since_s_ = time_s;
  if (time_s - *planning_since_s_ > options_.no_progress_s) return end(Status::failed, "planning comes to no end");
  return {{}, Status::running, "planning"};
}

Steering GoTo::go(const Surroundings& surroundings) {
  without_way_s_.reset();
  planning_since_s_.reset();
  const Following& following = replanner_.following();
  if (following.arrived) return arrive();
  if (progress_.stalled(surroundings.time_s, following.remaining_m)) return end(Status::failed, "it gets no nearer");
  const RobotVelocity wanted = follow_velocity(surroundings, following, body_.limits, options_.follower, avoidance_);
  if (const auto recovering = recovery_.update(surroundings, wanted)) {
    if (recovering->status == Status::running) return *recovering;
    return end(recovering->status, recovering->reason);
  }
  return {wanted, Status::running, "going to the goal"};
}

/// The map may come, or come to show a way, as more is heard: a ghost that one sensor hears is heard through by the
/// others as the robot turns round.
Steering GoTo::wait(double time_s, PlanFault fault) {
  if (!without_way_s_) without_way_s_ = time_s;
  const double waited_s = time_s - *without_way_s_;
  const double turning_s = options_.look_around ? 2.0 * std::numbers::pi / options_.look_around_per_s.rad() : 0.0;
  if (waited_s >= turning_s + options_.patience_s) return end(Status::failed, std::string(text(fault)));
  if (waited_s < turning_s)
    return {{0.0, options_.look_around_per_s}, Status::running, std::string(text(fault)) + ", looking around"};
  return {{}, Status::running, std::string(text(fault)) + ", waiting"};
}

Steering GoTo::arrive() {
  if (goal_ + 1 == goals_.size()) return end(Status::finished, "arrived");
  head_for(goal_ + 1);
  return {{}, Status::running, "going to the next goal"};
}

void GoTo::head_for(std::size_t goal) {
  goal_ = goal;
  replanner_.set_goals({{goals_[goal], 0.0}});
  progress_.reset();
}

Steering GoTo::end(Status status, std::string reason) {
  ended_ = Steering{{}, status, std::move(reason), {}};
  return *ended_;
}

Sketch GoTo::sketch() const {
  Sketch sketch;
  for (std::size_t k = goal_; k < goals_.size(); ++k)
    if (is_finite(goals_[k])) sketch.nodes.push_back({goals_[k], "goal"});
  sketch.path = replanner_.path();
  return sketch;
}

}  // namespace echoarc::nav
