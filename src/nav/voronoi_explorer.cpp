// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "nav/voronoi_explorer.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::nav {
namespace {

constexpr Angle look_rate_per_s = degrees(45.0);

}  // namespace

VoronoiExploration::Explorer::Explorer(const RobotBody& body, const VoronoiExplorationOptions& options,
                                       const TracerOptions& tracer, const ObstacleOptions& obstacles)
    : body_(body), options_(options), tracer_(body.radius_m, tracer, obstacles) {
  if (!options_.look_around) state_ = State::access;
}

std::string_view VoronoiExploration::Explorer::doing() const {
  switch (state_) {
    case State::look: return "looking around";
    case State::access: return "accessing the graph";
    case State::trace: return "tracing an edge";
    case State::settle: return "looking at a meet point";
    case State::go: return "returning to an unexplored edge";
  }
  return "";
}

Steering VoronoiExploration::Explorer::update(const Surroundings& now) {
  if (ended_) return *ended_;
  if (const std::string fault = guard_.check(now, body_.limits); !fault.empty()) fail(fault);
  if (ended_) return *ended_;
  passed_s_ = guard_.passed_s();
  total_s_ += passed_s_;
  const Vec2 place = now.T_world_base.position;
  const bool silent = std::none_of(now.points.begin(), now.points.end(), [](Vec2 p) { return is_finite(p); });
  silent_s_ = silent ? silent_s_ + passed_s_ : 0.0;
  if (silent_s_ > options_.silence_s) fail("no obstacle in view: the sensors are silent, or the place is too wide");
  if (total_s_ > options_.longest_time_s) fail("the time is up");
  if (!ended_ && watch_.is_stuck(place, passed_s_, options_.stuck_s)) unstick(now.T_world_base);
  if (ended_) return *ended_;
  Surroundings longer = now;
  longer.points = near_points_.added_to(now.points, place, now.time_s);
  const RobotVelocity wanted = act(longer);
  if (ended_) return *ended_;
  return {wanted, Status::running, std::string(doing())};
}

RobotVelocity VoronoiExploration::Explorer::act(const Surroundings& now) {
  switch (state_) {
    case State::look: return look(now);
    case State::access: return access(now);
    case State::trace: return trace(now);
    case State::settle: return settle(now);
    case State::go: return go(now);
  }
  return {};
}

void VoronoiExploration::Explorer::enter(State state, Vec2 place) {
  state_ = state;
  settled_s_ = 0.0;
  last_heading_.reset();
  turned_ = Angle{};
  watch_.restart(place);
}

RobotVelocity VoronoiExploration::Explorer::look(const Surroundings& now) {
  const Angle heading = now.T_world_base.heading;
  if (last_heading_) turned_ += abs(wrap(heading - *last_heading_));
  last_heading_ = heading;
  if (turned_ >= degrees(360.0)) {
    if (after_look_ == State::go) look_at_node(now);
    enter(after_look_, now.T_world_base.position);
    return {};
  }
  return {0.0, std::min(look_rate_per_s, body_.limits.turn_rate_per_s)};
}

RobotVelocity VoronoiExploration::Explorer::access(const Surroundings& now) {
  const Vec2 place = now.T_world_base.position;
  const AccessStep step = tracer_.access(place, now.T_world_base.heading, now.points);
  if (!step.reached) return steer_towards(now.T_world_base, step.velocity_m_s, body_, now.points);
  if (step.distance_m < tracer_.least_distance_m()) {
    fail("boxed in: the middle between the obstacles is too narrow for the body");
    return {};
  }
  departure_.reset();
  const NodeSight sight = tracer_.node_at(place, now.points);
  if (VoronoiTracer::is_node(sight)) {  // straight onto a node
    arrive(sight, now.T_world_base);
    return {};
  }
  T_world_trace_ = Pose2{place, step.direction};
  tracer_.begin(place, step.direction);
  enter(State::trace, place);
  return {};
}

RobotVelocity VoronoiExploration::Explorer::trace(const Surroundings& now) {
  const Pose2& T_world_base = now.T_world_base;
  const std::span<const Vec2> points = memory_.added_to(now.points, T_world_base.position);
  const TraceStep step = tracer_.update(T_world_base.position, passed_s_, points);
  if (step.event == TraceEvent::meet) return enter(State::settle, T_world_base.position), RobotVelocity{};
  if (step.event == TraceEvent::boundary) return end_edge(T_world_base), RobotVelocity{};
  if (step.event == TraceEvent::lost)
    return abandon("lost the edge: fewer than two obstacles in view", T_world_base), RobotVelocity{};
  if (tracer_.length_m() > options_.longest_edge_m)
    return abandon("an edge without end", T_world_base), RobotVelocity{};
  if (close_loop(T_world_base)) return {};
  return steer_towards(T_world_base, step.velocity_m_s, body_, now.points);
}

RobotVelocity VoronoiExploration::Explorer::settle(const Surroundings& now) {
  settled_s_ += passed_s_;
  if (settled_s_ < options_.settle_s) return {};
  const Vec2 place = now.T_world_base.position;
  if (const std::optional<NodeSight> sight = tracer_.meet(place, memory_.added_to(now.points, place))) {
    arrive(*sight, now.T_world_base);
  } else {  // on a second look there are no three ways
    tracer_.resume();
    enter(State::trace, place);
  }
  return {};
}

RobotVelocity VoronoiExploration::Explorer::go(const Surroundings& now) {
  const Vec2 place = now.T_world_base.position;
  const std::optional<Vec2> target = follower_.target(place);
  if (!target) {
    stuck_ = 0;
    next(target_, now.T_world_base);
    return {};
  }
  const Vec2 way = *target - place;
  // Slower towards the end of the line, so that the robot does not swing past it.
  const double speed = std::min(options_.return_speed_m_s, 0.08 + norm(way));
  return steer_towards(now.T_world_base, way * (speed / std::max(norm(way), 1e-9)), body_, now.points);
}

Sketch VoronoiExploration::Explorer::sketch() const {
  Sketch sketch;
  for (const VoronoiNode& node : graph_.nodes())
    sketch.nodes.push_back({node.place, std::string(nav::name(node.type))});
  for (const VoronoiEdge& edge : graph_.edges()) sketch.edges.push_back(edge.polyline);
  if (ended_) return sketch;
  if (state_ == State::trace || state_ == State::settle) sketch.edges.push_back(tracer_.polyline());
  if (state_ == State::go) sketch.path.assign(follower_.rest().begin(), follower_.rest().end());
  return sketch;
}

}  // namespace echoarc::nav
