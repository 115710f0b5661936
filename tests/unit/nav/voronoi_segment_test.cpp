// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/nav/segment_voronoi.hpp"
#include "unit/nav/voronoi_world.hpp"

namespace echoarc::nav {
namespace {

using voronoi_world::distance_m;
using voronoi_world::Wall;

std::vector<WallSegment> segments(const std::vector<Wall>& walls) {
  std::vector<WallSegment> all;
  for (const Wall& w : walls) all.push_back({w.a, w.b});
  return all;
}

const VoronoiNode* node_at(const VoronoiGraph& graph, Vec2 place) {
  for (const VoronoiNode& node : graph.nodes())
    if (norm(node.place - place) < 2e-3) return &node;
  return nullptr;
}

double off_graph_m(const VoronoiGraph& graph, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const VoronoiEdge& edge : graph.edges())
    for (std::size_t i = 1; i < edge.polyline.size(); ++i)
      if (edge.polyline[i] != edge.polyline[i - 1])
        least = std::min(least, distance_m(Wall{edge.polyline[i - 1], edge.polyline[i]}, p));
  return least;
}

Vec2 foot(const Wall& wall, Vec2 p) {
  const Vec2 along = wall.b - wall.a;
  return wall.a + std::clamp(dot(p - wall.a, along) / squared_norm(along), 0.0, 1.0) * along;
}

/// The difference between the distance to the nearest wall and to the nearest in quite another direction.
double difference_m(const std::vector<Wall>& walls, Vec2 p) {
  const auto nearer = [&](const Wall& a, const Wall& b) { return distance_m(a, p) < distance_m(b, p); };
  const Vec2 nearest = foot(*std::min_element(walls.begin(), walls.end(), nearer), p);
  double second = std::numeric_limits<double>::infinity();
  for (const Wall& w : walls)
    if (abs(wrap(bearing(foot(w, p) - p) - bearing(nearest - p))) > degrees(25))
      second = std::min(second, distance_m(w, p));
  return second - norm(nearest - p);
}

TEST(SegmentVoronoi, TOfCorridors) {
  const auto graph = segment_voronoi(segments(voronoi_world::t_world()), Vec2{0, 5});
  ASSERT_TRUE(graph.has_value());
  EXPECT_EQ(graph->nodes().size(), 13u);
  EXPECT_EQ(graph->edges().size(), 12u);
  const VoronoiNode* junction = node_at(*graph, {0, 4.75});
  ASSERT_NE(junction, nullptr);
  EXPECT_NEAR(junction->distance_m, 1.25, 1e-3);
  EXPECT_EQ(junction->degree(), 3);
  const VoronoiNode* mouth = node_at(*graph, {0, std::sqrt(1.0 - 0.45 * 0.45)});
  ASSERT_NE(mouth, nullptr);
  EXPECT_EQ(mouth->degree(), 4);
  const VoronoiNode* end = node_at(*graph, {0, -3.55});
  ASSERT_NE(end, nullptr);
  const auto narrow = graph->shortest_path(mouth->id, end->id);
  ASSERT_TRUE(narrow.has_value() && narrow->edges.size() == 1);
  EXPECT_NEAR(graph->edges()[std::size_t(narrow->edges[0])].min_clearance_m, 0.45, 1e-3);
}

TEST(SegmentVoronoi, RingClosesOnItselfInFourEdges) {
  const auto graph = segment_voronoi(segments(voronoi_world::ring()), Vec2{1, 1});
  ASSERT_TRUE(graph.has_value());
  EXPECT_EQ(graph->nodes().size(), 8u);
  EXPECT_EQ(graph->edges().size(), 8u);
  EXPECT_NE(node_at(*graph, {4.0 - 2.0 * std::sqrt(2.0), 4.0 - 2.0 * std::sqrt(2.0)}), nullptr);  // d = x, to (2, 2)
}

TEST(SegmentVoronoi, CircleWithoutAnyNodeGetsOne) {
  std::vector<WallSegment> walls;
  for (const double r : {1.0, 3.0})
    for (int i = 0; i < 40; ++i) walls.push_back({r * unit(degrees(9.0 * i)), r * unit(degrees(9.0 * (i + 1)))});
  const auto graph = segment_voronoi(walls, Vec2{2, 0});
  ASSERT_TRUE(graph.has_value());
  ASSERT_EQ(graph->nodes().size(), 1u);
  EXPECT_EQ(graph->nodes()[0].type, VoronoiNodeType::pass);
  EXPECT_NEAR(graph->edges().at(0).length_m, 4.0 * 3.14159265, 0.1);
}

TEST(SegmentVoronoi, WallsMayCrossTouchOverlapAndRepeat) {
  std::vector<WallSegment> walls = segments(voronoi_world::rectangle({0, 0}, {9, 8}));
  walls.push_back({{4, -1}, {4, 3}});  // crosses the lower wall
  walls.push_back({{0, 3}, {5, 3}});   // touches two
  walls.push_back({{3, 3}, {9, 3}});   // overlaps
  walls.push_back({{9, 8}, {0, 8}});   // is there already
  walls.push_back({{2, 3}, {2, 3}});   // a point on a wall
  const auto graph = segment_voronoi(walls, Vec2{1, 1});
  ASSERT_TRUE(graph.has_value());
  EXPECT_EQ(graph->nodes().size(), 6u);  // of the closed room [0, 4] x [0, 3]
  EXPECT_NE(node_at(*graph, {1.5, 1.5}), nullptr);
  EXPECT_NE(node_at(*graph, {2.5, 1.5}), nullptr);
}

TEST(SegmentVoronoi, PointsAreWallsToo) {
  std::vector<WallSegment> walls;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{4, 0}, Vec2{4, 3}, Vec2{0, 3}}) walls.push_back({p, p});
  const auto graph = segment_voronoi(walls);
  ASSERT_TRUE(graph.has_value());
  EXPECT_TRUE(graph->edges().empty());  // all four edges lead off without end
}

TEST(SegmentVoronoi, BadInput) {
  const auto empty = segment_voronoi({});
  ASSERT_TRUE(empty.has_value());
  EXPECT_TRUE(empty->nodes().empty());
  const std::vector<WallSegment> no_number{{{0, 0}, {std::nan(""), 1}}};
  ASSERT_FALSE(segment_voronoi(no_number).has_value());
  EXPECT_EQ(segment_voronoi(no_number).error().where, "wall 0");
  const std::vector<WallSegment> far{{{0, 0}, {1e9, 1}}};
  EXPECT_FALSE(segment_voronoi(far).has_value());
}

std::vector<Wall> random_room(Rng& rng) {
  std::vector<Wall> walls = voronoi_world::rectangle({0, 0}, {10, 8});
  for (int i = 0; i < 5; ++i) {
    const Vec2 a{rng.uniform(1, 9), rng.uniform(1, 7)};
    walls.push_back({a, a + rng.uniform(0.3, 3.0) * unit(radians(rng.uniform(-3, 3)))});
  }
  return walls;
}

RC_GTEST_PROP(SegmentVoronoiProperty, EdgesStayEquidistantAndAtTheirClearance, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Wall> walls = random_room(rng);
  const auto graph = segment_voronoi(segments(walls), Vec2{0.5, 0.5});
  RC_ASSERT(graph.has_value());
  for (const VoronoiEdge& edge : graph->edges()) {
    for (std::size_t i = 1; i + 1 < edge.polyline.size(); ++i) {
      const double clearance_m = distance_m(walls, edge.polyline[i]);
      RC_ASSERT(clearance_m > 0.325 - 1e-3);
      RC_ASSERT(clearance_m > edge.min_clearance_m - 1e-3);
      RC_ASSERT(difference_m(walls, edge.polyline[i]) < 2e-3);
    }
  }
}

// The slow form: where on a straight line the nearest wall changes, an edge of the graph must pass.
RC_GTEST_PROP(SegmentVoronoiProperty, NothingEquidistantIsMissing, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Wall> walls = random_room(rng);
  const auto graph = segment_voronoi(segments(walls));
  RC_ASSERT(graph.has_value());
  const auto nearest = [&](Vec2 p) {
    return std::min_element(walls.begin(), walls.end(),
                            [&](const Wall& a, const Wall& b) { return distance_m(a, p) < distance_m(b, p); });
  };
  for (int k = 0; k < 50; ++k) {
    Vec2 a{rng.uniform(0.1, 9.9), rng.uniform(0.1, 7.9)};
    Vec2 b{rng.uniform(0.1, 9.9), rng.uniform(0.1, 7.9)};
    if (nearest(a) == nearest(b)) continue;
    for (int i = 0; i < 40; ++i) (nearest(0.5 * (a + b)) == nearest(a) ? a : b) = 0.5 * (a + b);
    const Angle between = abs(wrap(bearing(foot(*nearest(a), a) - a) - bearing(foot(*nearest(b), a) - a)));
    if (distance_m(walls, a) < 0.33 || between < degrees(31)) continue;
    RC_ASSERT(off_graph_m(*graph, a) < 0.03);
  }
}

}  // namespace
}  // namespace echoarc::nav
