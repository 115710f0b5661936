// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/frontier_exploration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace echoarc::nav {
namespace {

// Half of what the motors can do: sonars fire one after the other.
constexpr double sweep_share = 0.5;
// So often a frontier may go and come again.
constexpr int most_returns = 2;

std::size_t least_cells(const FrontierExplorationOptions& options, double cell_m) {
  return std::size_t(std::max(1.0, std::ceil(options.least_size_m / cell_m)));
}

}  // namespace

FrontierExploration::FrontierExploration(const RobotBody& body, const FrontierExplorationOptions& options,
                                         Avoidance avoidance)
    : body_(body),
      options_(options),
      avoidance_(std::move(avoidance)),
      pose_watch_(body.limits),
      map_(options.map, body.radius_m),
      chooser_({.order = SearchOrder::dijkstra}),
      replanner_(options.replanner, {}, options.follower),
      progress_(options.no_progress_s),
      recovery_(body, options.recovery) {
  if (options_.sweep_at_start) begin_sweep();
}

Steering FrontierExploration::update(const Surroundings& surroundings) {
  if (ended_) return *ended_;
  if (std::string fault = pose_watch_.fault(surroundings); !fault.empty()) return end(Status::failed, std::move(fault));
  if (surroundings.map == nullptr || surroundings.map->empty()) return conclude(surroundings, PlanFault::no_map);
  see(surroundings);
  switch (phase_) {
    case Phase::sweeping: return sweep(surroundings);
    case Phase::choosing: return choose(surroundings);
    case Phase::driving: return drive(surroundings);
  }
  return {};
}

void FrontierExploration::see(const Surroundings& surroundings) {
  CellBox changed;
  const bool first = map_.empty();
  if (map_version_ != surroundings.map_version) changed = map_.update(*surroundings.map);
  map_version_ = surroundings.map_version;
  if (first) {
    finder_ = FrontierFinder(least_cells(options_, map_.geometry().cell_m));
    nothing_since_s_.reset();
  }
  const Vec2 here = surroundings.T_world_base.position;
  changed = unite(changed, map_.drive_through(std::exchange(here_, here).value_or(here), here));
  finder_.update(map_.cells(), changed);
}

Steering FrontierExploration::sweep(const Surroundings& surroundings) {
  const Angle heading = surroundings.T_world_base.heading;
  if (last_heading_) swept_ += wrap(heading - *last_heading_);
  last_heading_ = heading;
  if (!sweeping_since_s_) sweeping_since_s_ = surroundings.time_s;
  const Angle rate_per_s = sweep_share * body_.limits.turn_rate_per_s;
  const double allowed_s = 2.0 * degrees(360.0) / rate_per_s + options_.patience_s;
  if (swept_ < degrees(360.0) && surroundings.time_s - *sweeping_since_s_ < allowed_s)
    return {{0.0, rate_per_s}, Status::running, "looking about"};
  phase_ = Phase::choosing;
  return choose(surroundings);
}

void FrontierExploration::begin_sweep() {
  phase_ = Phase::sweeping;
  swept_ = {};
  last_heading_.reset();
  sweeping_since_s_.reset();
}

/// Drives on along the path there is while it searches.
Steering FrontierExploration::choose(const Surroundings& surroundings) {
  if (!choosing_) {
    choice_ = candidates();
    if (choice_.empty()) return conclude(surroundings, PlanFault::none);
    chooser_.begin(map_, surroundings.T_world_base.position, choice_);
    choosing_ = true;
  }
  if (!chooser_.advance(std::size_t(options_.replanner.expansions))) {
    replanner_.update(map_, surroundings.T_world_base, surroundings.time_s);
    if (replanner_.following().arrived) replanner_.set_goals({});
    return steer(surroundings, "choosing a frontier");
  }
  choosing_ = false;
  const Plan& plan = chooser_.result();
  if (plan.fault == PlanFault::none) return go_to(choice_[plan.goal], plan, surroundings);
  // Where no region can be reached at its middle, one may still be at another of its cells.
  if (!std::exchange(thorough_, true)) return {{}, Status::running, "choosing a frontier"};
  return conclude(surroundings, plan.fault);
}

Steering FrontierExploration::go_to(const PlanGoal& target, const Plan& plan, const Surroundings& surroundings) {
  thorough_ = false;
  nothing_since_s_.reset();
  cut_off_since_s_.reset();
  target_ = target;
  replanner_.set_path(target, plan, surroundings.time_s);
  progress_.reset();
  phase_ = Phase::driving;
  return drive(surroundings);
}

/// There is nowhere to go; true only if it holds for a while, for a map of sonar readings flickers.
Steering FrontierExploration::conclude(const Surroundings& surroundings, PlanFault fault) {
  replanner_.set_goals({});
  if (!nothing_since_s_) nothing_since_s_ = surroundings.time_s;
  if (surroundings.time_s - *nothing_since_s_ < options_.patience_s)
    return {{}, Status::running, "no frontier to go to, waiting"};
  const bool begun = !visited_.empty() || !inaccessible_.empty();
  const bool lost = fault == PlanFault::no_map || fault == PlanFault::start_off_map;
  if (lost || (fault == PlanFault::boxed_in && !begun)) return end(Status::failed, std::string(text(fault)));
  if (std::ranges::find(surroundings.map->values(), CellState::free) == surroundings.map->values().end())
    return end(Status::failed, "the map shows nothing free");
  const bool rest = std::ranges::any_of(finder_.frontiers(), [&](const Frontier& frontier) {
    return !near_any(visited_, map_.geometry().centre(frontier.target));
  });
  return end(Status::finished, rest ? "the rest is inaccessible" : "no frontier is left");
}

Steering FrontierExploration::drive(const Surroundings& surroundings) {
  if (options_.leave_seen && !still_there(target_->place)) {
    leave_seen_target();
    return choose(surroundings);
  }
  replanner_.update(map_, surroundings.T_world_base, surroundings.time_s);
  if (replanner_.state() != Replanner::State::ready) return wait_for_way(surroundings.time_s);
  cut_off_since_s_.reset();
  if (replanner_.following().arrived) {
    reach_target();
    return {{}, Status::running, "at the frontier"};
  }
  if (progress_.stalled(surroundings.time_s, replanner_.following().remaining_m)) {
    give_up_target();
    return {{}, Status::running, "giving up a frontier"};
  }
  return steer(surroundings, "going to a frontier");
}

Steering FrontierExploration::wait_for_way(double time_s) {
  if (!cut_off_since_s_) cut_off_since_s_ = time_s;
  const bool failed = replanner_.state() == Replanner::State::failed;
  std::string reason = failed ? std::string(text(replanner_.fault())) : "planning";
  if (time_s - *cut_off_since_s_ >= (failed ? options_.patience_s : options_.no_progress_s)) give_up_target();
  return {{}, Status::running, std::move(reason)};
}

Steering FrontierExploration::steer(const Surroundings& surroundings, std::string reason) {
  if (replanner_.state() != Replanner::State::ready) return {{}, Status::running, std::move(reason)};
  const RobotVelocity wanted =
      follow_velocity(surroundings, replanner_.following(), body_.limits, options_.follower, avoidance_);
  const auto recovering = recovery_.update(surroundings, wanted);
  if (!recovering) return {wanted, Status::running, std::move(reason)};
  if (recovering->status == Status::running) return *recovering;
  recovery_.reset();
  give_up_target();
  return {{}, Status::running, "giving up a frontier: " + recovering->reason};
}

void FrontierExploration::give_up_target() {
  if (target_) inaccessible_.push_back(target_->place);
  target_.reset();
  replanner_.set_goals({});
  phase_ = Phase::choosing;
}

void FrontierExploration::reach_target() {
  if (target_) visited_.push_back(target_->place);
  target_.reset();
  phase_ = Phase::choosing;
  if (options_.sweep_on_arrival) begin_sweep();
}

/// One that goes and comes again is a flicker of the map and no reason to come back for ever.
void FrontierExploration::leave_seen_target() {
  if (std::ranges::count_if(seen_, [&](Vec2 place) { return norm(place - target_->place) <= options_.exclusion_m; }) >=
      most_returns)
    visited_.push_back(target_->place);
  else
    seen_.push_back(target_->place);
  target_.reset();
  phase_ = Phase::choosing;
}

bool FrontierExploration::near_any(const std::vector<Vec2>& places, Vec2 target) const {
  return std::ranges::any_of(places, [&](Vec2 place) { return norm(place - target) <= options_.exclusion_m; });
}

bool FrontierExploration::still_there(Vec2 target) const {
  const GridGeometry& geometry = map_.geometry();
  return std::ranges::any_of(finder_.frontiers(), [&](const Frontier& frontier) {
    return std::ranges::any_of(frontier.cells,
                               [&](Cell c) { return norm(geometry.centre(c) - target) <= options_.exclusion_m; });
  });
}

/// The middle of each region, or, of a region whose middle is excluded, the cell nearest to it that is not. To be
/// thorough, cells all along the regions.
std::vector<PlanGoal> FrontierExploration::candidates() const {
  const GridGeometry& geometry = map_.geometry();
  const auto open = [&](Vec2 place) { return !near_any(visited_, place) && !near_any(inaccessible_, place); };
  std::vector<PlanGoal> goals;
  for (const Frontier& frontier : finder_.frontiers()) {
    const Vec2 middle = geometry.centre(frontier.target);
    if (!thorough_ && open(middle)) {
      goals.push_back({middle, options_.reach_m});
      continue;
    }
    std::vector<Vec2> places;
    for (const Cell c : frontier.cells)
      if (const Vec2 place = geometry.centre(c); open(place)) places.push_back(place);
    if (places.size() < least_cells(options_, geometry.cell_m)) continue;
    if (thorough_)
      for (const Vec2 place : places) goals.push_back({place, 0.0});
    else
      goals.push_back(
          {*std::ranges::min_element(places, {}, [&](Vec2 p) { return norm(p - middle); }), options_.reach_m});
  }
  return goals;
}

Steering FrontierExploration::end(Status status, std::string reason) {
  ended_ = Steering{{}, status, std::move(reason), {}};
  return *ended_;
}

Sketch FrontierExploration::sketch() const {
  Sketch sketch;
  for (const Frontier& frontier : finder_.frontiers())
    sketch.nodes.push_back({map_.geometry().centre(frontier.target), "frontier"});
  if (target_) sketch.nodes.push_back({target_->place, "goal"});
  sketch.path = replanner_.path();
  return sketch;
}

}  // namespace echoarc::nav
