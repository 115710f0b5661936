// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"

namespace echoarc::nav {

enum class VoronoiNodeType {
  meet,      ///< equidistant to three obstacles or more
  boundary,  ///< an edge ends here: it gets too narrow for the body, or a dead end stands ahead
  pass       ///< somewhere on an edge that closes on itself and so has no other node
};
[[nodiscard]] std::string_view name(VoronoiNodeType type);  ///< "meet", "boundary", "pass"

/// A way out of a node. Ways are kept in order of bearing, counter-clockwise from -pi: the cyclic order of the edges.
struct VoronoiWay {
  Angle bearing;            ///< world, in (-pi, pi]
  std::optional<int> edge;  ///< its id, once it is known
  bool given_up = false;    ///< found to be inaccessible
};

struct VoronoiNode {
  int id = 0;  ///< its index
  Vec2 place;  ///< world, m
  VoronoiNodeType type = VoronoiNodeType::meet;
  double distance_m = 0.0;  ///< to the nearest obstacles
  std::vector<VoronoiWay> ways;
  [[nodiscard]] int degree() const { return int(ways.size()); }
};

struct VoronoiEdge {
  int id = 0;  ///< its index
  int from = 0;
  int to = 0;
  std::vector<Vec2> polyline;  ///< world, m; begins at node `from` and ends at node `to`
  double min_clearance_m = 0.0;
  double length_m = 0.0;
};

/// When a node that was met is one that is known.
struct NodeMatching {
  double radius_m = 0.5;
  double distance_m = 0.10;  ///< largest difference of the distances to the obstacles, where the places agree
  double slope = 0.5;        ///< and so much more per metre between the places: as distances to walls may change
};

/// What is met of a node, as it is added or looked for.
struct NodeSight {
  Vec2 place;
  VoronoiNodeType type = VoronoiNodeType::meet;
  double distance_m = 0.0;
  std::vector<Angle> ways;      ///< bearings, any order
  std::vector<Vec2> closest{};  ///< of its obstacles, world, m
};

/// A way over the graph: straight onto it, along its edges, straight off it.
struct GraphWay {
  std::vector<Vec2> path;  ///< from the start to the goal, world, m
  double length_m = 0.0;
  std::size_t access_index = 0;  ///< path[access_index] is the first place on the graph
  std::size_t depart_index = 0;  ///< and this the last
};

/// Whether a straight drive between two places is free of obstacles.
using FreeLine = std::function<bool(Vec2, Vec2)>;

[[nodiscard]] double polyline_length_m(std::span<const Vec2> polyline);

/// A generalised Voronoi graph of the plane: places equidistant to two obstacles as edges, to three as nodes,
/// [Choset03] V.
class VoronoiGraph {
 public:
  [[nodiscard]] const std::vector<VoronoiNode>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<VoronoiEdge>& edges() const { return edges_; }

  /// Returns its id. Bearings are wrapped and sorted.
  int add_node(const NodeSight& sight);
  /// From the given way of one node to the given way of another (or the same). The ends of the polyline are drawn to
  /// the nodes. Returns its id.
  int add_edge(int from, std::size_t from_way, int to, std::size_t to_way, std::vector<Vec2> polyline,
               double min_clearance_m);
  void give_up(int node, std::size_t way) { nodes_[std::size_t(node)].ways[way].given_up = true; }
  /// Adds the bearings that are further than `apart` from every known way of the node.
  void add_ways(int node, std::span<const Angle> bearings, Angle apart);
  /// The way nearest to a bearing, unexplored ones first within `tolerance`; none if the node has no way.
  [[nodiscard]] std::optional<std::size_t> way_towards(int node, Angle bearing, Angle tolerance) const;
  /// Adds a way to a node; returns its index. Indices of ways after it move up by one.
  std::size_t add_way(int node, Angle bearing);

  /// The known meet point that the sight is, nearest first. The degree is not held against it: a way may have been
  /// overlooked, and is added when it is seen. Boundary points are ends of a single edge and never
  /// matched.
  [[nodiscard]] std::optional<int> match(const NodeSight& sight, const NodeMatching& matching = {}) const;

  [[nodiscard]] static bool unexplored(const VoronoiWay& way) { return !way.edge && !way.given_up; }
  [[nodiscard]] bool has_unexplored(int node) const;

  /// Nodes on the shortest way (Dijkstra over lengths) and the edges between them.
  struct NodePath {
    std::vector<int> nodes;  ///< at least one
    std::vector<int> edges;  ///< one less
    double length_m = 0.0;
  };
  [[nodiscard]] std::optional<NodePath> shortest_path(int from, int to) const;
  /// To the nearest node with an unexplored way, by length.
  [[nodiscard]] std::optional<NodePath> nearest_unexplored(int from) const;
  /// The polylines of such a path as one.
  [[nodiscard]] std::vector<Vec2> polyline(const NodePath& path) const;

  /// Between any two places: onto the nearest place of the graph that a free line leads to, along it, off again, as
  /// [Choset03] V reduces planning to the graph. Without `free` every line is free.
  [[nodiscard]] Result<GraphWay> plan(Vec2 start, Vec2 goal, const FreeLine& free = {}) const;

 private:
  [[nodiscard]] std::optional<NodePath> search(int from, const std::function<bool(int)>& is_goal) const;
  std::vector<VoronoiNode> nodes_;
  std::vector<VoronoiEdge> edges_;
};

}  // namespace echoarc::nav
