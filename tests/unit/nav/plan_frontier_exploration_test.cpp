// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <gtest/gtest.h>

#include "echoarc/nav/frontier_exploration.hpp"
#include "unit/nav/plan_drives.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

void enclose(DenseGrid<CellState>& map, const Box& box) {
  const double wall_m = 0.1;
  occupy(map, {box.low, {box.low.x + wall_m, box.high.y}});
  occupy(map, {{box.high.x - wall_m, box.low.y}, box.high});
  occupy(map, {box.low, {box.high.x, box.low.y + wall_m}});
  occupy(map, {{box.low.x, box.high.y - wall_m}, box.high});
}

/// Two rooms with a door between them.
DenseGrid<CellState> two_rooms() {
  DenseGrid<CellState> map = free_map(80, 50);
  enclose(map, {{0.0, 0.0}, {8.0, 5.0}});
  occupy(map, {{4.0, 0.0}, {4.1, 3.0}});
  occupy(map, {{4.0, 4.0}, {4.1, 5.0}});
  return map;
}

double known_share(const Drive& drive) {
  std::size_t free = 0;
  std::size_t found = 0;
  for (std::size_t k = 0; k < drive.truth.values().size(); ++k)
    if (drive.truth.values()[k] == CellState::free) {
      ++free;
      found += drive.known.values()[k] == CellState::free ? 1 : 0;
    }
  return double(found) / double(free);
}

TEST(FrontierExploration, SeesTwoRoomsAndFinishes) {
  Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
  FrontierExploration exploration({});
  EXPECT_EQ(exploration.name(), "frontier");
  drive.run(exploration, 600.0);
  EXPECT_EQ(drive.steering.status, Status::finished);
  EXPECT_EQ(drive.steering.reason, "no frontier is left");
  EXPECT_GT(known_share(drive), 0.99);
  EXPECT_GT(drive.nearest_m, 0.225);
  EXPECT_TRUE(exploration.inaccessible().empty());
  drive.once(exploration);
  EXPECT_EQ(drive.steering.wanted, RobotVelocity{});
  EXPECT_EQ(drive.steering.status, Status::finished);
}

TEST(FrontierExploration, BeginsWhenTheMapComes) {
  Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
  FrontierExploration exploration({}, {.sweep_at_start = false});
  while (drive.time_s < 2.9) drive.once(exploration);
  ASSERT_EQ(drive.steering.status, Status::running);
  drive.known = DenseGrid<CellState>(drive.truth.geometry(), 80, 50);  // nothing heard yet
  for (int k = 0; k < 5; ++k) drive.once(exploration);
  ASSERT_EQ(drive.steering.status, Status::running) << "what it waited for a map does not count";
  drive.run(exploration, 600.0);
  EXPECT_EQ(drive.steering.reason, "no frontier is left");
}

TEST(FrontierExploration, ShowsWhatItHasInMind) {
  Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
  FrontierExploration exploration({}, {.sweep_at_start = false});
  drive.run(exploration, 1.0);
  const Sketch sketch = exploration.sketch();
  ASSERT_GE(sketch.nodes.size(), 2U);
  EXPECT_EQ(sketch.nodes.front().kind, "frontier");
  EXPECT_EQ(sketch.nodes.back().kind, "goal");
  EXPECT_GE(sketch.path.size(), 2U);
}

TEST(FrontierExploration, TheSameSurroundingsGiveTheSameSteering) {
  const auto end = [] {
    Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
    FrontierExploration exploration({});
    drive.run(exploration, 600.0);
    return std::pair(drive.T_world_base, drive.time_s);
  };
  EXPECT_EQ(end(), end());
}

/// A slit of 0.3 m, through which one sees but no robot of 0.45 m gets.
TEST(FrontierExploration, SaysThatTheRestIsInaccessible) {
  DenseGrid<CellState> map = two_rooms();
  occupy(map, {{4.0, 3.3}, {4.1, 4.0}});
  Drive drive{.truth = map, .T_world_base = {{1.0, 1.0}, {}}, .sight_m = 3.0};
  FrontierExploration exploration({});
  drive.run(exploration, 600.0);
  EXPECT_EQ(drive.steering.status, Status::finished);
  EXPECT_EQ(drive.steering.reason, "the rest is inaccessible");
  EXPECT_LT(known_share(drive), 0.9);
}

TEST(FrontierExploration, GivesAFrontierUpWithoutProgress) {
  Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
  const auto stuck = [](const Surroundings&, Vec2) { return RobotVelocity{}; };
  FrontierExploration exploration({}, {.sweep_at_start = false}, stuck);
  drive.run(exploration, 25.0);
  EXPECT_EQ(exploration.inaccessible().size(), 1U);
  drive.run(exploration, 2000.0);
  EXPECT_EQ(drive.steering.status, Status::finished);
  EXPECT_EQ(drive.steering.reason, "the rest is inaccessible");
  EXPECT_TRUE(exploration.visited().empty());
  for (const Vec2 a : exploration.inaccessible())
    for (const Vec2 b : exploration.inaccessible()) EXPECT_TRUE(a == b || norm(a - b) > 0.5);
}

TEST(FrontierExploration, TurnsRoundOnceFirst) {
  Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
  FrontierExploration exploration({});
  Angle turned;
  while (drive.time_s < 60.0 && (drive.steering.reason.empty() || drive.steering.reason == "looking about")) {
    turned += Drive::step_s * drive.steering.wanted.turn_per_s;
    drive.run(exploration, Drive::step_s);
    ASSERT_EQ(drive.steering.wanted.forward_m_s > 0.0 && drive.steering.reason == "looking about", false);
  }
  EXPECT_NEAR(turned.deg(), 360.0, 10.0);
}

TEST(FrontierExploration, SaysWhyItCannotBegin) {
  DenseGrid<CellState> cage = free_map(80, 50);
  enclose(cage, {{0.7, 0.7}, {1.4, 1.4}});
  const Pose2 T_world_base{{1.05, 1.05}, {}};
  struct Case {
    DenseGrid<CellState> map;
    std::string_view reason;
  };
  for (const Case& c :
       {Case{cage, "the robot is boxed in"},
        Case{DenseGrid<CellState>({0.1, {}}, 80, 50), "the map shows nothing free"},
        Case{free_map(20, 20, 0.1, {5.0, 5.0}), "the robot is off the map"}, Case{{}, "there is no map"}}) {
    Drive drive{.truth = cage, .T_world_base = T_world_base, .sight_m = 0.0, .known = c.map, .version = 1};
    FrontierExploration exploration({});
    drive.run(exploration, 120.0);
    EXPECT_EQ(drive.steering.status, Status::failed) << c.reason;
    EXPECT_EQ(drive.steering.reason, c.reason);
    EXPECT_EQ(drive.steering.wanted, RobotVelocity{});
  }
}

TEST(FrontierExploration, StopsWhenThePoseJumpsOrIsNone) {
  for (const Vec2 elsewhere : {Vec2{7.0, 4.0}, Vec2{std::nan(""), 0.0}}) {
    Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}};
    FrontierExploration exploration({});
    drive.run(exploration, 2.0);
    drive.T_world_base.position = elsewhere;
    drive.once(exploration);
    EXPECT_EQ(drive.steering.status, Status::failed);
    EXPECT_EQ(drive.steering.wanted, RobotVelocity{});
    EXPECT_FALSE(drive.steering.reason.empty());
  }
}

TEST(FrontierExploration, OptionsAreLegal) {
  EXPECT_TRUE(validate(FrontierExplorationOptions{}));
  EXPECT_TRUE(validate(GoToOptions{}));
  EXPECT_TRUE(validate(ReplannerOptions{}));
  EXPECT_TRUE(validate(PathFollowerOptions{}));
}

}  // namespace
}  // namespace echoarc::nav
