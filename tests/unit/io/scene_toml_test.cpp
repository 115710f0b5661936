// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/scene_toml.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

SceneFile scene_of(std::string_view text) {
  const auto scene = read_scene(text, "s.toml");
  EXPECT_TRUE(scene) << scene.error().where << ": " << scene.error().message << "; " << scene.error().remedy;
  return scene ? *scene : SceneFile{};
}

/// A scene with a robot and what is under test.
SceneFile world_of(const std::string& text) {
  return scene_of("robot = \"nomad200\"\n" + text);
}

std::string material_of(const SceneFile& file, sim::MaterialId id) {
  return file.scene.world.materials.at(id).name;
}

TEST(SceneToml, TheSmallestSceneIsARobot) {
  const SceneFile file = scene_of(R"(robot = "nomad200")");
  EXPECT_EQ(file.scene.robot.sensors.size(), 16U);
  EXPECT_EQ(file.scene.robot.radius_m, 0.225);
  EXPECT_TRUE(file.scene.world.walls.empty());
  EXPECT_FALSE(file.scoring);
  EXPECT_EQ(file.scene.sonar.max_order, sim::SonarOptions{}.max_order);
}

TEST(SceneToml, NamesAndSeed) {
  const SceneFile file = world_of("name = \"n\"\ntitle = \"t\"\nsource = \"s\"\n[world]\nseed = 7");
  EXPECT_EQ(file.scene.name, "n");
  EXPECT_EQ(file.scene.title, "t");
  EXPECT_EQ(file.scene.source, "s");
  EXPECT_EQ(file.scene.world.seed, 7U);
}

TEST(SceneToml, WallsArePolylinesAndKnowTheirLines) {
  const SceneFile file = world_of(R"(
[[wall]]
points = [[0, 0], [4, 0],
          [4, 3]]
closed = true
one_sided = true
material = "brick"
[[wall]]
points = [[5, 5], [6.5, 5]]
)");
  const auto& walls = file.scene.world.walls;
  ASSERT_EQ(walls.size(), 4U);
  EXPECT_EQ(walls[0].a, (Vec2{0, 0}));
  EXPECT_EQ(walls[0].b, (Vec2{4, 0}));
  EXPECT_EQ(walls[0].line, 4U);
  EXPECT_EQ(walls[1].line, 5U);
  EXPECT_EQ(walls[2].b, (Vec2{0, 0})) << "closed";
  EXPECT_TRUE(walls[2].one_sided);
  EXPECT_EQ(material_of(file, walls[2].material), "brick");
  EXPECT_FALSE(walls[3].one_sided);
  EXPECT_EQ(material_of(file, walls[3].material), "wood") << "of objects that name none";
}

TEST(SceneToml, MaterialsAreBuiltInChangedAndNew) {
  const SceneFile file = world_of(R"(
[materials.wood]
loss_db = 2
[materials.felt]
loss_db = 9.5
rough_db = -12
rough_pitch_m = 0.1
laser_ok = false
[[disc]]
centre = [1, 1]
radius = 0.2
material = "felt"
)");
  const auto& materials = file.scene.world.materials;
  EXPECT_EQ(materials[0].loss_db, 2.0);
  const sim::Material& felt = materials.at(file.scene.world.discs.at(0).material);
  EXPECT_EQ(felt.loss_db, 9.5);
  EXPECT_EQ(felt.rough_db, -12.0);
  EXPECT_EQ(felt.rough_pitch_m, 0.1);
  EXPECT_FALSE(felt.laser_ok);
  for (const char* name : {"wood", "painted", "cardboard", "shade", "brick", "glass"})
    EXPECT_EQ(std::ranges::count(materials, name, &sim::Material::name), 1) << name;
}

TEST(SceneToml, BoxesTurn) {
  const SceneFile file = world_of("[[box]]\ncentre = [1, 2]\nsize = [2, 1]\nturn_deg = 90\n");
  const auto& walls = file.scene.world.walls;
  ASSERT_EQ(walls.size(), 4U);
  double right = -10.0;
  double top = -10.0;
  for (const sim::Wall& wall : walls) {
    right = std::max(right, wall.a.x);
    top = std::max(top, wall.a.y);
    EXPECT_EQ(wall.line, 2U);
  }
  EXPECT_NEAR(right, 1.5, 1e-12);
  EXPECT_NEAR(top, 3.0, 1e-12);
}

TEST(SceneToml, SlatsAlternateAndTheLastIsCut) {
  const SceneFile file =
      world_of("[[slats]]\nfrom = [0, 1]\nto = [0.4, 1]\nwidth = 0.15\nangle_deg = 6\nmaterial = \"shade\"\n");
  const auto& walls = file.scene.world.walls;
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_NEAR(norm(walls[0].b - walls[0].a), 0.15, 1e-12);
  EXPECT_NEAR(bearing(walls[0].b - walls[0].a).deg(), 6.0, 1e-9);
  EXPECT_NEAR(bearing(walls[1].b - walls[1].a).deg(), -6.0, 1e-9);
  EXPECT_NEAR(norm(walls[2].b - walls[2].a), 0.10, 1e-12);
  EXPECT_NEAR(0.5 * (walls[2].a.x + walls[2].b.x), 0.35, 1e-12);
  const SceneFile open = world_of("[[slats]]\nfrom = [0, 1]\nto = [1, 1]\nwidth = 0.1\npitch = 0.2\n");
  EXPECT_EQ(open.scene.world.walls.size(), 5U);
}

/// Steps of at most 2 mm, and no corner: neighbouring steps turn by little.
void expect_smooth(const std::vector<Vec2>& points) {
  ASSERT_GE(points.size(), 3U);
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_LE(norm(points[i] - points[i - 1]), 0.002 + 1e-12);
    if (i < 2) continue;
    const Vec2 before = points[i - 1] - points[i - 2];
    const Vec2 after = points[i] - points[i - 1];
    ASSERT_LT(std::abs(cross(before, after)), 0.1 * norm(before) * norm(after)) << i;
  }
}

TEST(SceneToml, CurvesAreSumsOfTerms) {
  const SceneFile file = world_of(R"(
[[curve]]
x = [-1.0, 1.0]
y = 1.0
cosines = [[0.16, 2.6, 0.5]]
sines = [[-0.07, 4.3, 0.0]]
polynomial = [0.0, 0.25, 0.5]
)");
  const auto& points = file.scene.world.curves.at(0).points;
  expect_smooth(points);
  EXPECT_EQ(points.front().x, -1.0);
  EXPECT_EQ(points.back().x, 1.0);
  for (const Vec2 p : points)
    ASSERT_NEAR(p.y, 1.0 + 0.16 * std::cos(2.6 * p.x + 0.5) - 0.07 * std::sin(4.3 * p.x) + 0.25 * p.x + 0.5 * p.x * p.x,
                1e-12);
}

TEST(SceneToml, CurvesArePartsOfCircles) {
  const SceneFile file = world_of("[[curve]]\ncentre = [1, 2]\nradius = 0.5\nfrom_deg = 180\nto_deg = 0\n");
  const auto& points = file.scene.world.curves.at(0).points;
  expect_smooth(points);
  EXPECT_NEAR(points.front().x, 0.5, 1e-12);
  EXPECT_NEAR(points.back().x, 1.5, 1e-12);
  for (const Vec2 p : points) ASSERT_NEAR(norm(p - Vec2{1, 2}), 0.5, 1e-12);
}

TEST(SceneToml, CurvesGoSmoothlyThroughTheirPoints) {
  const std::vector<Vec2> knots{{0, 0}, {0.5, 0.3}, {1.0, 0.25}, {1.5, 0.0}};
  const SceneFile file = world_of("[[curve]]\npoints = [[0, 0], [0.5, 0.3], [1.0, 0.25], [1.5, 0.0]]\n");
  const auto& points = file.scene.world.curves.at(0).points;
  expect_smooth(points);
  for (const Vec2 knot : knots) EXPECT_NE(std::ranges::find(points, knot), points.end());
}

TEST(SceneToml, DiscsAndMovingDiscs) {
  const SceneFile file = world_of(R"(
[[disc]]
centre = [3.75, 2.4]
radius_m = 0.15
[[moving]]
radius = 0.25
path = [[0, 1, 2], [2.5, 3, 2]]
)");
  EXPECT_EQ(file.scene.world.discs.at(0).radius_m, 0.15);
  EXPECT_EQ(file.scene.world.discs.at(0).line, 3U);
  const sim::MovingDisc& moving = file.scene.world.moving.at(0);
  EXPECT_EQ(moving.radius_m, 0.25);
  EXPECT_EQ(moving.path.at(1).time_s, 2.5);
  EXPECT_EQ(moving.path.at(1).centre, (Vec2{3, 2}));
}

TEST(SceneToml, OfficesBringATour) {
  const SceneFile file = world_of("[office]\narea_m2 = 300\nseed = 2\n");
  EXPECT_GT(file.scene.world.walls.size(), 40U);
  EXPECT_FALSE(file.scene.drive.legs.empty());
  EXPECT_EQ(file.scene.world.walls[0].line, 2U);
  const SceneFile own = world_of("[office]\narea_m2 = 300\n[drive]\nstart = [1, 6, 0]\nlegs = [[5, 6]]\n");
  EXPECT_EQ(own.scene.drive.legs.size(), 1U);
}

TEST(SceneToml, Drives) {
  const SceneFile file = world_of(R"(
[drive]
start = [1.0, 2.0, 90]
facing_deg = -90
keep_heading = true
stop_step_m = 0.025
stop_turn_deg = 1
speed_m_s = 0.127
acceleration_m_s2 = 0.25
turn_rate_deg = 30
turn_acceleration_deg = 60
dwell_s = 3
legs = [[1, 5],
        { to = [2, 5] }, { turn_deg = -45 }, { turn = 0.5 }]
)");
  const sim::Drive& drive = file.scene.drive;
  EXPECT_EQ(drive.start.position, (Vec2{1, 2}));
  EXPECT_NEAR(drive.start.heading.deg(), 90.0, 1e-12);
  EXPECT_NEAR(drive.facing.deg(), -90.0, 1e-12);
  EXPECT_TRUE(drive.keep_heading);
  EXPECT_EQ(drive.stop_step_m, 0.025);
  EXPECT_NEAR(drive.stop_turn.deg(), 1.0, 1e-12);
  EXPECT_EQ(drive.speed_m_s, 0.127);
  EXPECT_EQ(drive.acceleration_m_s2, 0.25);
  EXPECT_NEAR(drive.turn_rate_per_s.deg(), 30.0, 1e-12);
  EXPECT_NEAR(drive.turn_acceleration_per_s2.deg(), 60.0, 1e-12);
  EXPECT_EQ(drive.dwell_s, 3.0);
  ASSERT_EQ(drive.legs.size(), 4U);
  EXPECT_EQ(drive.legs[0].to, (Vec2{1, 5}));
  EXPECT_EQ(drive.legs[0].line, 14U);
  EXPECT_EQ(drive.legs[1].to, (Vec2{2, 5}));
  EXPECT_EQ(drive.legs[1].line, 15U);
  EXPECT_NEAR(drive.legs[2].turn->deg(), -45.0, 1e-12);
  EXPECT_NEAR(drive.legs[3].turn->rad(), 0.5, 1e-12);
}

TEST(SceneToml, OptionTables) {
  const SceneFile file = scene_of(R"(
[robot]
name = "cart"
row = { count = 2, spacing = 0.1, preset = "hc-sr04" }
[[robot.lasers]]
id = 4
[sonar]
listening = "all"
max_order = 2
range_noise_share = 0.0
cross_talk = false
[odometry]
perfect = false
turn_bias_share = -0.02
heading_noise_deg = 1.5
[polling]
polled = true
rate_hz = 10
[[laser]]
laser = 4
angle_min_deg = -30
angle_step_deg = 0.25
beams = 241
rate_hz = 2
noise_m = 0.001
noise_share = 0
)");
  EXPECT_EQ(file.scene.robot.name, "cart");
  EXPECT_EQ(file.scene.sonar.listening, sim::Listening::all);
  EXPECT_EQ(file.scene.sonar.max_order, 2);
  EXPECT_EQ(file.scene.sonar.range_noise_share, 0.0);
  EXPECT_FALSE(file.scene.sonar.cross_talk);
  EXPECT_FALSE(file.scene.odometry.perfect);
  EXPECT_EQ(file.scene.odometry.turn_bias_share, -0.02);
  EXPECT_NEAR(file.scene.odometry.heading_noise_per_sqrt_m.deg(), 1.5, 1e-12);
  EXPECT_TRUE(file.scene.polling.polled);
  EXPECT_EQ(file.scene.polling.rate_hz, 10.0);
  ASSERT_EQ(file.scene.lasers.size(), 1U);
  EXPECT_EQ(file.scene.lasers[0].laser, 4);
  EXPECT_EQ(file.scene.lasers[0].beams, 241);
  EXPECT_NEAR(file.scene.lasers[0].angle_min.deg(), -30.0, 1e-12);
}

TEST(SceneToml, Scoring) {
  const std::string region = "[scoring]\nregion = [[-1, 0], [1, 2]]\n";
  const SceneFile axis =
      world_of(region + "axis_deg = 90\ncell_m = 0.02\nreference = \"structured_light\"\npolynomial_degree = 9\n");
  ASSERT_TRUE(axis.scoring);
  EXPECT_EQ(axis.scoring->region.low, (Vec2{-1, 0}));
  EXPECT_EQ(axis.scoring->region.high, (Vec2{1, 2}));
  EXPECT_EQ(axis.scoring->cell_m, 0.02);
  EXPECT_NEAR(axis.scoring->axis->deg(), 90.0, 1e-12);
  EXPECT_EQ(axis.scoring->reference, ReferenceSource::structured_light);
  EXPECT_EQ(axis.scoring->polynomial_degree, 9);
  EXPECT_EQ(world_of(region + "polar_centre = [0, 1]\n").scoring->polar_centre, (Vec2{0, 1}));
  const SceneFile spans = world_of(region + "[[scoring.span]]\nfrom = [0, 0]\nto = [1, 0]\ndepth = 0.7\n");
  ASSERT_EQ(spans.scoring->walls.size(), 1U);
  EXPECT_EQ(spans.scoring->walls[0].end, (Vec2{1, 0}));
  EXPECT_EQ(spans.scoring->walls[0].depth_m, 0.7);
}

TEST(SceneToml, FilesNameThemselvesInErrors) {
  const test::TempFolder folder;
  const auto path = folder / "bad.toml";
  test::put(path, "robot = \"nomad200\"\nrobots = 3\n");
  const auto scene = read_scene_file(path);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().where, path.string() + ":2");
  EXPECT_EQ(read_scene_file(folder / "none.toml").error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace echoarc::io
