// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/nav/voronoi_tracer.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "unit/nav/voronoi_world.hpp"

namespace echoarc::nav {
namespace {

using voronoi_world::rectangle;
using voronoi_world::t_world;
using voronoi_world::World;

constexpr double radius_m = 0.225;

/// Moves a point by the wanted velocity until something happens.
TraceEvent trace(VoronoiTracer& tracer, World& world, Vec2& place, int longest = 600) {
  for (int i = 0; i < longest; ++i) {
    const TraceStep step = tracer.update(place, 0.1, world.visible(place));
    if (step.event != TraceEvent::none) return step.event;
    place = place + 0.1 * step.velocity_m_s;
  }
  return TraceEvent::none;
}

TEST(VoronoiTracer, AccessLeadsAwayFromTheNearestWall) {
  World world(t_world());
  const VoronoiTracer tracer(radius_m);
  Vec2 place{-3, 4.5};
  AccessStep step = tracer.access(place, Angle{}, world.visible(place));
  EXPECT_FALSE(step.reached);
  EXPECT_NEAR(bearing(step.velocity_m_s).deg(), 90.0, 2.0);
  for (int i = 0; i < 100 && !step.reached; ++i) {
    place = place + 0.1 * step.velocity_m_s;
    step = tracer.access(place, degrees(30), world.visible(place));
  }
  EXPECT_TRUE(step.reached);
  EXPECT_NEAR(place.y, 5.0, 0.02);
  EXPECT_NEAR(step.direction.deg(), 0.0, 1.0);
}

TEST(VoronoiTracer, AccessWithoutAnythingInViewStands) {
  const AccessStep step = VoronoiTracer(radius_m).access({0, 0}, Angle{}, {});
  EXPECT_FALSE(step.reached);
  EXPECT_EQ(step.velocity_m_s, Vec2{});
}

TEST(VoronoiTracer, MeetsThreeObstaclesAtTheJunction) {
  World world(t_world());
  VoronoiTracer tracer(radius_m);
  Vec2 place{-2.5, 5.02};
  tracer.begin(place, Angle{});
  ASSERT_EQ(trace(tracer, world, place), TraceEvent::meet);
  const auto sight = tracer.meet(place, world.visible(place));
  ASSERT_TRUE(sight.has_value());
  EXPECT_NEAR(sight->place.x, 0.0, 0.02);
  EXPECT_NEAR(sight->place.y, 4.75, 0.02);  // 6 - y = sqrt(1 + (y - 4)^2)
  EXPECT_NEAR(sight->distance_m, 1.25, 0.02);
  EXPECT_EQ(sight->ways.size(), 3u);
}

TEST(VoronoiTracer, EndsInACornerWhereTheBodyNoLongerFits) {
  World world(rectangle({0, 0}, {6, 5}));
  VoronoiTracer tracer(radius_m);
  Vec2 place{1.2, 1.2};
  tracer.begin(place, degrees(-135));
  ASSERT_EQ(trace(tracer, world, place), TraceEvent::boundary);
  EXPECT_NEAR(place.x, radius_m + 0.1, 0.02);
  EXPECT_NEAR(place.y, radius_m + 0.1, 0.02);
}

TEST(VoronoiTracer, EndsBeforeAWallAcrossANarrowCorridor) {
  World world(t_world());
  constexpr double wide_m = 0.25;  // its corners are no ways out for such a body
  VoronoiTracer tracer(wide_m);
  Vec2 place{0.02, -1.0};
  tracer.begin(place, degrees(-90));
  TraceEvent event = trace(tracer, world, place);
  while (event == TraceEvent::meet && !tracer.meet(place, world.visible(place))) {
    tracer.resume();
    event = trace(tracer, world, place);
  }
  EXPECT_EQ(event, TraceEvent::boundary);
  EXPECT_NEAR(place.x, 0.0, 0.02);
  EXPECT_NEAR(place.y, -4.0 + wide_m + 0.1, 0.03);
}

TEST(VoronoiTracer, StaysEquidistantOnACurvedEdge) {
  // A wall y = 0 and a pole at (0, 2): the parabola y = x^2 / 4 + 1.
  std::vector<Vec2> points{{0, 2}};
  for (int i = -400; i <= 400; ++i) points.push_back({0.01 * i, 0.0});
  VoronoiTracer tracer(radius_m);
  Vec2 place{-2.0, 2.0};
  tracer.begin(place, degrees(-45));
  double worst_m = 0.0;
  for (int i = 0; i < 250 && place.x < 1.8; ++i) {
    const TraceStep step = tracer.update(place, 0.1, points);
    ASSERT_EQ(step.event, TraceEvent::none);
    place = place + 0.1 * step.velocity_m_s;
    worst_m = std::max(worst_m, std::abs(place.y - norm(place - Vec2{0, 2})));
  }
  EXPECT_GE(place.x, 1.8);
  EXPECT_LT(worst_m, 0.03);
}

TEST(VoronoiTracer, SaysThatItLostTheEdge) {
  VoronoiTracer tracer(radius_m);
  tracer.begin({0, 0}, Angle{});
  TraceEvent event = TraceEvent::none;
  int steps = 0;
  for (; steps < 100 && event == TraceEvent::none; ++steps) event = tracer.update({0, 0}, 0.1, {}).event;
  EXPECT_EQ(event, TraceEvent::lost);
  EXPECT_NEAR(0.1 * steps, TracerOptions{}.patience_s, 0.3);
}

TEST(VoronoiTracer, NewtonFindsTheCircumcentreOfThreePoles) {
  const Vec2 centre{0.3, -0.2};
  std::vector<Vec2> poles;
  for (const double deg : {10.0, 120.0, 250.0}) poles.push_back(centre + 1.5 * unit(degrees(deg)));
  const auto found = obstacle_distances(poles, {0.1, 0.0});
  ASSERT_EQ(found.size(), 3u);
  const auto meet = refine_meet(poles, {0.1, 0.0}, {found[0], found[1], found[2]});
  ASSERT_TRUE(meet.has_value());
  EXPECT_NEAR(meet->x, centre.x, 2e-3);
  EXPECT_NEAR(meet->y, centre.y, 2e-3);
}

TEST(VoronoiTracer, NewtonGivesUpOnThreeInARow) {
  const std::vector<Vec2> poles{{-2, 3}, {0, 3}, {2, 3}};
  const auto found = obstacle_distances(poles, {0, 0});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_FALSE(refine_meet(poles, {0, 0}, {found[0], found[1], found[2]}).has_value());
}

TEST(VoronoiTracer, WaysOutOfANodeAreTheBisectorsOfItsGaps) {
  World world(t_world());
  const NodeSight foot = node_sight(world.visible({0, 0.893}), {0, 0.893}, 0.65);
  ASSERT_EQ(foot.ways.size(), 4u);  // back, into the narrow corridor, and into both corners beside it
  const auto has = [&](double deg) {
    return std::any_of(foot.ways.begin(), foot.ways.end(),
                       [&](Angle a) { return abs(wrap(a - degrees(deg))) < degrees(4); });
  };
  EXPECT_TRUE(has(90) && has(-90) && has(-149) && has(-31));
  // A body of 1 m does not fit into the narrow corridor.
  EXPECT_EQ(node_sight(world.visible({0, 0.893}), {0, 0.893}, 1.0).ways.size(), 3u);
  EXPECT_TRUE(node_sight({}, {0, 0}, 0.65).ways.empty());
}

}  // namespace
}  // namespace echoarc::nav
