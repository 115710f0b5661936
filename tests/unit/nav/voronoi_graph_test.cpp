// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc::nav {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

NodeSight meet(Vec2 place, std::vector<double> bearings_deg, double distance_m = 1.0) {
  NodeSight sight{place, VoronoiNodeType::meet, distance_m, {}};
  for (const double deg : bearings_deg) sight.ways.push_back(degrees(deg));
  return sight;
}

/// A square of four meet points, 2 m wide, with a tail from node 0 to the left; edge ids 0..3 round it, 4 the tail.
VoronoiGraph square_with_tail() {
  VoronoiGraph graph;
  graph.add_node(meet({0, 0}, {0, 90, 180}));
  graph.add_node(meet({2, 0}, {90, 180, -45}));
  graph.add_node(meet({2, 2}, {180, -90}));
  graph.add_node(meet({0, 2}, {-90, 0}));
  graph.add_node({{-3, 0}, VoronoiNodeType::boundary, 0.3, {Angle{}}});
  const auto way = [&](int node, double deg) { return *graph.way_towards(node, degrees(deg), degrees(5)); };
  graph.add_edge(0, way(0, 0), 1, way(1, 180), {}, 0.9);
  graph.add_edge(1, way(1, 90), 2, way(2, -90), {}, 0.8);
  graph.add_edge(2, way(2, 180), 3, way(3, 0), {{1, 2.5}}, 0.7);
  graph.add_edge(3, way(3, -90), 0, way(0, 90), {}, 0.6);
  graph.add_edge(0, way(0, 180), 4, 0, {}, 0.3);
  return graph;
}

TEST(VoronoiGraph, WaysAreInOrderOfBearing) {
  const VoronoiGraph graph = square_with_tail();
  for (const VoronoiNode& node : graph.nodes())
    EXPECT_TRUE(std::is_sorted(node.ways.begin(), node.ways.end(),
                               [](const auto& a, const auto& b) { return a.bearing < b.bearing; }));
  EXPECT_EQ(graph.nodes()[0].degree(), 3);
  EXPECT_EQ(graph.nodes()[0].ways[0].edge, 0);
  EXPECT_EQ(graph.nodes()[0].ways[1].edge, 3);
  EXPECT_EQ(graph.nodes()[0].ways[2].edge, 4);
}

TEST(VoronoiGraph, EdgesReachFromNodeToNodeWithTheirLength) {
  const VoronoiGraph graph = square_with_tail();
  for (const VoronoiEdge& edge : graph.edges()) {
    EXPECT_EQ(edge.polyline.front(), graph.nodes()[std::size_t(edge.from)].place);
    EXPECT_EQ(edge.polyline.back(), graph.nodes()[std::size_t(edge.to)].place);
    EXPECT_DOUBLE_EQ(edge.length_m, polyline_length_m(edge.polyline));
  }
  EXPECT_NEAR(graph.edges()[2].length_m, 2.0 * std::hypot(1.0, 0.5), 1e-12);
}

TEST(VoronoiGraph, MatchesByPlaceDistanceAndType) {
  const VoronoiGraph graph = square_with_tail();
  EXPECT_EQ(graph.match(meet({1.7, 0.3}, {}, 1.05)), 1);
  EXPECT_EQ(graph.match(meet({1.7, 0.3}, {}, 1.3)), 1);  // 0.42 m away it may differ by 0.31 m
  EXPECT_FALSE(graph.match(meet({1.7, 0.3}, {}, 1.35)).has_value());
  EXPECT_FALSE(graph.match(meet({2.0, 0.0}, {}, 1.11)).has_value());  // at the very place by 0.1 m
  EXPECT_FALSE(graph.match(meet({1.0, 0.99}, {}, 1.0)).has_value());  // too far away
  EXPECT_FALSE(graph.match({{-3, 0}, VoronoiNodeType::boundary, 0.3, {}}).has_value());
}

TEST(VoronoiGraph, UnexploredWaysAreFoundNearestFirst) {
  VoronoiGraph graph = square_with_tail();  // node 1 has a way without an edge
  ASSERT_TRUE(graph.nearest_unexplored(4).has_value());
  EXPECT_EQ(graph.nearest_unexplored(4)->nodes, (std::vector<int>{4, 0, 1}));
  graph.add_way(3, degrees(135));
  EXPECT_EQ(graph.nearest_unexplored(4)->nodes.back(), 1);  // 5 m; node 3 is as far but comes later
  graph.give_up(1, *graph.way_towards(1, degrees(-45), degrees(5)));
  EXPECT_EQ(graph.nearest_unexplored(4)->nodes.back(), 3);
  graph.give_up(3, *graph.way_towards(3, degrees(135), degrees(5)));
  EXPECT_FALSE(graph.nearest_unexplored(4).has_value());
}

TEST(VoronoiGraph, AddsOnlyWaysThatAreNew) {
  VoronoiGraph graph = square_with_tail();
  const std::vector<Angle> seen{degrees(85), degrees(-100), degrees(10)};
  graph.add_ways(0, seen, degrees(35));
  EXPECT_EQ(graph.nodes()[0].degree(), 4);
  EXPECT_TRUE(graph.has_unexplored(0));
}

TEST(VoronoiGraph, PathsAreJoinedInTheirDirection) {
  const VoronoiGraph graph = square_with_tail();
  const auto path = graph.shortest_path(2, 4);
  ASSERT_TRUE(path.has_value());
  const std::vector<Vec2> line = graph.polyline(*path);
  EXPECT_EQ(line.front(), (Vec2{2, 2}));
  EXPECT_EQ(line.back(), (Vec2{-3, 0}));
  EXPECT_NEAR(polyline_length_m(line), path->length_m, 1e-12);
  EXPECT_NEAR(path->length_m, 7.0, 1e-12);
}

TEST(VoronoiPlan, GoesOntoTheGraphAlongItAndOff) {
  const VoronoiGraph graph = square_with_tail();
  const auto way = graph.plan({-1, 0.5}, {2.5, 1.0});
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(way->path[way->access_index], (Vec2{-1, 0}));
  EXPECT_EQ(way->path[way->depart_index], (Vec2{2, 1}));
  EXPECT_NEAR(way->length_m, 0.5 + 1.0 + 2.0 + 1.0 + 0.5, 1e-12);
}

TEST(VoronoiPlan, StaysOnOneEdgeWhenThatIsShortest) {
  const VoronoiGraph graph = square_with_tail();
  const auto way = graph.plan({0.5, 0.1}, {1.5, -0.1});
  ASSERT_TRUE(way.has_value());
  EXPECT_NEAR(way->length_m, 0.1 + 1.0 + 0.1, 1e-12);
}

TEST(VoronoiPlan, AccessLeadsOverFreeLinesAlone) {
  const VoronoiGraph graph = square_with_tail();
  const auto right_half = [](Vec2 a, Vec2 b) { return a.x >= 1.5 && b.x >= 1.5; };
  const auto way = graph.plan({1.6, 1.0}, {1.9, 1.9}, right_half);
  ASSERT_TRUE(way.has_value());
  EXPECT_GE(way->path[way->access_index].x, 1.5);
  const auto none = graph.plan({0.5, 1.0}, {1.9, 1.9}, right_half);
  ASSERT_FALSE(none.has_value());
  EXPECT_NE(none.error().message.find("start"), std::string::npos);
}

TEST(VoronoiPlan, BadInputIsAnErrorWithItsReason) {
  EXPECT_FALSE(VoronoiGraph{}.plan({0, 0}, {1, 1}).has_value());
  VoronoiGraph graph = square_with_tail();
  EXPECT_FALSE(graph.plan({0, 0}, {std::nan(""), 1}).has_value());
  const int a = graph.add_node(meet({20, 0}, {0}));
  const int b = graph.add_node(meet({22, 0}, {180}));
  graph.add_edge(a, 0, b, 0, {}, 1.0);
  const auto apart = graph.plan({0, 0}, {21, 0});
  ASSERT_FALSE(apart.has_value());
  EXPECT_NE(apart.error().message.find("connect"), std::string::npos);
}

VoronoiGraph random_graph(Rng& rng) {
  VoronoiGraph graph;
  const int nodes = 2 + int(rng.below(12));
  for (int i = 0; i < nodes; ++i) graph.add_node(meet({rng.uniform(-9, 9), rng.uniform(-9, 9)}, {}));
  for (std::uint64_t e = rng.below(25); e > 0; --e) {
    const int from = int(rng.below(std::uint64_t(nodes)));
    const int to = int(rng.below(std::uint64_t(nodes)));
    if (from == to) continue;
    const std::size_t from_way = graph.add_way(from, radians(rng.uniform(-3, 3)));
    graph.add_edge(from, from_way, to, graph.add_way(to, radians(rng.uniform(-3, 3))),
                   {{rng.uniform(-9, 9), rng.uniform(-9, 9)}}, 1.0);
  }
  return graph;
}

RC_GTEST_PROP(VoronoiGraphProperty, ShortestPathsEqualThoseOfFloydAndWarshall, (std::uint64_t seed)) {
  Rng rng(seed);
  const VoronoiGraph graph = random_graph(rng);
  const std::size_t n = graph.nodes().size();
  std::vector<std::vector<double>> least(n, std::vector<double>(n, infinity));
  for (std::size_t i = 0; i < n; ++i) least[i][i] = 0.0;
  for (const VoronoiEdge& e : graph.edges()) {
    const auto from = std::size_t(e.from);
    const auto to = std::size_t(e.to);
    least[from][to] = least[to][from] = std::min(least[from][to], e.length_m);
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) least[i][j] = std::min(least[i][j], least[i][k] + least[k][j]);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const auto path = graph.shortest_path(int(i), int(j));
      RC_ASSERT(path.has_value() == std::isfinite(least[i][j]));
      if (!path) continue;
      RC_ASSERT(std::abs(path->length_m - least[i][j]) < 1e-9);
      RC_ASSERT(std::abs(polyline_length_m(graph.polyline(*path)) - path->length_m) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace echoarc::nav
