// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/experiment.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/studies/scene_reference.hpp"
#include "hand_made_scene.hpp"

namespace echoarc::studies {
namespace {

using test::wall_scene;

/// Every stop of a robot at x = -0.3 ... 0.3 hears the wall straight ahead.
Log hand_made_log() {
  const StudyScene scene = wall_scene();
  Log log;
  log.source = "hand";
  log.robot = scene.scene.robot;
  for (int k = 0; k <= 12; ++k) {
    const double time_s = 1.0 * k;
    const Pose2 T_world_robot{{-0.3 + 0.05 * k, 0.0}, degrees(90.0)};
    log.odometry.push_back({time_s, T_world_robot});
    for (const Sensor& sensor : log.robot.sensors.sensors())
      if (std::abs(sensor.mount.yaw.deg()) < 1.0)
        log.pings.push_back({.time_s = time_s, .tx = sensor.id, .rx = sensor.id, .range_m = 1.0 - sensor.mount.x_m});
  }
  return log;
}

TEST(Experiment, ReferenceIsWhatIsVisibleFromThePath) {
  const auto experiment = Experiment::make(wall_scene());
  ASSERT_TRUE(experiment);
  const auto trial = experiment->trial(1, hand_made_log());
  ASSERT_TRUE(trial);
  // The front wall, both ends included, every 2 mm; nothing of the wall behind it.
  const Reference& reference = trial->scorer->reference();
  EXPECT_EQ(reference.points.size(), 501u);
  for (const Vec2 p : reference.points.points()) EXPECT_EQ(p.y, 1.0);
  EXPECT_EQ(reference.provenance, "surfaces visible from the path");
}

TEST(Experiment, ScoresHandMadeReadings) {
  const auto experiment = Experiment::make(wall_scene());
  const auto trial = experiment->trial(1, hand_made_log());
  ASSERT_TRUE(trial);
  ASSERT_EQ(trial->readings.size(), 13u);
  const std::vector<MethodSpec> specs{{"PM", "centerline", {}}, {"VT", "vt", {{"threshold", std::int64_t{1}}}}};
  const auto results = run_methods(*trial, specs);
  ASSERT_TRUE(results);
  const MethodResult& points = (*results)[0];
  EXPECT_EQ(points.cells.points, 13u);
  // Exact points lie on the wall; the centres of their cells half a cell off it.
  EXPECT_NEAR(points.points.mae_m, 0.0, 0.002);
  EXPECT_NEAR(points.cells.mae_m, 0.005, 0.001);
  EXPECT_EQ(points.cells.detection.correct_full, 13u);
  EXPECT_EQ(points.cells.detection.full, 101u);
  EXPECT_EQ(points.cells.detection.empty, 50u);
  EXPECT_EQ(points.cells.detection.correct_empty, 50u);
  EXPECT_GT((*results)[1].cells.points, 101u);
  EXPECT_EQ((*results)[1].cells.points, (*results)[1].points.points);
  EXPECT_EQ(points.cpu_s(), 0.0);
}

TEST(Experiment, TheSameSeedIsTheSameTrial) {
  const auto experiment = Experiment::make(wall_scene());
  ASSERT_TRUE(experiment);
  const auto a = experiment->trial(3);
  const auto b = experiment->trial(3);
  const auto c = experiment->trial(4);
  ASSERT_TRUE(a && b && c);
  ASSERT_EQ(a->readings.size(), b->readings.size());
  for (std::size_t k = 0; k < a->readings.size(); ++k) EXPECT_EQ(a->readings[k].outcome, b->readings[k].outcome);
  EXPECT_EQ(a->scorer, c->scorer);  // the truth is made once
  EXPECT_GT(a->readings.size(), 30u);
}

TEST(Experiment, CountsOnlyTheRegion) {
  const auto experiment = Experiment::make(wall_scene());
  const auto trial = experiment->trial(1, hand_made_log());
  ASSERT_TRUE(trial);
  const MapScore score = trial->scorer->score(PointSet::make({{0.0, 1.01}, {0.0, 2.0}, {0.0, 5.0}}).value());
  EXPECT_EQ(score.points, 1u);
  EXPECT_NEAR(score.mae_m, 0.01, 1e-12);
  EXPECT_TRUE(std::isnan(trial->scorer->score({}).mae_m));
}

TEST(Experiment, RefusesASceneWithoutARegion) {
  StudyScene scene = wall_scene();
  scene.scoring.region = {};
  EXPECT_FALSE(Experiment::make(scene));
}

TEST(SceneReference, LaserAndPolynomial) {
  StudyScene scene = wall_scene();
  scene.scene.robot.lasers = {{.id = 0, .mount = {}, .range_min_m = 0.3, .range_max_m = 3.05}};
  scene.scene.lasers = {{.laser = 0, .angle_min = degrees(-30.0), .angle_step = degrees(0.5), .beams = 121}};
  scene.scoring.reference = ReferenceSource::structured_light;
  scene.scoring.polynomial_degree = 1;
  const auto experiment = Experiment::make(scene);
  ASSERT_TRUE(experiment);
  const auto trial = experiment->trial(1);
  ASSERT_TRUE(trial);
  const auto points = laser_points(trial->log);
  ASSERT_TRUE(points);
  EXPECT_GT(points->size(), 500u);
  // Beams past the wall's ends see the one behind: the line through all of them still lies near.
  const Reference& reference = trial->scorer->reference();
  EXPECT_EQ(reference.provenance, "structured light, polynomial of degree 1");
  for (const Vec2 p : reference.points.points()) EXPECT_NEAR(p.y, 1.0, 0.1);
}

TEST(SceneReference, NoLaserIsAnError) {
  StudyScene scene = wall_scene();
  scene.scoring.reference = ReferenceSource::structured_light;
  EXPECT_FALSE(Experiment::make(scene)->trial(1));
}

TEST(SceneReference, SurfacesOfDiscsAndCurves) {
  sim::WorldDescription world;
  world.discs = {{{0.0, 0.0}, 0.5}};
  world.curves = {{{{1.0, 0.0}, {1.001, 0.0}, {1.002, 0.0}}}};
  const std::vector<Vec2> points = surface_points(world, 0.01);
  EXPECT_EQ(points.size(), 315u + 3u);
  for (std::size_t k = 0; k < 315; ++k) EXPECT_NEAR(norm(points[k]), 0.5, 1e-12);
}

}  // namespace
}  // namespace echoarc::studies
