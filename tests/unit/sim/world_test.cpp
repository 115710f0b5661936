// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/world.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace echoarc::sim {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

World world_of(std::vector<Wall> walls) {
  return World::make({.walls = std::move(walls)}).value();
}

TEST(World, AnEmptyOneIsOpen) {
  const World world = World::make({}).value();
  EXPECT_FALSE(world.first_hit({0.0, 0.0}, {1.0, 0.0}, 1e6));
  EXPECT_TRUE(world.visible({-50.0, 0.0}, {50.0, 3.0}));
  EXPECT_EQ(world.clearance({0.0, 0.0}, 2.0), 2.0);
}

TEST(World, RaysMeetTheNearestSurface) {
  const World world = World::make({.materials = {{}, {.name = "glass"}},
                                   .walls = {{{2.0, -1.0}, {2.0, 1.0}}, {{3.0, -1.0}, {3.0, 1.0}}},
                                   .discs = {{{0.0, 2.0}, 0.5, 1}}})
                          .value();
  EXPECT_DOUBLE_EQ(world.first_hit({0.0, 0.0}, {1.0, 0.0}, 10.0)->distance_m, 2.0);
  EXPECT_FALSE(world.first_hit({0.0, 0.0}, {1.0, 0.0}, 1.9));
  EXPECT_FALSE(world.first_hit({0.0, 0.0}, {-1.0, 0.0}, 10.0));
  const auto disc = world.first_hit({0.0, 0.0}, {0.0, 1.0}, 10.0);
  EXPECT_DOUBLE_EQ(disc->distance_m, 1.5);
  EXPECT_EQ(disc->material, 1);
  const std::vector<Disc> moving{{{1.0, 0.0}, 0.25, 1}};
  EXPECT_DOUBLE_EQ(world.first_hit({0.0, 0.0}, {1.0, 0.0}, 10.0, moving)->distance_m, 0.75);
}

TEST(World, AWallHidesWhatIsBehindIt) {
  const World world = world_of({{{2.0, -1.0}, {2.0, 1.0}}});
  EXPECT_FALSE(world.visible({0.0, 0.0}, {4.0, 0.0}));
  EXPECT_TRUE(world.visible({0.0, 0.0}, {4.0, 5.0}));
  EXPECT_TRUE(world.visible({0.0, 0.0}, {2.0, 0.0})) << "a point on the wall itself";
  EXPECT_TRUE(world.visible({0.0, 0.0}, {2.0, 1.0})) << "the wall's end";
  EXPECT_FALSE(world.visible({2.0, 3.0}, {2.0, -3.0})) << "along the wall";
}

TEST(World, AOneSidedWallIsThereFromItsLeftAlone) {
  const World world = world_of({{.a = {2.0, 1.0}, .b = {2.0, -1.0}, .one_sided = true}});  // its left is +x
  EXPECT_FALSE(world.visible({4.0, 0.0}, {0.0, 0.0}));
  EXPECT_TRUE(world.visible({0.0, 0.0}, {4.0, 0.0}));
  EXPECT_TRUE(world.first_hit({4.0, 0.0}, {-1.0, 0.0}, 10.0));
  EXPECT_FALSE(world.first_hit({0.0, 0.0}, {1.0, 0.0}, 10.0));
}

TEST(World, ClearanceIsTheDistanceToTheNearestSurface) {
  const World world = World::make({.walls = {{{2.0, -1.0}, {2.0, 1.0}}}, .discs = {{{0.0, 3.0}, 0.5}}}).value();
  EXPECT_DOUBLE_EQ(world.clearance({0.0, 0.0}, 5.0), 2.0);
  EXPECT_DOUBLE_EQ(world.clearance({0.0, 1.6}, 5.0), 0.9);
  EXPECT_DOUBLE_EQ(world.clearance({0.0, 3.1}, 5.0), 0.0);
  EXPECT_DOUBLE_EQ(world.clearance({5.0, 1.0}, 5.0, std::vector<Disc>{{{5.0, 2.0}, 0.25}}), 0.75);
}

TEST(World, MovingDiscsGoStraightBetweenTheirStations) {
  const World world =
      World::make({.moving = {{.radius_m = 0.2, .path = {{1.0, {0.0, 0.0}}, {3.0, {4.0, 2.0}}}}}}).value();
  EXPECT_EQ(world.moving_at(0.0)[0].centre, (Vec2{0.0, 0.0}));
  EXPECT_EQ(world.moving_at(2.0)[0].centre, (Vec2{2.0, 1.0}));
  EXPECT_EQ(world.moving_at(9.0)[0].centre, (Vec2{4.0, 2.0}));
}

const Vertex& vertex_at(const World& world, Vec2 point) {
  for (const Vertex& v : world.vertices())
    if (norm(v.point - point) < 1e-5) return v;
  throw std::logic_error("no vertex there");
}

TEST(Vertices, ACornerIsConcaveFromInsideAndConvexFromOutside) {
  const World world =
      world_of({{{0.0, 0.0}, {2.0, 0.0}}, {{0.0, 3.0}, {0.0, 4e-7}}});  // the ends miss each other a little
  ASSERT_EQ(world.vertices().size(), 3);
  const Vertex& corner = vertex_at(world, {0.0, 0.0});
  EXPECT_EQ(corner.kind, VertexKind::convex);
  EXPECT_FALSE(corner.echoes_to({1.0, 1.0}));
  EXPECT_TRUE(corner.echoes_to({-1.0, 1.0}));
  EXPECT_TRUE(corner.echoes_to({-1.0, -1.0}));
  EXPECT_TRUE(corner.echoes_to({1.0, -1.0}));
  const Vertex& end = vertex_at(world, {2.0, 0.0});
  EXPECT_EQ(end.kind, VertexKind::end);
  EXPECT_TRUE(end.echoes_to({1.0, 1.0}));
  EXPECT_TRUE(end.echoes_to({3.0, -1.0}));
}

TEST(Vertices, AWallThatEndsOnAnotherMakesTwoConcaveCorners) {
  const World world = world_of({{{-2.0, 0.0}, {2.0, 0.0}}, {{0.5, 0.0}, {0.5, 3.0}}});
  EXPECT_EQ(vertex_at(world, {0.5, 0.0}).kind, VertexKind::concave);
  EXPECT_FALSE(vertex_at(world, {0.5, 0.0}).echoes_to({0.0, -1.0}));
}

TEST(Vertices, AWallInTwoPiecesHasNoVertexBetweenThem) {
  const World world = world_of({{{-2.0, 0.0}, {0.0, 0.0}}, {{0.0, 0.0}, {2.0, 0.0}}});
  EXPECT_EQ(vertex_at(world, {0.0, 0.0}).kind, VertexKind::concave);
}

TEST(Bumps, LieCloseToTheirWallAndStayWhenOthersAreAdded) {
  const WorldDescription one{.materials = {{.rough_db = -18.0}}, .walls = {{{0.0, 0.0}, {3.0, 0.0}}}};
  WorldDescription two = one;
  two.walls.push_back({{0.0, 2.0}, {3.0, 2.0}});
  const World world = World::make(one).value();
  const World more = World::make(two).value();
  ASSERT_EQ(world.scatterers().size(), 2 * 60);
  double sum_db = 0.0;
  for (std::size_t i = 0; i < 60; ++i) {
    const Scatterer& left = world.scatterers()[i];
    EXPECT_GT(left.point.y, 0.0);
    EXPECT_LE(left.point.y, 0.005);
    EXPECT_NEAR(left.point.x, 0.05 * (static_cast<double>(i) + 0.5), 0.015);
    EXPECT_LT(world.scatterers()[60 + i].point.y, 0.0);
    EXPECT_EQ(left.point, more.scatterers()[i].point);
    sum_db += left.gain_db;
  }
  EXPECT_NEAR(sum_db / 60.0, -18.0, 1.5);
}

void expect_error(const WorldDescription& description, std::string_view cause, std::string_view where) {
  const Result<World> world = World::make(description);
  ASSERT_FALSE(world) << cause;
  EXPECT_NE(world.error().message.find(cause), std::string::npos) << world.error().message;
  EXPECT_EQ(world.error().where, where);
  EXPECT_FALSE(world.error().remedy.empty());
}

SmoothCurve loop() {
  SmoothCurve curve{.line = 9};
  for (int i = 0; i <= 460; ++i) {
    const double t = 0.001 * i;
    curve.points.push_back({0.05 * std::cos(20.0 * t) + 0.2 * t, 0.05 * std::sin(20.0 * t)});
  }
  return curve;
}

TEST(WorldErrors, NameTheLineAndARemedy) {
  expect_error({.walls = {{.a = {1.0, 1.0}, .b = {1.0, 1.0}, .line = 7}}}, "no length", "line 7");
  expect_error({.walls = {{.a = {1.0, nan}, .b = {1.0, 1.0}, .line = 7}}}, "not finite", "line 7");
  expect_error({.walls = {{.a = {1.0, 2e5}, .b = {1.0, 1.0}, .line = 7}}}, "100000 m", "line 7");
  expect_error({.walls = {{.a = {1.0, 0.0}, .b = {1.0, 1.0}, .material = 3, .line = 7}}}, "material 3 of 1", "line 7");
  expect_error({.discs = {{.radius_m = 0.0, .line = 8}}}, "radius", "line 8");
  expect_error({.discs = {{.radius_m = nan, .line = 8}}}, "radius", "line 8");
  expect_error({.curves = {{.points = {{0.0, 0.0}, {0.001, 0.0}}, .line = 9}}}, "fewer than 3", "line 9");
  expect_error({.curves = {{.points = {{0.0, 0.0}, {0.001, 0.0}, {0.01, 0.0}}, .line = 9}}}, "point 3", "line 9");
  expect_error({.curves = {loop()}}, "crosses itself", "line 9");
  expect_error({.materials = {{.loss_db = -1.0}}}, "loss", "");
  expect_error({.materials = {{.rough_db = 0.0}}}, "bumps", "");
  expect_error({.materials = {{.rough_db = -18.0, .rough_pitch_m = 1e-4}}}, "1 mm", "");
  expect_error({.moving = {{.path = {}, .line = 5}}}, "no path", "line 5");
  expect_error({.moving = {{.path = {{1.0, {}}, {1.0, {}}}, .line = 5}}}, "do not grow", "line 5");
  expect_error({.materials = {}}, "without materials", "");
}

}  // namespace
}  // namespace echoarc::sim
