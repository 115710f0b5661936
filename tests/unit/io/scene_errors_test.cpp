// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/io/scene_toml.hpp"

namespace echoarc::io {
namespace {

struct BadScene {
  std::string_view text;  ///< after a first line with the robot
  std::string_view message;
  std::string_view where;
};

void expect_errors(std::span<const BadScene> cases) {
  for (const BadScene& bad : cases) {
    const auto scene = read_scene("robot = \"nomad200\"\n" + std::string(bad.text), "s.toml");
    ASSERT_FALSE(scene) << bad.text;
    EXPECT_NE(scene.error().message.find(bad.message), std::string::npos) << bad.text << scene.error().message;
    EXPECT_EQ(scene.error().where, bad.where) << bad.text;
    EXPECT_FALSE(scene.error().remedy.empty()) << bad.text;
  }
}

TEST(SceneErrors, OfTheWorld) {
  expect_errors(std::to_array<BadScene>({
      {"[[wal]]", "there is no key wal in scene", "s.toml:2"},
      {"wall = 3", "wall of scene has the wrong type", "s.toml:2"},
      {"[[wall]]\nclosed = true", "points is missing", "s.toml:2"},
      {"[[wall]]\npoints = [[0, 0]]", "points holds fewer than 2", "s.toml:3"},
      {"[[wall]]\npoints = [[0, 0],\n[1]]", "a point of points is not a list of 2", "s.toml:4"},
      {"[[wall]]\npoints = [[0, 0], [nan, 1]]", "a point of points is not", "s.toml:3"},
      {"[[wall]]\npoints = [[0, 0], [1, 0]]\ncolour = 1", "there is no key colour in wall", "s.toml:4"},
      {"[[wall]]\npoints = [[0, 0],\n[1, 0],\n[1, 0]]", "a wall has no length", "s.toml:5"},
      {"[[wall]]\npoints = [[0, 0], [1e9, 0]]", "beyond 100000 m", "s.toml:3"},
      {"[[wall]]\npoints = [[0, 0], [1, 0]]\nmaterial = \"brik\"", "there is no material \"brik\"", "s.toml:4"},
      {"[materials]\nfelt = 3", "material felt is no table", "s.toml:3"},
      {"[materials.felt]\nloss_db = -1", "loss_db = -1 of material is out of range", "s.toml:3"},
      {"[materials.felt]\nloss = 1", "there is no key loss in material", "s.toml:3"},
      {"[materials.felt]\nrough_db = 0", "rough_db = 0 of material is out of range", "s.toml:3"},
      {"[[box]]\ncentre = [0, 0]", "size is missing", "s.toml:2"},
      {"[[box]]\ncentre = [0, 0]\nsize = [1, 0]", "the box has no area", "s.toml:4"},
      {"[[disc]]\ncentre = [0, 0]", "radius is missing", "s.toml:2"},
      {"[[disc]]\ncentre = [0, 0]\nradius = -1", "radius = -1 of disc is out of range", "s.toml:4"},
      {"[[slats]]\nfrom = [0, 0]\nto = [0, 0]\nwidth = 0.1", "the row of slats has no length", "s.toml:4"},
      {"[[slats]]\nfrom = [0, 0]\nto = [1e5, 0]\nwidth = 0.001", "too many slats", "s.toml:2"},
      {"[world]\nseed = -1", "seed = -1 of world is out of range", "s.toml:3"},
      {"[[moving]]\nradius = 0.2", "the moving disc has no path", "s.toml:2"},
      {"[[moving]]\npath = []", "the moving disc has no path", "s.toml:3"},
      {"[[moving]]\npath = [[0, 0, 0],\n[0, 1, 1]]", "the times of path do not grow", "s.toml:4"},
      {"[[moving]]\npath = [[0, 0]]", "a station of path is not a list of 3", "s.toml:3"},
  }));
}

TEST(SceneErrors, OfCurves) {
  expect_errors(std::to_array<BadScene>({
      {"[[curve]]", "the curve has no shape", "s.toml:2"},
      {"[[curve]]\nx = [0, 1]\npoints = [[0, 0], [1, 1]]", "the curve has more than one shape", "s.toml:2"},
      {"[[curve]]\nx = [1, 0]", "x does not go from left to right", "s.toml:3"},
      {"[[curve]]\nx = [0, 1]\ncosines = [[1, 2]]", "a term of cosines is not a list of 3", "s.toml:4"},
      {"[[curve]]\nx = [0, 1]\npolynomial = [1, \"a\"]", "polynomial is not a list of 2", "s.toml:4"},
      {"[[curve]]\nx = [0, 1]\nsines = [[1, 1e9, 0]]", "the curve would be", "s.toml:2"},
      {"[[curve]]\nx = [0, 1e9]", "the curve would be", "s.toml:2"},
      {"[[curve]]\ncentre = [0, 0]\nradius = 1\nfrom_deg = 0", "to_deg is missing", "s.toml:2"},
      {"[[curve]]\ncentre = [0, 0]\nradius = 1\nfrom_deg = 0\nto_deg = 360", "cannot go all around", "s.toml:2"},
      {"[[curve]]\npoints = [[0, 0], [1, 0]]", "points holds fewer than 3", "s.toml:3"},
      {"[[curve]]\npoints = [[0, 0], [1, 0], [1, 0]]", "points 2 and 3 of the curve are the same", "s.toml:2"},
      {"[[curve]]\npoints = [[0, 0], [1, 0], [1, 1], [0.5, -1]]", "a curve crosses itself", "s.toml:2"},
  }));
}

TEST(SceneErrors, OfRobotsAndDrives) {
  expect_errors(std::to_array<BadScene>({
      {"[[laser]]\nlaser = 3", "the robot has no laser 3", "s.toml:2"},
      {"[[laser]]\nbeams = 0", "beams", "s.toml:3"},
      {"[drive]\nspeed_m_s = -1", "speed_m_s", "s.toml:3"},
      {"[drive]\nstart = [0, 0]", "start is not a list of 3", "s.toml:3"},
      {"[drive]\nlegs = 3", "legs of drive has the wrong type", "s.toml:3"},
      {"[drive]\nlegs = [[0, 1],\n{}]", "a leg is either straight or a turn", "s.toml:4"},
      {"[drive]\nlegs = [{ to = [0, 1], turn_deg = 3 }]", "a leg is either straight or a turn", "s.toml:3"},
      {"[drive]\nlegs = [\"north\"]", "a leg is not a list", "s.toml:3"},
      {"[drive]\nleg = [[0, 1]]", "there is no key leg in drive", "s.toml:3"},
  }));
  const auto nothing = read_scene("", "s.toml");
  EXPECT_EQ(nothing.error().message, "the scene has no robot");
  const auto unknown = read_scene("\nrobot = \"nomad20\"", "s.toml");
  EXPECT_EQ(unknown.error().where, "s.toml:2");
  EXPECT_EQ(unknown.error().remedy, "did you mean nomad200?");
  const auto blind = read_scene("[robot]\nname = \"cart\"", "s.toml");
  EXPECT_EQ(blind.error().where, "s.toml:1");
  EXPECT_EQ(blind.error().message, "the robot has no sensors");
}

TEST(SceneErrors, OfOptions) {
  expect_errors(std::to_array<BadScene>({
      {"[sonar]\nmax_order = 20", "max_order", "s.toml:3"},
      {"[sonar]\nrange_noise_share = -0.1", "range_noise_share", "s.toml:3"},
      {"[sonar]\nlistening = \"none\"", "listening", "s.toml:3"},
      {"[sonar]\nlistening = [1]", "listening has the wrong type", "s.toml:3"},
      {"[sonar]\nmax_ordr = 3", "there is no key max_ordr in sonar", "s.toml:3"},
      {"[odometry]\nrate_hz = 0", "rate_hz", "s.toml:3"},
      {"[polling]\npolled = 1", "polled", "s.toml:3"},
      {"[office]\narea_m2 = 1e12", "area_m2", "s.toml:3"},
      {"[office]\narea_m2 = 1e7\nroom_depth_m = 2\nroom_width_m = 3", "more than 1000000 walls", "s.toml:3"},
      {"[office]\n\ndoor_m = 3", "too wide", "s.toml:4"},
      {"[office]\nrough = \"bric\"", "there is no material \"bric\"", "s.toml:3"},
      {"[scoring]\naxis_deg = 90", "region is missing", "s.toml:2"},
      {"[scoring]\nregion = [[0, 0], [1, 1]]", "scoring has no directions of interest", "s.toml:2"},
      {"[scoring]\nregion = [[0, 0], [0, 1]]\naxis_deg = 0", "region is no rectangle", "s.toml:3"},
      {"[scoring]\nregion = [[0, 0], [1e5, 1e5]]\naxis_deg = 0", "region has", "s.toml:3"},
      {"[scoring]\nregion = [[0, 0], [1, 1]]\n[[scoring.span]]\nfrom = [0, 0]", "to is missing", "s.toml:4"},
      {"[scoring]\nregion = [[0, 0], [1, 1]]\naxis_deg = 0\npolar_centre = [0, 0]", "two kinds", "s.toml:2"},
  }));
}

TEST(SceneErrors, NearMissesAreSuggested) {
  const auto scene = read_scene("robot = \"nomad200\"\n[[wall]]\npoint = [[0, 0], [1, 0]]\n", "s.toml");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message, "points is missing");
  const auto drive = read_scene("robot = \"nomad200\"\n[drive]\nspeed_ms = 1\n", "s.toml");
  EXPECT_EQ(drive.error().remedy, "did you mean speed_m_s?");
}

TEST(SceneErrors, MoreThanAMillionWallsAreRefused) {
  std::string text = "robot = \"nomad200\"\n";
  for (int i = 0; i < 2; ++i)
    text += "[[slats]]\nfrom = [0, " + std::to_string(i) + "]\nto = [600, 0]\nwidth = 0.001\n";
  const auto scene = read_scene(text, "s.toml");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message, "the world has more than 1000000 walls");
  EXPECT_EQ(scene.error().where, "s.toml:6");
}

TEST(SceneErrors, TooManyCurveSamplesAreRefused) {
  std::string text = "robot = \"nomad200\"\n";
  for (int i = 0; i < 12; ++i) text += "[[curve]]\nx = [0, 390]\ny = " + std::to_string(i) + "\n";
  const auto scene = read_scene(text, "s.toml");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().where, "s.toml:32");
}

}  // namespace
}  // namespace echoarc::io
