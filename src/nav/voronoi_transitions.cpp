// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What happens between the states of VoronoiExploration.

#include <algorithm>
#include <numbers>

#include "nav/voronoi_explorer.hpp"

namespace echoarc::nav {
namespace {

constexpr Angle half_turn = radians(std::numbers::pi);
constexpr Angle same_way = degrees(25.0);     // bearings that differ less are one way out of a node
constexpr Angle arrival_off = degrees(60.0);  // largest error of the bearing over which a node is reached
constexpr double twin_m = 1.0;                // meet points joined by a shorter edge are one node, if they match
constexpr double depart_within_m = 0.15;      // of a node
constexpr double least_loop_m = 5.0;          // an edge back to its own node goes round something
constexpr int most_stuck = 3;

}  // namespace

std::size_t VoronoiExploration::Explorer::way_index(const Departure& departure) const {
  const std::vector<VoronoiWay>& ways = graph_.nodes()[std::size_t(departure.node)].ways;
  const auto it =
      std::find_if(ways.begin(), ways.end(), [&](const VoronoiWay& w) { return w.bearing == departure.way; });
  return std::size_t(it - ways.begin());
}

/// With a fresh view all round, ways out of a node may be seen that were not before.
void VoronoiExploration::Explorer::look_at_node(const Surroundings& now) {
  const Vec2 place = graph_.nodes()[std::size_t(target_)].place;
  if (norm(place - now.T_world_base.position) > depart_within_m) return;
  const NodeSight sight = tracer_.node_at(place, now.points);
  if (VoronoiTracer::is_node(sight)) graph_.add_ways(target_, sight.ways, same_way);
}

void VoronoiExploration::Explorer::depart(int node, const Pose2& T_world_base) {
  const VoronoiWay* best = nullptr;
  const auto turn = [&](const VoronoiWay& way) { return abs(wrap(way.bearing - T_world_base.heading)); };
  for (const VoronoiWay& way : graph_.nodes()[std::size_t(node)].ways)
    if (VoronoiGraph::unexplored(way) && (!best || turn(way) < turn(*best))) best = &way;
  departure_ = Departure{node, best->bearing};
  T_world_trace_.reset();
  tracer_.begin(T_world_base.position, best->bearing);
  enter(State::trace, T_world_base.position);
}

void VoronoiExploration::Explorer::next(int node, const Pose2& T_world_base) {
  const Vec2 here = T_world_base.position;
  const auto path = graph_.nearest_unexplored(node);
  if (!path) return finish();
  target_ = path->nodes.back();
  const std::vector<Vec2> line = graph_.polyline(*path);
  const bool is_there = target_ == node && norm(line.back() - here) < depart_within_m;
  if (is_there && !look_first_) return depart(node, T_world_base);
  follower_.begin(here, line);
  if (is_there) {
    look_first_ = false;
    after_look_ = State::go;
    return enter(State::look, here);
  }
  enter(State::go, T_world_base.position);
}

void VoronoiExploration::Explorer::arrive(const NodeSight& sight, const Pose2& T_world_base) {
  const std::optional<int> known = graph_.match(sight);
  const int node = known ? *known : graph_.add_node(sight);
  if (known) graph_.add_ways(node, sight.ways, same_way);
  memory_.remember(node, sight.place, sight.closest);
  if (departure_ && departure_->node == node && tracer_.length_m() < twin_m) {  // still about the node left behind
    tracer_.resume();
    return enter(State::trace, T_world_base.position);
  }
  if (departure_ && departure_->node == node && tracer_.length_m() < least_loop_m)
    miss();
  else
    link(node);
  next(node, T_world_base);
}

/// The way that was left by came to nothing. A second try is allowed, for a local map may mislead once.
void VoronoiExploration::Explorer::miss() {
  constexpr int most_misses = 2;
  look_first_ = true;
  if (++misses_[{departure_->node, departure_->way.rad()}] < most_misses) return;
  graph_.give_up(departure_->node, way_index(*departure_));
  ++given_up_;
}

/// Records the traced edge between the node behind and this one.
void VoronoiExploration::Explorer::link(int node) {
  if (!departure_) return;
  const int from = departure_->node;
  const Angle arrival = wrap(tracer_.direction() + half_turn);
  std::size_t way = graph_.way_towards(node, arrival, arrival_off).value_or(0);
  const std::vector<VoronoiWay>& ways = graph_.nodes()[std::size_t(node)].ways;
  const bool is_near = !ways.empty() && abs(wrap(ways[way].bearing - arrival)) <= arrival_off;
  const bool is_departure = node == from && is_near && ways[way].bearing == departure_->way;
  if (is_near && ways[way].edge) {
    const VoronoiEdge& edge = graph_.edges()[std::size_t(*ways[way].edge)];
    if (edge.from == from || edge.to == from) return graph_.give_up(from, way_index(*departure_));  // known already
  }
  if (!is_near || is_departure || ways[way].edge) way = graph_.add_way(node, arrival);
  graph_.add_edge(from, way_index(*departure_), node, way, tracer_.polyline(), tracer_.min_clearance_m());
}

/// Whether an edge from the node behind has ended here already: two bearings were taken for two ways.
bool VoronoiExploration::Explorer::is_known_end(Vec2 place) const {
  constexpr double same_m = 0.25;
  return departure_ && std::any_of(graph_.edges().begin(), graph_.edges().end(), [&](const VoronoiEdge& edge) {
           const VoronoiNode& end = graph_.nodes()[std::size_t(edge.to)];
           return edge.from == departure_->node && end.type == VoronoiNodeType::boundary &&
                  norm(end.place - place) < same_m;
         });
}

void VoronoiExploration::Explorer::end_edge(const Pose2& T_world_base) {
  if (is_known_end(T_world_base.position)) {
    graph_.give_up(departure_->node, way_index(*departure_));
    return retreat(T_world_base);
  }
  const NodeSight sight{
      T_world_base.position, VoronoiNodeType::boundary, tracer_.min_clearance_m(), {tracer_.direction() + half_turn}};
  const int node = graph_.add_node(sight);
  link(node);
  next(node, T_world_base);
}

/// An edge that no node lies on comes back to where its trace began.
bool VoronoiExploration::Explorer::close_loop(const Pose2& T_world_base) {
  if (!T_world_trace_ || tracer_.length_m() < 3.0) return false;
  if (norm(T_world_base.position - T_world_trace_->position) > 0.3) return false;
  if (abs(wrap(tracer_.direction() - T_world_trace_->heading)) > degrees(45.0)) return false;
  const Angle ahead = T_world_trace_->heading;
  const int node = graph_.add_node(
      {T_world_trace_->position, VoronoiNodeType::pass, tracer_.min_clearance_m(), {ahead, ahead + half_turn}});
  departure_ = Departure{node, wrap(ahead)};
  T_world_trace_.reset();
  link(node);
  next(node, T_world_base);
  return true;
}

/// Back along the traced line to the node behind.
void VoronoiExploration::Explorer::retreat(const Pose2& T_world_base) {
  std::vector<Vec2> back(tracer_.polyline().rbegin(), tracer_.polyline().rend());
  target_ = departure_->node;
  back.push_back(graph_.nodes()[std::size_t(target_)].place);
  follower_.begin(T_world_base.position, back);
  enter(State::go, T_world_base.position);
}

/// Leaves the edge that is traced; without a node behind, tries its other direction once.
void VoronoiExploration::Explorer::abandon(const std::string& why, const Pose2& T_world_base) {
  if (departure_) {
    miss();
    return retreat(T_world_base);
  }
  if (++reversals_ > 1) return fail(why);
  const Angle direction = wrap(tracer_.direction() + half_turn);
  T_world_trace_ = Pose2{T_world_base.position, direction};
  tracer_.begin(T_world_base.position, direction);
  enter(State::trace, T_world_base.position);
}

void VoronoiExploration::Explorer::unstick(const Pose2& T_world_base) {
  if (state_ == State::trace) return abandon("stuck on an edge", T_world_base);
  if (state_ == State::access) return fail("boxed in: no way to the middle between the obstacles");
  if (state_ == State::look) return fail("the robot does not turn");
  if (++stuck_ > most_stuck) return fail("the known way back is blocked");
  after_look_ = state_;  // a second look may clear away what blocks it
  enter(State::look, T_world_base.position);
}

void VoronoiExploration::Explorer::finish() {
  const auto& nodes = graph_.nodes();
  const auto meets =
      std::count_if(nodes.begin(), nodes.end(), [](const VoronoiNode& n) { return n.type == VoronoiNodeType::meet; });
  std::string reason = "the graph is complete: " + std::to_string(graph_.edges().size()) + " edges, " +
                       std::to_string(meets) + " meet points, " + std::to_string(nodes.size() - std::size_t(meets)) +
                       " other nodes";
  if (given_up_ > 0) reason += "; " + std::to_string(given_up_) + " ways given up";
  ended_ = Steering{{}, Status::finished, reason};
}

}  // namespace echoarc::nav
