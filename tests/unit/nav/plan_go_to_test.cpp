// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <gtest/gtest.h>

#include "echoarc/nav/go_to.hpp"
#include "unit/nav/plan_drives.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

/// A room of 6 m by 4 m, walls around it and one across with a door at the top.
DenseGrid<CellState> two_rooms() {
  DenseGrid<CellState> map = free_map(60, 40, 0.1);
  occupy(map, {{0.0, 0.0}, {0.1, 4.0}});
  occupy(map, {{5.9, 0.0}, {6.0, 4.0}});
  occupy(map, {{0.0, 0.0}, {6.0, 0.1}});
  occupy(map, {{0.0, 3.9}, {6.0, 4.0}});
  occupy(map, {{3.0, 0.0}, {3.1, 2.8}});
  return map;
}

Drive in_two_rooms(double sight_m = 2.0) {
  return {.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, degrees(90.0)}, .sight_m = sight_m};
}

void expect_halted_for_ever(Drive& drive, Strategy& strategy) {
  const Steering ended = drive.steering;
  drive.time_s += 10.0;
  drive.once(strategy);
  EXPECT_EQ(drive.steering.wanted, RobotVelocity{});
  EXPECT_EQ(drive.steering.status, ended.status);
  EXPECT_EQ(drive.steering.reason, ended.reason);
}

TEST(GoTo, GoesThroughADoorThatItHasNotSeen) {
  Drive drive = in_two_rooms();
  GoTo go_to({{5.0, 1.0}}, {});
  EXPECT_EQ(go_to.name(), "goto");
  drive.run(go_to, 120.0);
  EXPECT_EQ(drive.steering.status, Status::finished) << drive.steering.reason;
  EXPECT_EQ(drive.steering.reason, "arrived");
  EXPECT_LT(norm(drive.T_world_base.position - Vec2{5.0, 1.0}), 0.1);
  EXPECT_GT(drive.nearest_m, 0.225);
  expect_halted_for_ever(drive, go_to);
}

TEST(GoTo, GoesToOneGoalAfterTheOther) {
  Drive drive = in_two_rooms();
  GoTo go_to({{2.0, 1.0}, {2.0, 3.0}, {1.0, 1.0}}, {}, {}, {}, "manual-script");
  EXPECT_EQ(go_to.name(), "manual-script");
  drive.once(go_to);
  EXPECT_EQ(go_to.sketch().nodes.size(), 3U);
  drive.run(go_to, 120.0);
  EXPECT_EQ(drive.steering.reason, "arrived");
  EXPECT_LT(norm(drive.T_world_base.position - Vec2{1.0, 1.0}), 0.1);
  EXPECT_EQ(go_to.sketch().nodes.size(), 1U);
  EXPECT_FALSE(go_to.sketch().path.empty());
}

TEST(GoTo, LetsAvoidanceSteer) {
  Drive drive = in_two_rooms();
  int asked = 0;
  const RobotBody body;
  GoTo go_to({{2.0, 3.0}}, body, {}, [&](const Surroundings& surroundings, Vec2 target) {
    ++asked;
    return steer_to(surroundings.T_world_base, target, 10.0, body.limits, {.speed_m_s = 0.2});
  });
  drive.run(go_to, 120.0);
  EXPECT_EQ(drive.steering.reason, "arrived");
  EXPECT_GT(asked, 50);
}

struct Case {
  Vec2 goal;
  std::string_view reason;
};

TEST(GoTo, SaysWhyItCannotGo) {
  DenseGrid<CellState> map = two_rooms();
  occupy(map, {{3.0, 2.8}, {3.1, 4.0}});
  const double nan = std::nan("");
  for (const Case& c : {Case{{5.0, 1.0}, "the goal cannot be reached"}, Case{{3.05, 1.0}, "the goal is in a wall"},
                        Case{{50.0, 1.0}, "the goal is off the map"}, Case{{nan, 1.0}, "the goal is not a number"}}) {
    Drive drive{.truth = map, .T_world_base = {{1.0, 1.0}, {}}, .sight_m = 0.0, .known = map, .version = 1};
    GoTo go_to({c.goal}, {});
    drive.run(go_to, 60.0);
    EXPECT_EQ(drive.steering.status, Status::failed);
    EXPECT_EQ(drive.steering.reason, c.reason);
    expect_halted_for_ever(drive, go_to);
  }
}

TEST(GoTo, WaitsForAMapThenGivesUp) {
  Drive drive{.truth = two_rooms(), .T_world_base = {{1.0, 1.0}, {}}, .sight_m = 0.0};
  GoTo go_to({{5.0, 1.0}}, {});
  drive.once(go_to);
  EXPECT_EQ(drive.steering.status, Status::running);
  EXPECT_EQ(drive.steering.wanted.forward_m_s, 0.0);
  drive.run(go_to, 30.0);
  EXPECT_EQ(drive.steering.reason, "there is no map");
}

TEST(GoTo, StopsWhenThePoseJumpsOrIsNone) {
  for (const Vec2 elsewhere : {Vec2{5.0, 3.0}, Vec2{std::nan(""), 0.0}}) {
    Drive drive = in_two_rooms();
    GoTo go_to({{2.0, 3.0}}, {});
    drive.run(go_to, 2.0);
    ASSERT_EQ(drive.steering.status, Status::running);
    drive.T_world_base.position = elsewhere;
    drive.once(go_to);
    EXPECT_EQ(drive.steering.status, Status::failed);
    EXPECT_FALSE(drive.steering.reason.empty());
    EXPECT_EQ(drive.steering.wanted, RobotVelocity{});
  }
}

TEST(GoTo, GivesUpWithoutProgress) {
  Drive drive = in_two_rooms();
  GoTo go_to({{2.0, 3.0}}, {}, {}, [](const Surroundings&, Vec2) { return RobotVelocity{}; });
  drive.run(go_to, 60.0);
  EXPECT_EQ(drive.steering.status, Status::failed);
  EXPECT_EQ(drive.steering.reason, "it gets no nearer");
  EXPECT_NEAR(drive.time_s, 20.0, 2.0);
}

TEST(GoTo, WithoutAGoalItHasArrived) {
  Drive drive = in_two_rooms();
  GoTo go_to({}, {});
  drive.once(go_to);
  EXPECT_EQ(drive.steering.status, Status::finished);
}

}  // namespace
}  // namespace echoarc::nav
