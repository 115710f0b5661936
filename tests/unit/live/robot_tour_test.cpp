// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "robot_fixture.hpp"

namespace echoarc::live {
namespace {

TEST(Tour, RunsThroughEveryBuiltInSceneWithoutTouchingAnything) {
  int scenes = 0;
  for (const io::BuiltinText& text : io::builtin_scenes()) {
    Driven driven(scene_named(text.name));
    if (driven.robot.source().description().tour.empty()) continue;
    ++scenes;
    driven.control().tour();
    driven.run(60.0);
    EXPECT_EQ(driven.simulation().contacts(), 0U) << text.name;
    EXPECT_GT(driven.simulation().travelled_m(), 1.5) << text.name;
    EXPECT_EQ(driven.control().state().mode, Mode::tour) << text.name;
  }
  EXPECT_GT(scenes, 10);
}

/// Smallest distance from a place to the robot's way while it drives on.
std::vector<double> nearest_to(Driven& driven, const std::vector<Vec2>& places, double duration_s) {
  std::vector<double> nearest_m(places.size(), 1e9);
  driven.run(duration_s, [&] {
    for (std::size_t k = 0; k < places.size(); ++k)
      nearest_m[k] = std::min(nearest_m[k], norm(driven.place() - places[k]));
  });
  return nearest_m;
}

TEST(Tour, ReachesItsStationsThereAndBack) {
  sim::Scene scene = plain_room();
  scene.drive.legs = {{.to = Vec2{3.0, 2.0}}, {.to = Vec2{3.0, 3.0}}};
  Driven driven(scene);
  driven.control().tour();
  for (const double distance_m : nearest_to(driven, {{3.0, 2.0}, {3.0, 3.0}}, 25.0)) EXPECT_LT(distance_m, 0.05);
  for (const double distance_m : nearest_to(driven, {{3.0, 2.0}, {1.0, 2.0}}, 30.0)) EXPECT_LT(distance_m, 0.05);
  EXPECT_EQ(driven.simulation().contacts(), 0U);
}

TEST(Tour, RouteGoesRoundIfItIsClosed) {
  Route round({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}});
  EXPECT_EQ(round.goal({0.9, 0.1}), (Vec2{1.0, 0.0}));
  EXPECT_EQ(round.next_goal(), (Vec2{1.0, 1.0}));
  EXPECT_EQ(round.next_goal(), (Vec2{0.0, 0.0}));
  EXPECT_EQ(round.next_goal(), (Vec2{1.0, 0.0}));
  round.turn_back();
  EXPECT_EQ(round.goal({}), (Vec2{0.0, 0.0}));

  Route line({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}});
  EXPECT_EQ(line.goal({1.9, 0.0}), (Vec2{2.0, 0.0}));
  EXPECT_EQ(line.next_goal(), (Vec2{1.0, 0.0}));
  EXPECT_EQ(line.next_goal(), (Vec2{0.0, 0.0}));
  EXPECT_EQ(line.next_goal(), (Vec2{1.0, 0.0}));
  EXPECT_FALSE(Route({{0.0, 0.0}}).stations());
}

TEST(GoTo, ArrivesWithinFiveCentimetres) {
  Driven driven(plain_room());
  driven.control().go_to({4.0, 1.2});
  driven.run(30.0);
  EXPECT_EQ(driven.control().state().mode, Mode::stand);
  EXPECT_EQ(driven.control().state().reason, Reason::arrived);
  EXPECT_LT(norm(driven.place() - Vec2{4.0, 1.2}), 0.05);
  EXPECT_EQ(driven.speed_m_s(), 0.0);
}

TEST(GoTo, IsBlockedByAWall) {
  sim::Scene scene = plain_room();
  scene.world.walls.push_back({.a = {2.5, 0.5}, .b = {2.5, 3.5}});
  Driven driven(scene);
  driven.control().go_to({4.0, 2.0});
  driven.run(30.0);
  EXPECT_EQ(driven.control().state().mode, Mode::stand);
  EXPECT_EQ(driven.control().state().reason, Reason::blocked);
  EXPECT_EQ(driven.simulation().contacts(), 0U);
  EXPECT_GT(driven.place().x, 2.0);
}

TEST(GoTo, TakesNoPointThatIsNone) {
  Driven driven(plain_room());
  driven.control().go_to({std::numeric_limits<double>::quiet_NaN(), 1.0});
  driven.run(1.0);
  EXPECT_EQ(driven.control().state().mode, Mode::stand);
  EXPECT_EQ(driven.simulation().travelled_m(), 0.0);
}

}  // namespace
}  // namespace echoarc::live
