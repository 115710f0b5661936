// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "echoarc/eval/directions.hpp"
#include "echoarc/io/builtin.hpp"
#include "echoarc/io/robot_toml.hpp"
#include "echoarc/io/scene_toml.hpp"

namespace echoarc::io {
namespace {

SceneFile scene_of(std::string_view name) {
  const auto text = builtin_scene(name);
  EXPECT_TRUE(text) << name;
  const auto scene = read_scene(text.value_or(""), name);
  EXPECT_TRUE(scene) << scene.error().where << ": " << scene.error().message << "; " << scene.error().remedy;
  return scene ? *scene : SceneFile{};
}

TEST(BuiltinScenes, AllAreRead) {
  EXPECT_GE(builtin_scenes().size(), 2U);
  std::set<std::string> names;
  for (const BuiltinText& scene : builtin_scenes()) {
    const SceneFile file = scene_of(scene.name);
    EXPECT_EQ(file.scene.name, scene.name) << "the name of a scene is that of its file";
    EXPECT_FALSE(file.scene.title.empty()) << scene.name;
    EXPECT_TRUE(names.insert(file.scene.name).second) << scene.name;
    EXPECT_TRUE(scene.text.starts_with("# ")) << scene.name << " opens with what it shows";
  }
  EXPECT_FALSE(builtin_scene("no such scene"));
}

TEST(BuiltinScenes, AllRobotsAreRead) {
  EXPECT_GE(builtin_robots().size(), 7U);
  for (const BuiltinText& text : builtin_robots()) {
    const auto robot = parse_robot_toml(text.text, text.name);
    ASSERT_TRUE(robot) << robot.error().where << ": " << robot.error().message;
    EXPECT_EQ(robot->name, text.name);
    EXPECT_GT(robot->radius_m, 0.0);
  }
  EXPECT_FALSE(builtin_robot("no such robot"));
}

/// Straight legs, sampled every 2 cm: the robot's body touches nothing that stands.
TEST(BuiltinScenes, DrivesStayClearOfWalls) {
  for (const BuiltinText& text : builtin_scenes()) {
    const sim::Scene scene = scene_of(text.name).scene;
    const auto world = sim::World::make(scene.world);
    ASSERT_TRUE(world) << text.name;
    Vec2 at = scene.drive.start.position;
    EXPECT_GE(world->clearance(at, 1.0), scene.robot.radius_m) << text.name << " starts in a wall";
    for (const sim::DriveLeg& leg : scene.drive.legs) {
      if (!leg.to) continue;
      const Vec2 way = *leg.to - at;
      const int steps = static_cast<int>(norm(way) / 0.02) + 1;
      double least_m = 1.0;
      for (int i = 1; i <= steps; ++i) least_m = std::min(least_m, world->clearance(at + way * (1.0 * i / steps), 1.0));
      EXPECT_GE(least_m, scene.robot.radius_m) << text.name << ", leg to " << leg.to->x << ", " << leg.to->y;
      EXPECT_TRUE(world->visible(at, *leg.to)) << text.name;
      at = *leg.to;
    }
  }
}

/// How many lines of a span no surface of the world crosses.
TEST(BuiltinScenes, RoomAHasTheDirectionsOfThePaper) {
  const SceneFile file = scene_of("room-a");
  ASSERT_TRUE(file.scoring);
  const DirectionSet directions = wall_directions(file.scoring->walls, file.scoring->region, file.scoring->cell_m);
  EXPECT_EQ(directions.line_count(), 240 + 320 + 240 + 320);
  int empty = 0;
  for (const LineFamily& family : directions.families)
    for (std::int32_t k = 0; k < family.count; ++k) {
      bool full = false;
      for (const sim::Wall& wall : file.scene.world.walls) {
        const double low = (k + 0.0) * family.width_m;
        const double high = (k + 1.0) * family.width_m;
        const double a = dot(wall.a - family.corner, family.across);
        const double b = dot(wall.b - family.corner, family.across);
        const double depth =
            std::max(dot(wall.a - family.corner, family.along), dot(wall.b - family.corner, family.along));
        full = full || (depth > 0.0 && std::min(a, b) < high - 1e-6 && std::max(a, b) > low + 1e-6);
      }
      empty += full ? 0 : 1;
    }
  EXPECT_EQ(empty, 90 + 71) << "doorway and gap";
}

}  // namespace
}  // namespace echoarc::io
