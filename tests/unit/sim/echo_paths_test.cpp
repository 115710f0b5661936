// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/echo_paths.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echoarc::sim {
namespace {

const Angle all_round = degrees(180.0);

std::vector<EchoPath> paths(const WorldDescription& description, Vec2 sender, Vec2 listener, PathLimits limits = {}) {
  const World world = World::make(description).value();
  PathFinder finder(world);
  const auto found = finder.find({sender, {}, all_round}, {listener, {}, all_round}, limits);
  return {found.begin(), found.end()};
}

std::vector<double> lengths(const std::vector<EchoPath>& paths, EchoCause cause) {
  std::vector<double> result;
  for (const EchoPath& path : paths)
    if (path.cause == cause) result.push_back(path.length_m);
  return result;
}

void expect_lengths(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size()) << testing::PrintToString(found);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance);
}

// V6.1
TEST(EchoPaths, Plane) {
  const auto found = paths({.walls = {{{-5.0, 1.0}, {5.0, 1.0}}}}, {0.0, 0.0}, {0.2, 0.0});
  expect_lengths(lengths(found, EchoCause::wall), {2.009975}, 5e-7);
  EXPECT_NEAR(1.0 / tan(found[0].departure), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(found[0].gain_db, -0.5);
}

const WorldDescription corner{.walls = {{{0.0, 0.0}, {0.0, 5.0}}, {{0.0, 0.0}, {5.0, 0.0}}}};

TEST(EchoPaths, CornerFromTwoPlaces) {
  const auto found = paths(corner, {1.0, 0.6}, {1.05, 0.7});
  expect_lengths(lengths(found, EchoCause::corner), {2.427447}, 5e-7);
  for (const EchoPath& path : found)
    if (path.cause == EchoCause::corner) {
      EXPECT_NEAR(path.departure.rad(), bearing(Vec2{0.053846, 0.0} - Vec2{1.0, 0.6}).rad(), 1e-6);
      EXPECT_NEAR(path.arrival.rad(), bearing(Vec2{0.0, 0.034146} - Vec2{1.05, 0.7}).rad(), 1e-6);
      EXPECT_EQ(path.reflections, 2);
    }
}

TEST(EchoPaths, CornerSeenFromOnePlaceIsOnePath) {
  const auto found = paths(corner, {1.0, 0.6}, {1.0, 0.6});
  expect_lengths(lengths(found, EchoCause::corner), {2.0 * 1.166190}, 1e-6);
  expect_lengths(lengths(found, EchoCause::wall), {1.2, 2.0}, 1e-12);
}

TEST(EchoPaths, OutsideOfACornerIsNoMirror) {
  const WorldDescription box{
      .walls = {
          {{0.0, 0.0}, {1.0, 0.0}}, {{1.0, 0.0}, {1.0, 0.5}}, {{1.0, 0.5}, {0.0, 0.5}}, {{0.0, 0.5}, {0.0, 0.0}}}};
  for (const Vec2 place : {Vec2{-0.7, -0.6}, Vec2{1.6, 1.1}, Vec2{-0.3, 0.9}, Vec2{0.5, 1.5}, Vec2{1.23, 1.17}}) {
    const auto found = paths(box, place, place);
    EXPECT_TRUE(lengths(found, EchoCause::corner).empty());
    EXPECT_GE(lengths(found, EchoCause::edge).size(), 2U);
  }
}

TEST(EchoPaths, Cylinder) {
  const auto one = paths({.materials = {{.loss_db = 0.0}}, .discs = {{{1.0, 0.0}, 0.15}}}, {}, {});
  expect_lengths(lengths(one, EchoCause::disc), {1.7}, 1e-12);
  EXPECT_NEAR(one[0].gain_db, -8.2391, 5e-5);
  const auto two = paths({.discs = {{{0.5, 1.0}, 0.15}}}, {}, {0.2, 0.0});
  expect_lengths(lengths(two, EchoCause::disc), {1.8633546}, 5e-8);
  EXPECT_NEAR(two[0].departure.rad(), bearing({0.444769, 0.860538}).rad(), 1e-6);
}

TEST(EchoPaths, ParallelWalls) {
  const auto found = paths({.walls = {{{0.0, -9.0}, {0.0, 9.0}}, {{1.5, -9.0}, {1.5, 9.0}}}}, {0.4, 0.0}, {0.4, 0.0});
  expect_lengths(lengths(found, EchoCause::wall), {0.8, 2.2}, 1e-12);
  expect_lengths(lengths(found, EchoCause::multiple), {3.0, 3.0, 3.8, 5.2}, 1e-12);  // 3.0 both ways round
}

// V6.2
TEST(EchoPaths, WedgesEchoAtTheirImages) {
  for (const auto& [wedge, ranges] : std::vector<std::pair<double, std::vector<double>>>{
           {90.0, {1.0}}, {60.0, {0.866025}}, {30.0, {0.5, 0.866025, 1.0}}}) {
    const Vec2 wall = 4.0 * unit(degrees(wedge));
    const Vec2 source = unit(degrees(0.4 * wedge));
    const auto found = paths({.walls = {{{}, {4.0, 0.0}}, {{}, wall}}}, source, source, {.max_order = 6});
    for (const double range : ranges) {
      bool heard = false;
      for (const EchoPath& path : found)
        heard = heard || (path.reflections % 2 == 0 && std::abs(path.length_m / 2.0 - range) < 5e-7);
      EXPECT_TRUE(heard) << wedge << " degrees, range " << range;
    }
    for (const double to_wall : {0.4 * wedge, 0.6 * wedge}) {
      bool heard = false;
      for (const EchoPath& path : found)
        heard = heard || (path.reflections == 1 && std::abs(path.length_m / 2.0 - sin(degrees(to_wall))) < 1e-12);
      EXPECT_TRUE(heard);
    }
  }
}

TEST(EchoPaths, EndsAndOutsideCornersEchoWeakly) {
  const auto found = paths({.walls = {{{2.0, 0.0}, {2.0, 1.0}}}}, {0.0, -0.5}, {0.0, -0.5});
  expect_lengths(lengths(found, EchoCause::edge), {2.0 * std::hypot(2.0, 0.5), 2.0 * std::hypot(2.0, 1.5)}, 1e-12);
  EXPECT_DOUBLE_EQ(found[0].gain_db, -15.0);
}

/// An arc around the origin, from -60 to 60 degrees, hollow towards it.
SmoothCurve hollow(double radius_m) {
  SmoothCurve curve;
  const double end = std::numbers::pi / 3.0;
  for (double a = -end; a <= end; a += 0.001 / radius_m) curve.points.push_back(radius_m * unit(radians(a)));
  return curve;
}

TEST(EchoPaths, AHollowCurveEchoesAtItsNearestOrFurthestPoint) {
  const WorldDescription world{.materials = {{.loss_db = 0.0}}, .curves = {hollow(2.0)}};
  const auto nearest = paths(world, {0.5, 0.0}, {0.5, 0.0});  // before the centre: a minimum
  expect_lengths(lengths(nearest, EchoCause::curve), {3.0}, 2e-6);
  EXPECT_NEAR(nearest[0].gain_db, 10.0 * std::log10(2.0 / 0.5), 1e-3);
  const auto furthest = paths(world, {-1.0, 0.0}, {-1.0, 0.0});  // beyond it: a maximum
  expect_lengths(lengths(furthest, EchoCause::curve), {6.0}, 2e-6);
  EXPECT_NEAR(furthest.back().gain_db, 10.0 * std::log10(2.0 / 1.0), 1e-3);
  EXPECT_EQ(lengths(furthest, EchoCause::edge).size(), 2) << "its ends";
}

TEST(EchoPaths, ABulgingCurveSpreadsSound) {
  const WorldDescription world{.materials = {{.loss_db = 0.0}}, .curves = {hollow(0.5)}};
  const auto found = paths(world, {1.5, 0.0}, {1.5, 0.0});
  expect_lengths(lengths(found, EchoCause::curve), {2.0}, 1e-6);
  EXPECT_NEAR(found[0].gain_db, 10.0 * std::log10(0.5 / 1.5), 1e-3);
}

TEST(EchoPaths, AClosedCurveHasNoEnds) {
  SmoothCurve ring;
  for (int i = 0; i <= 1000; ++i) ring.points.push_back(0.3 * unit(radians(2.0 * std::numbers::pi * i / 1000.0)));
  const auto found = paths({.curves = {ring}}, {1.0, 0.0}, {1.0, 0.0});
  ASSERT_EQ(found.size(), 1);
  EXPECT_NEAR(found[0].length_m, 1.4, 1e-9) << "at the joint";
}

TEST(EchoPaths, AWallAndAnEdge) {
  // The floor y = 0 mirrors the sender; the post's lower end stands at (1, 1).
  const WorldDescription world{.walls = {{{-3.0, 0.0}, {5.0, 0.0}}, {{1.0, 1.0}, {1.0, 2.0}}}};
  const double direct = std::hypot(1.0, 0.5);
  const double mirrored = std::hypot(1.0, 1.5);
  const auto found = paths(world, {0.0, 0.5}, {0.0, 0.5});
  std::vector<double> of_post;
  for (const EchoPath& path : found)
    if (path.cause == EchoCause::wall_edge && std::abs(path.length_m - direct - mirrored) < 1e-12)
      of_post.push_back(path.gain_db);
  EXPECT_EQ(of_post, (std::vector<double>{-15.5, -15.5})) << "the wall first, and the edge first";
  for (const EchoPath& path : paths(world, {0.0, 0.5}, {0.0, 0.5}, {.max_order = 1})) EXPECT_EQ(path.reflections, 1);
}

TEST(EchoPaths, BumpsAreSeenFromTheirSideAlone) {
  const WorldDescription world{.materials = {{.rough_db = -18.0}}, .walls = {{{-1.0, 1.0}, {1.0, 1.0}}}};
  EXPECT_EQ(lengths(paths(world, {}, {}), EchoCause::scatterer).size(), 40);
  EXPECT_EQ(lengths(paths(world, {}, {0.0, 2.0}), EchoCause::scatterer).size(), 0);
}

TEST(EchoPaths, MovingDiscsEchoAndHide) {
  const World world = World::make({.walls = {{{2.0, -1.0}, {2.0, 1.0}}}}).value();
  PathFinder finder(world);
  const Transducer here{{}, {}, degrees(20.0)};
  const std::vector<Disc> moving{{{1.0, 0.0}, 0.2}};
  const auto found = finder.find(here, here, {}, moving);
  ASSERT_EQ(found.size(), 1);
  EXPECT_EQ(found[0].cause, EchoCause::disc);
  EXPECT_DOUBLE_EQ(found[0].length_m, 1.6);
}

TEST(EchoPaths, AnOpenWorldIsSilent) {
  EXPECT_TRUE(paths({}, {}, {}).empty());
}

TEST(EchoPaths, TheWindowLooksAhead) {
  const World world = World::make({.walls = {{{2.0, -1.0}, {2.0, 1.0}}}}).value();
  PathFinder finder(world);
  EXPECT_EQ(finder.find({{}, {}, degrees(25.0)}, {{}, {}, degrees(25.0)}, {}).size(), 1);
  EXPECT_EQ(finder.find({{}, degrees(24.0), degrees(25.0)}, {{}, degrees(24.0), degrees(25.0)}, {}).size(), 2)
      << "one end, too";
  EXPECT_TRUE(finder.find({{}, degrees(180.0), degrees(25.0)}, {{}, degrees(180.0), degrees(25.0)}, {}).empty());
}

}  // namespace
}  // namespace echoarc::sim
