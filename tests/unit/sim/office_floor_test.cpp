// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/office_floor.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "sim/office_plan.hpp"

namespace echoarc::sim {
namespace {

constexpr MaterialId smooth = 0;
constexpr MaterialId rough = 1;

OfficeFloor floor_of(const OfficeFloorOptions& options) {
  auto floor = make_office_floor(options, smooth, rough);
  EXPECT_TRUE(floor) << floor.error().message;
  return floor ? *std::move(floor) : OfficeFloor{};
}

World world_of(const OfficeFloor& floor) {
  auto world = World::make({.materials = {{}, {.name = "brick", .rough_db = -18.0}}, .walls = floor.walls});
  EXPECT_TRUE(world) << world.error().message;
  return *std::move(world);
}

double length_m(const OfficeFloor& floor) {
  double sum = 0.0;
  Vec2 at = floor.start.position;
  for (const DriveLeg& leg : floor.tour) {
    sum += norm(*leg.to - at);
    at = *leg.to;
  }
  return sum;
}

/// The tour's distance to the nearest wall, sampled every 10 cm.
double least_clearance_m(const OfficeFloor& floor, const World& world) {
  double least = 10.0;
  Vec2 at = floor.start.position;
  for (const DriveLeg& leg : floor.tour) {
    const Vec2 way = *leg.to - at;
    const int steps = static_cast<int>(norm(way) / 0.1) + 1;
    for (int i = 0; i <= steps; ++i) least = std::min(least, world.clearance(at + way * (1.0 * i / steps), least));
    EXPECT_TRUE(world.visible(at, *leg.to)) << "a leg goes through a wall";
    at = *leg.to;
  }
  return least;
}

TEST(OfficeFloor, TheDefaultIsTheBuildingOfThePaper) {
  const OfficeFloor floor = floor_of({});
  EXPECT_GE(floor.area_m2, 5000.0);
  EXPECT_LT(floor.area_m2, 6000.0);
  EXPECT_GT(floor.rooms, 80U);
  EXPECT_GT(floor.visited_rooms, floor.rooms / 10);
  const auto rough_walls = std::ranges::count(floor.walls, rough, &Wall::material);
  EXPECT_GT(rough_walls, static_cast<std::ptrdiff_t>(floor.walls.size() / 5));
  EXPECT_LT(rough_walls, static_cast<std::ptrdiff_t>(floor.walls.size() * 4 / 5));
  EXPECT_NEAR(least_clearance_m(floor, world_of(floor)), 0.45, 1e-9) << "the middle of a door of 0.9 m";
  EXPECT_LT(length_m(floor), 1500.0);
}

TEST(OfficeFloor, TheTourPassesEveryCrossing) {
  const OfficePlan plan{
      .column_x = {1, 20, 40}, .row_y = {1, 10, 20, 30}, .doors = std::vector<std::vector<OfficeDoor>>(8)};
  const std::vector<Vec2> tour = office_tour(plan);
  const auto passes = [&](Vec2 a, Vec2 b) {  // both ways, and legs that go on beyond
    for (std::size_t i = 1; i < tour.size(); ++i) {
      const Vec2 low{std::min(tour[i - 1].x, tour[i].x), std::min(tour[i - 1].y, tour[i].y)};
      const Vec2 high{std::max(tour[i - 1].x, tour[i].x), std::max(tour[i - 1].y, tour[i].y)};
      if (low.x <= a.x && low.y <= a.y && high.x >= b.x && high.y >= b.y) return true;
    }
    return false;
  };
  for (std::size_t c = 0; c < plan.column_x.size(); ++c)
    for (std::size_t r = 0; r < plan.row_y.size(); ++r) {
      const Vec2 at{plan.column_x[c], plan.row_y[r]};
      EXPECT_TRUE(c + 1 == plan.column_x.size() || passes(at, {plan.column_x[c + 1], at.y})) << c << ' ' << r;
      EXPECT_TRUE(r + 1 == plan.row_y.size() || passes(at, {at.x, plan.row_y[r + 1]})) << c << ' ' << r;
    }
  for (std::size_t i = 1; i < tour.size(); ++i)
    EXPECT_TRUE(tour[i].x == tour[i - 1].x || tour[i].y == tour[i - 1].y) << "the tour keeps to the corridors";
}

TEST(OfficeFloor, TheTourEntersTheChosenRooms) {
  OfficePlan plan{.column_x = {1, 20}, .row_y = {5}, .doors = {{}}};
  plan.doors[0] = {{{4, 5}, {4, 8}, true}, {{9, 5}, {9, 2}, false}, {{12, 5}, {12, 2}, true}};
  const std::vector<Vec2> expected{{1, 5}, {4, 5}, {4, 8}, {4, 5}, {12, 5}, {12, 2}, {12, 5}, {20, 5}};
  EXPECT_EQ(office_tour(plan), expected);
}

TEST(OfficeFloor, TheSameSeedGivesTheSameFloor) {
  const OfficeFloor a = floor_of({.seed = 3});
  const OfficeFloor b = floor_of({.seed = 3});
  const OfficeFloor c = floor_of({.seed = 4});
  const auto same = [](const Wall& v, const Wall& w) { return v.a == w.a && v.b == w.b && v.material == w.material; };
  EXPECT_TRUE(std::ranges::equal(a.walls, b.walls, same));
  EXPECT_FALSE(std::ranges::equal(a.walls, c.walls, same));
  EXPECT_EQ(a.tour.size(), b.tour.size());
}

RC_GTEST_PROP(OfficeFloor, AnyFloorHasItsAreaAndATourClearOfWalls, ()) {
  const OfficeFloorOptions options{.area_m2 = *rc::gen::inRange(100, 2500) * 1.0,
                                   .corridor_m = *rc::gen::inRange(12, 30) * 0.1,
                                   .door_m = *rc::gen::inRange(60, 110) * 0.01,
                                   .wall_m = *rc::gen::inRange(5, 40) * 0.01,
                                   .room_depth_m = *rc::gen::inRange(20, 90) * 0.1,
                                   .room_width_m = *rc::gen::inRange(30, 90) * 0.1,
                                   .block_m = *rc::gen::inRange(10, 40) * 1.0,
                                   .visited_share = 1.0,
                                   .seed = *rc::gen::inRange(0, 1000)};
  const OfficeFloor floor = floor_of(options);
  RC_ASSERT(floor.area_m2 >= options.area_m2 * (1.0 - 1e-12));
  RC_ASSERT(floor.visited_rooms == floor.rooms);
  RC_ASSERT(least_clearance_m(floor, world_of(floor)) > 0.5 * options.door_m - 1e-9);
}

TEST(OfficeFloor, AHugeFloorIsMadeOrRefusedAtOnce) {
  const OfficeFloor floor = floor_of({.area_m2 = 3e6, .visited_share = 0.0});
  EXPECT_GT(floor.walls.size(), 400'000U);
  EXPECT_LE(floor.walls.size(), World::max_walls);
  const auto refused = make_office_floor({.area_m2 = 1e7, .room_depth_m = 2.0, .room_width_m = 3.0}, smooth, rough);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
}

TEST(OfficeFloor, RefusesDoorsThatDoNotFit) {
  EXPECT_EQ(make_office_floor({.door_m = 2.0, .room_width_m = 3.0}, smooth, rough).error().where, "door_m");
  EXPECT_EQ(make_office_floor({.corridor_m = 1.0, .door_m = 1.2}, smooth, rough).error().where, "corridor_m");
  EXPECT_EQ(make_office_floor({.block_m = 5.0}, smooth, rough).error().where, "block_m");
  EXPECT_FALSE(make_office_floor({.area_m2 = -1.0}, smooth, rough));
}

}  // namespace
}  // namespace echoarc::sim
