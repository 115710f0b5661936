// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_exploration.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/nav/segment_voronoi.hpp"
#include "echoarc/nav/voronoi_text.hpp"
#include "unit/nav/voronoi_world.hpp"

namespace echoarc::nav {
namespace {

using voronoi_world::distance_m;
using voronoi_world::drive;
using voronoi_world::Drive;
using voronoi_world::rectangle;
using voronoi_world::ring;
using voronoi_world::t_world;
using voronoi_world::Wall;
using voronoi_world::World;

constexpr Pose2 in_t{{-3.7, 4.6}, degrees(20)};

VoronoiGraph offline(const std::vector<Wall>& walls, Vec2 inside) {
  std::vector<WallSegment> segments;
  for (const Wall& w : walls) segments.push_back({w.a, w.b});
  return segment_voronoi(segments, inside).value();
}

double off_graph_m(const VoronoiGraph& graph, Vec2 p) {
  double least = 1e9;
  for (const VoronoiEdge& edge : graph.edges())
    for (std::size_t i = 1; i < edge.polyline.size(); ++i)
      if (edge.polyline[i] != edge.polyline[i - 1])
        least = std::min(least, distance_m(Wall{edge.polyline[i - 1], edge.polyline[i]}, p));
  return least;
}

int count(const VoronoiGraph& graph, VoronoiNodeType type) {
  return int(std::count_if(graph.nodes().begin(), graph.nodes().end(), [&](const auto& n) { return n.type == type; }));
}

/// The traced graph lies on the one of the walls, node by node.
void expect_on(const VoronoiGraph& traced, const VoronoiGraph& walls, double tolerance_m) {
  for (const VoronoiNode& node : traced.nodes()) {
    if (node.type != VoronoiNodeType::meet) continue;
    const bool known = std::any_of(walls.nodes().begin(), walls.nodes().end(), [&](const VoronoiNode& n) {
      return n.type == VoronoiNodeType::meet && n.degree() == node.degree() && norm(n.place - node.place) < tolerance_m;
    });
    EXPECT_TRUE(known) << "node at " << node.place.x << ", " << node.place.y;
  }
  double worst_m = 0.0;
  for (const VoronoiEdge& edge : traced.edges())
    for (const Vec2 p : edge.polyline) worst_m = std::max(worst_m, off_graph_m(walls, p));
  EXPECT_LT(worst_m, tolerance_m);
}

TEST(VoronoiExploration, TOfCorridorsIsExploredIntoTheNarrowOne) {
  World world(t_world());
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, in_t, {}, 600);
  ASSERT_EQ(run.last.status, Status::finished) << run.last.reason;
  EXPECT_GT(run.least_clearance_m, 0.30);
  const VoronoiGraph& graph = explorer.graph();
  EXPECT_EQ(count(graph, VoronoiNodeType::meet), 4);
  EXPECT_EQ(count(graph, VoronoiNodeType::boundary), 7);
  EXPECT_EQ(graph.edges().size(), 10u);
  const bool at_the_end = std::any_of(graph.nodes().begin(), graph.nodes().end(),
                                      [](const VoronoiNode& n) { return norm(n.place - Vec2{0, -3.675}) < 0.05; });
  EXPECT_TRUE(at_the_end);
  expect_on(graph, offline(t_world(), {0, 5}), 0.15);
}

TEST(VoronoiExploration, RoomHasItsBoundaryPointsInTheCorners) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{1, 1.2}, degrees(10)}, {}, 400);
  ASSERT_EQ(run.last.status, Status::finished) << run.last.reason;
  EXPECT_EQ(count(explorer.graph(), VoronoiNodeType::meet), 2);
  EXPECT_EQ(count(explorer.graph(), VoronoiNodeType::boundary), 4);
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{5, 0}, Vec2{5, 4}, Vec2{0, 4}}) {
    const bool found =
        std::any_of(explorer.graph().nodes().begin(), explorer.graph().nodes().end(), [&](const VoronoiNode& n) {
          return n.type == VoronoiNodeType::boundary && norm(n.place - corner) < 0.325 * std::sqrt(2.0) + 0.05;
        });
    EXPECT_TRUE(found) << corner.x << ", " << corner.y;
  }
  expect_on(explorer.graph(), offline(world.walls(), {1, 1}), 0.15);
}

TEST(VoronoiExploration, LoopIsClosedAtTheNodeItBeganAt) {
  World world(ring());
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{1.2, 3}, degrees(80)}, {}, 600);
  ASSERT_EQ(run.last.status, Status::finished) << run.last.reason;
  EXPECT_EQ(count(explorer.graph(), VoronoiNodeType::meet), 4);
  EXPECT_EQ(explorer.graph().edges().size(), 8u);
  const auto way_round = explorer.graph().shortest_path(0, 2);
  ASSERT_TRUE(way_round.has_value());
  EXPECT_EQ(way_round->edges.size(), 2u);
  expect_on(explorer.graph(), offline(ring(), {1, 1}), 0.15);
}

TEST(VoronoiExploration, CircleWithoutNodesEndsWhereItBegan) {
  std::vector<Wall> walls;
  for (const double r : {1.2, 3.0})
    for (int i = 0; i < 60; ++i) walls.push_back({r * unit(degrees(6.0 * i)), r * unit(degrees(6.0 * (i + 1)))});
  World world(walls);
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{2.2, 0}, degrees(80)}, {}, 200);
  ASSERT_EQ(run.last.status, Status::finished) << run.last.reason;
  ASSERT_EQ(explorer.graph().edges().size(), 1u);
  EXPECT_EQ(count(explorer.graph(), VoronoiNodeType::pass), 1);
  EXPECT_NEAR(explorer.graph().edges()[0].length_m, 2.0 * 3.14159265 * 2.1, 0.5);
}

TEST(VoronoiExploration, NoisyPointsGiveTheSameMeetPoints) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    World world(t_world(), {.spacing_m = 0.05, .noise_m = 0.03, .seed = seed});
    VoronoiExploration explorer(RobotBody{});
    const Drive run = drive(explorer, world, in_t, {}, 600);
    ASSERT_EQ(run.last.status, Status::finished) << run.last.reason;
    EXPECT_GT(run.least_clearance_m, 0.26);
    EXPECT_EQ(count(explorer.graph(), VoronoiNodeType::meet), 4);
    const double lowest =
        std::min_element(run.path.begin(), run.path.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; })->y;
    EXPECT_LT(lowest, -3.0);  // it has been in the narrow corridor
  }
}

TEST(VoronoiExploration, SameSurroundingsGiveTheSameGraph) {
  std::string texts[2];
  for (std::string& text : texts) {
    World world(rectangle({0, 0}, {5, 4}), {.noise_m = 0.02, .seed = 7});
    VoronoiExploration explorer(RobotBody{});
    EXPECT_EQ(drive(explorer, world, {{1, 1.2}, {}}, {}, 400).last.status, Status::finished);
    text = to_json(explorer.graph());
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(VoronoiExploration, SketchShowsTheGraphAndTheWayBack) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  bool saw_path = false;
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 400,
                          [&](Surroundings&) { saw_path = saw_path || explorer.sketch().path.size() > 1; });
  ASSERT_EQ(run.last.status, Status::finished);
  EXPECT_TRUE(saw_path);
  const Sketch sketch = explorer.sketch();
  EXPECT_EQ(sketch.nodes.size(), explorer.graph().nodes().size());
  EXPECT_EQ(sketch.edges.size(), explorer.graph().edges().size());
  EXPECT_EQ(sketch.nodes[0].kind, "meet");
}

}  // namespace
}  // namespace echoarc::nav
