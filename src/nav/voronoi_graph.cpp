// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_graph.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace echoarc::nav {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool by_bearing(const VoronoiWay& a, const VoronoiWay& b) {
  return a.bearing < b.bearing;
}

}  // namespace

std::string_view name(VoronoiNodeType type) {
  constexpr std::array<std::string_view, 3> names{"meet", "boundary", "pass"};
  return names[static_cast<std::size_t>(type)];
}

double polyline_length_m(std::span<const Vec2> polyline) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < polyline.size(); ++i) length_m += norm(polyline[i] - polyline[i - 1]);
  return length_m;
}

int VoronoiGraph::add_node(const NodeSight& sight) {
  VoronoiNode node{int(nodes_.size()), sight.place, sight.type, sight.distance_m, {}};
  for (const Angle bearing : sight.ways) node.ways.push_back({wrap(bearing), {}});
  std::stable_sort(node.ways.begin(), node.ways.end(), by_bearing);
  nodes_.push_back(std::move(node));
  return nodes_.back().id;
}

std::size_t VoronoiGraph::add_way(int node, Angle bearing) {
  std::vector<VoronoiWay>& ways = nodes_[std::size_t(node)].ways;
  const VoronoiWay way{wrap(bearing), {}};
  const auto place = std::upper_bound(ways.begin(), ways.end(), way, by_bearing);
  const auto index = std::size_t(place - ways.begin());
  ways.insert(place, way);
  return index;
}

void VoronoiGraph::add_ways(int node, std::span<const Angle> bearings, Angle apart) {
  for (const Angle bearing : bearings) {
    const std::vector<VoronoiWay>& ways = nodes_[std::size_t(node)].ways;
    const auto near = [&](const VoronoiWay& way) { return abs(wrap(way.bearing - bearing)) <= apart; };
    if (std::none_of(ways.begin(), ways.end(), near)) add_way(node, bearing);
  }
}

std::optional<std::size_t> VoronoiGraph::way_towards(int node, Angle bearing, Angle tolerance) const {
  const std::vector<VoronoiWay>& ways = nodes_[std::size_t(node)].ways;
  std::optional<std::size_t> best;
  std::pair<bool, Angle> best_rank;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const Angle off = abs(wrap(ways[w].bearing - bearing));
    const std::pair<bool, Angle> rank{ways[w].edge.has_value() || off > tolerance, off};
    if (!best || rank < best_rank) best = w, best_rank = rank;
  }
  return best;
}

int VoronoiGraph::add_edge(int from, std::size_t from_way, int to, std::size_t to_way, std::vector<Vec2> polyline,
                           double min_clearance_m) {
  VoronoiNode& a = nodes_[std::size_t(from)];
  VoronoiNode& b = nodes_[std::size_t(to)];
  assert(from_way < a.ways.size() && to_way < b.ways.size());
  if (polyline.empty() || polyline.front() != a.place) polyline.insert(polyline.begin(), a.place);
  if (polyline.size() < 2 || polyline.back() != b.place) polyline.push_back(b.place);
  const int id = int(edges_.size());
  const double length_m = polyline_length_m(polyline);
  edges_.push_back({id, from, to, std::move(polyline), min_clearance_m, length_m});
  a.ways[from_way].edge = id;
  b.ways[to_way].edge = id;
  return id;
}

std::optional<int> VoronoiGraph::match(const NodeSight& sight, const NodeMatching& matching) const {
  std::optional<int> best;
  double best_m = matching.radius_m;
  for (const VoronoiNode& node : nodes_) {
    if (node.type != sight.type || node.type == VoronoiNodeType::boundary) continue;
    const double apart_m = norm(node.place - sight.place);
    const double limit_m = matching.distance_m + matching.slope * apart_m;
    if (!(apart_m < best_m) || std::abs(node.distance_m - sight.distance_m) >= limit_m) continue;
    best = node.id;
    best_m = apart_m;
  }
  return best;
}

bool VoronoiGraph::has_unexplored(int node) const {
  const std::vector<VoronoiWay>& ways = nodes_[std::size_t(node)].ways;
  return std::any_of(ways.begin(), ways.end(), unexplored);
}

std::optional<VoronoiGraph::NodePath> VoronoiGraph::search(int from, const std::function<bool(int)>& is_goal) const {
  std::vector<double> length_m(nodes_.size(), infinity);
  std::vector<int> over(nodes_.size(), -1);  // edge that leads to the node
  std::vector<std::vector<int>> edges_of(nodes_.size());
  for (const VoronoiEdge& edge : edges_) {
    edges_of[std::size_t(edge.from)].push_back(edge.id);
    edges_of[std::size_t(edge.to)].push_back(edge.id);
  }
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  length_m[std::size_t(from)] = 0.0;
  open.emplace(0.0, from);
  const auto other_end = [&](int edge, int node) {
    const VoronoiEdge& e = edges_[std::size_t(edge)];
    return e.from == node ? e.to : e.from;
  };
  while (!open.empty()) {
    const auto [so_far_m, node] = open.top();
    open.pop();
    if (so_far_m > length_m[std::size_t(node)]) continue;
    if (is_goal(node)) {
      NodePath path{{node}, {}, so_far_m};
      for (int n = node; n != from; path.nodes.push_back(n)) {
        path.edges.push_back(over[std::size_t(n)]);
        n = other_end(over[std::size_t(n)], n);
      }
      std::reverse(path.nodes.begin(), path.nodes.end());
      std::reverse(path.edges.begin(), path.edges.end());
      return path;
    }
    for (const int edge : edges_of[std::size_t(node)]) {
      const int next = other_end(edge, node);
      const double next_m = so_far_m + edges_[std::size_t(edge)].length_m;
      if (next_m >= length_m[std::size_t(next)]) continue;
      length_m[std::size_t(next)] = next_m;
      over[std::size_t(next)] = edge;
      open.emplace(next_m, next);
    }
  }
  return {};
}

std::optional<VoronoiGraph::NodePath> VoronoiGraph::shortest_path(int from, int to) const {
  return search(from, [to](int node) { return node == to; });
}

std::optional<VoronoiGraph::NodePath> VoronoiGraph::nearest_unexplored(int from) const {
  return search(from, [this](int node) { return has_unexplored(node); });
}

std::vector<Vec2> VoronoiGraph::polyline(const NodePath& path) const {
  std::vector<Vec2> line{nodes_[std::size_t(path.nodes.front())].place};
  for (std::size_t i = 0; i < path.edges.size(); ++i) {
    const VoronoiEdge& edge = edges_[std::size_t(path.edges[i])];
    std::vector<Vec2> piece = edge.polyline;
    if (edge.from != path.nodes[i]) std::reverse(piece.begin(), piece.end());
    line.insert(line.end(), piece.begin() + 1, piece.end());
  }
  return line;
}

}  // namespace echoarc::nav
