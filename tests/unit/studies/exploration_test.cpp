// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/exploration.hpp"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/executor.hpp"
#include "echoarc/nav/strategies.hpp"

namespace echoarc::studies {
namespace {

/// A room of 4 x 3 m, and a second one beside it to which no way leads.
sim::Scene two_rooms() {
  sim::Scene scene;
  scene.name = "rooms";
  const auto room = [&](double x) {
    const Vec2 corners[] = {{x, 0.0}, {x + 4.0, 0.0}, {x + 4.0, 3.0}, {x, 3.0}};
    for (std::size_t k = 0; k < 4; ++k) scene.world.walls.push_back({.a = corners[k], .b = corners[(k + 1) % 4]});
  };
  room(0.0);
  room(5.0);
  scene.robot.radius_m = 0.2;
  scene.robot.sensors = SensorArray::make(ring(16, 0.15, Angle{}, SensorModel{})).value();
  scene.drive.start = {{1.0, 1.0}, Angle{}};
  return scene;
}

ExplorationRequest request(double limit_s) {
  ExplorationRequest request;
  request.scene = two_rooms();
  request.strategy = "wall-left";
  request.make_strategy = [] {
    return nav::make_strategy("wall-left", {.body = {.radius_m = 0.2, .limits = {}}, .goals = {}}).value();
  };
  request.limit_s = limit_s;
  request.goals = {{1.0, 1.0}, {7.0, 1.0}};
  request.keep_log = true;
  return request;
}

struct Host {
  InlineExecutor executor;
  StudyHost host;
  Host() {
    host.executor = &executor;
    host.seeds = 2;
  }
};

TEST(ReachableFloor, IsTheRoomOfTheStartButForItsCorners) {
  const sim::Scene scene = two_rooms();
  const ReachableFloor floor(scene.world, {1.0, 1.0}, 0.2, 0.05);
  // But for a cell's breadth along 14 m of walls, and corners that a disc does not fill.
  EXPECT_NEAR(floor.area_m2(), 4.0 * 3.0 - 14.0 * 0.05, 0.1);
  EXPECT_TRUE(floor.contains({2.0, 1.5}));
  EXPECT_FALSE(floor.contains({7.0, 1.5}));
  EXPECT_FALSE(floor.contains({0.02, 0.02}));
  EXPECT_EQ(ReachableFloor(scene.world, {0.0, 1.0}, 0.2).area_m2(), 0.0) << "a start on a wall";
}

TEST(ReachableFloor, CoverageCountsFreeCellsOfTheMapAlone) {
  const ReachableFloor floor(two_rooms().world, {1.0, 1.0}, 0.2, 0.1);
  DenseGrid<CellState> map({.cell_m = 0.1, .origin = {0.0, 0.0}}, 40, 30, CellState::unknown);
  EXPECT_EQ(floor.covered(map), 0.0);
  for (std::int32_t j = 0; j < 30; ++j)
    for (std::int32_t i = 0; i < 20; ++i) map.at({i, j}) = CellState::free;
  EXPECT_NEAR(floor.covered(map), 0.5, 0.05);
  std::ranges::fill(map.values(), CellState::free);
  EXPECT_EQ(floor.covered(map), 1.0);
  std::ranges::fill(map.values(), CellState::occupied);
  EXPECT_EQ(floor.covered(map), 0.0);
}

TEST(Exploration, SameSeedSameRunByteForByte) {
  Host host;
  const auto first = explore_seeds(request(20.0), host.host);
  const auto again = explore_seeds(request(20.0), host.host);
  ASSERT_TRUE(first && again);
  for (std::size_t k = 0; k < 2; ++k) {
    const ExplorationRun& a = (*first)[k];
    const ExplorationRun& b = (*again)[k];
    EXPECT_EQ(a.travelled_m, b.travelled_m);
    ASSERT_EQ(a.log.truth.size(), b.log.truth.size());
    for (std::size_t i = 0; i < a.log.truth.size(); ++i)
      EXPECT_EQ(a.log.truth[i].T_world_robot, b.log.truth[i].T_world_robot);
    EXPECT_TRUE(std::ranges::equal(a.map.values(), b.map.values()));
  }
  EXPECT_NE((*first)[0].travelled_m, (*first)[1].travelled_m) << "other seeds, other noise";
}

TEST(Exploration, TellsHowNearItCameToItsGoalsAndHowMuchItCovered) {
  Host host;
  const auto runs = explore_seeds(request(60.0), host.host);
  ASSERT_TRUE(runs);
  const ExplorationRun& run = runs->front();
  EXPECT_LT(run.goal_distance_m[0], 0.01) << "it started there";
  EXPECT_GT(run.goal_distance_m[1], 3.0) << "behind walls";
  EXPECT_GT(run.coverage.back().covered, 0.9);
  EXPECT_LE(run.coverage.front().covered, run.coverage.back().covered);
  EXPECT_EQ(run.collisions, 0U);
  EXPECT_GT(run.least_clearance_m, 0.0);
}

TEST(Exploration, RunThatTakesTooLongIsStoppedAndSaysSo) {
  Host host;
  const auto runs = explore_seeds(request(3.0), host.host);
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->front().status, nav::Status::running);
  EXPECT_NE(runs->front().reason.find("time was over"), std::string::npos);
}

TEST(Exploration, CancellationIsAnError) {
  Host host;
  host.host.cancelled = [] { return true; };
  const auto runs = explore_seeds(request(60.0), host.host);
  ASSERT_FALSE(runs);
  EXPECT_EQ(runs.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace echoarc::studies
