// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/nav/voronoi_exploration.hpp"
#include "unit/nav/voronoi_world.hpp"

namespace echoarc::nav {
namespace {

using voronoi_world::drive;
using voronoi_world::Drive;
using voronoi_world::rectangle;
using voronoi_world::Wall;
using voronoi_world::World;

/// Failed for the named reason, wants a halt, and goes on to want one.
void expect_failed(VoronoiExploration& explorer, const Drive& run, const std::string& word) {
  EXPECT_EQ(run.last.status, Status::failed);
  EXPECT_NE(run.last.reason.find(word), std::string::npos) << run.last.reason;
  EXPECT_EQ(run.last.wanted, RobotVelocity{});
  const Steering later = explorer.update({});
  EXPECT_EQ(later.status, Status::failed);
  EXPECT_EQ(later.reason, run.last.reason);
  EXPECT_EQ(later.wanted, RobotVelocity{});
}

TEST(VoronoiBadInput, BoxedIn) {
  World world(rectangle({-0.3, -0.3}, {0.3, 0.3}));
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {}, {}, 120);
  expect_failed(explorer, run, "boxed in");
  EXPECT_GT(run.least_clearance_m, 0.24);
}

TEST(VoronoiBadInput, SilentSensors) {
  World world({});
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {}, {}, 60);
  expect_failed(explorer, run, "silent");
  EXPECT_EQ(run.length_m, 0.0);
}

TEST(VoronoiBadInput, SensorsGoSilentOnTheWay) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 120, [](Surroundings& now) {
    if (now.time_s > 20) now.points = {};
  });
  expect_failed(explorer, run, "silent");
  EXPECT_GT(run.least_clearance_m, 0.25);
}

TEST(VoronoiBadInput, PointsThatAreNoNumbersAreSilence) {
  World world({});
  VoronoiExploration explorer(RobotBody{});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec2> points{{nan, 0}, {0, nan}};
  const Drive run = drive(explorer, world, {}, {}, 60, [&](Surroundings& now) { now.points = points; });
  expect_failed(explorer, run, "silent");
}

TEST(VoronoiBadInput, SomePointsThatAreNoNumbersDoNotMatter) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  std::vector<Vec2> points;
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 400, [&](Surroundings& now) {
    points.assign(now.points.begin(), now.points.end());
    points.push_back({std::nan(""), 1.0});
    now.points = points;
  });
  EXPECT_EQ(run.last.status, Status::finished) << run.last.reason;
  EXPECT_EQ(explorer.graph().edges().size(), 5u);
}

TEST(VoronoiBadInput, PoseThatIsNoNumber) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 60, [](Surroundings& now) {
    if (now.time_s > 12) now.T_world_base.heading = radians(std::nan(""));
  });
  expect_failed(explorer, run, "pose is not a number");
}

TEST(VoronoiBadInput, PoseJump) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 60, [](Surroundings& now) {
    if (now.time_s > 12) now.T_world_base.position.x += 1.0;
  });
  expect_failed(explorer, run, "jumped by");
  VoronoiExploration turned(RobotBody{});
  const Drive other = drive(turned, world, {{1, 1.2}, {}}, {}, 60, [](Surroundings& now) {
    if (now.time_s > 12) now.T_world_base.heading += degrees(90);
  });
  expect_failed(turned, other, "heading jumped");
}

TEST(VoronoiBadInput, TimeRunsBackwards) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 60, [](Surroundings& now) {
    if (now.time_s > 12) now.time_s = 3;
  });
  expect_failed(explorer, run, "backwards");
}

TEST(VoronoiBadInput, RobotThatDoesNotTurn) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  RobotBody lame;
  lame.limits.turn_acceleration_per_s2 = Angle{};  // of the simulated one alone
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, lame, 60);
  expect_failed(explorer, run, "does not turn");
}

TEST(VoronoiBadInput, RobotThatDoesNotMove) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  RobotBody lame;
  lame.limits.acceleration_m_s2 = 0.0;
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, lame, 120);
  expect_failed(explorer, run, "no way");
}

TEST(VoronoiBadInput, SingleWallInViewIsLeftUntilNothingIsSeen) {
  World world({Wall{{-30, 0}, {30, 0}}}, {.spacing_m = 0.05});
  VoronoiExploration explorer(RobotBody{});
  const Drive run = drive(explorer, world, {{0, 1}, {}}, {}, 120);
  expect_failed(explorer, run, "too wide");
}

TEST(VoronoiBadInput, WayBackThatIsBlocked) {
  World world(rectangle({0, 0}, {5, 4}));
  VoronoiExploration explorer(RobotBody{});
  std::vector<Vec2> points;
  const Drive run = drive(explorer, world, {{1, 1.2}, {}}, {}, 600, [&](Surroundings& now) {
    if (explorer.graph().edges().size() < 2) return;  // then something stands right before it, wherever it turns
    for (int i = 0; i < 36; ++i) points.push_back(now.T_world_base.position + 0.24 * unit(degrees(10.0 * i)));
    now.points = points;
  });
  expect_failed(explorer, run, "");
}

}  // namespace
}  // namespace echoarc::nav
