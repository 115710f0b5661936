// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hand_made_scene.hpp"
#include "studies/barshan/level_map.hpp"
#include "studies/barshan/methods.hpp"
#include "studies/barshan/parameter_study.hpp"
#include "studies/barshan/place_runs.hpp"

namespace echoarc::studies::barshan {
namespace {

Result<Trial> wall_trial() {
  return Experiment::make(test::wall_scene())->trial(2);
}

/// One map for all parameters gives what mapping anew with each of them gives.
void expect_twin(Technique technique, const std::vector<double>& parameters) {
  const auto trial = wall_trial();
  ASSERT_TRUE(trial);
  MethodSpec spec = spec_of(technique, Place::curve, parameters.front());
  for (const char* parameter : {"threshold", "neighbours"})
    if (spec.options.contains(parameter)) spec.options.erase(spec.options.find(parameter));
  const auto map = level_map(*trial, technique, spec.options);
  ASSERT_TRUE(map);
  const std::vector<MapScore> scores = scores_at(*map, *trial->scorer, parameters);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto anew = run_methods(*trial, std::vector{spec_of(technique, Place::curve, parameters[k])});
    ASSERT_TRUE(anew);
    const MapScore& expected = anew->front().cells;
    EXPECT_EQ(scores[k].points, expected.points) << name_of(technique) << " " << parameters[k];
    EXPECT_EQ(scores[k].detection, expected.detection);
    if (expected.points > 0) {
      EXPECT_NEAR(scores[k].mae_m, expected.mae_m, 1e-12);
    }
  }
  EXPECT_GT(scores.front().points, 0u);
}

TEST(LevelMap, Voting) {
  expect_twin(Technique::vt, {1, 2, 4, 9, 100});
}
TEST(LevelMap, DirectionalMaximum) {
  expect_twin(Technique::dm, {1, 2, 4, 9});
}
TEST(LevelMap, MorphologicalProcessing) {
  expect_twin(Technique::mp, {0, 1, 4, 7, 8});
}
TEST(LevelMap, BayesUpdate) {
  expect_twin(Technique::bu, {0.6, 0.9, 0.99, 0.999});
}
TEST(LevelMap, TriangulationFusion) {
  expect_twin(Technique::tbf, {1, 2, 3, 5});
}

TEST(Barshan, PrintedTablesAreWhole) {
  EXPECT_EQ(printed_rows(Place::curve).size(), 9u);
  EXPECT_EQ(printed_rows(Place::room_a).size(), 12u);
  EXPECT_EQ(printed_rows(Place::room_c).size(), 10u);
  for (const Place place : {Place::curve, Place::room_a, Place::room_c})
    for (const PrintedRow& row : printed_rows(place)) {
      // CDR_O lies between CDR_F and CDR_E; a check on the transcription.
      EXPECT_LE(row.cdr_overall, std::max(row.cdr_full, row.cdr_empty)) << label_of(row.technique, row.parameter);
      EXPECT_GE(row.cdr_overall, std::min(row.cdr_full, row.cdr_empty));
    }
  EXPECT_EQ(label_of(Technique::bu, 0.999), "BU, threshold 0.999");
  EXPECT_EQ(label_of(Technique::bu, 0.999999), "BU, threshold 0.999999");
  EXPECT_EQ(label_of(Technique::pm, 0), "PM");
  EXPECT_EQ(label_of(Technique::mp, 8), "MP, m = 8");
  EXPECT_EQ(printed_rows(Place::room_a)[ranked_row(Place::room_a, Technique::bu)].parameter, 0.998);
}

TEST(Barshan, EverySpecIsAMethod) {
  for (const Place place : {Place::curve, Place::room_a, Place::room_c, Place::corner})
    for (const PrintedRow& row : printed_rows(place))
      EXPECT_TRUE(make_method(spec_of(row.technique, place, row.parameter), test::wall_scene().scoring))
          << label_of(row.technique, row.parameter);
}

TEST(Barshan, CountsArcsOfTheRegion) {
  Reading reading;
  reading.T_world_tx = reading.T_world_rx = {{0.0, 0.0}, degrees(90.0)};
  reading.outcome = Echo{1.0};
  Reading far = reading;
  far.outcome = Echo{5.0};
  Reading silent = reading;
  silent.outcome = NoEcho{};
  const ArcCount count = count_arcs(std::vector{reading, far, silent}, {{-0.5, 0.0}, {0.5, 2.0}});
  EXPECT_EQ(count.all, 2u);
  EXPECT_EQ(count.inside, 1u);
}

TEST(Variations, ChangeTheirSceneAlone) {
  StudyScene scene = test::wall_scene();
  sim::SmoothCurve curve;
  for (int k = 0; k < 10; ++k) curve.points.push_back({0.001 * k, 1.0});
  scene.scene.world.curves = {curve};
  const auto find = [&](const std::string& study, double value) {
    for (const Variation& one : variations())
      if (one.study == study && one.value == value) return varied(scene, one).value();
    return scene;
  };
  const StudyScene beam = find("beam width", 25.0);
  EXPECT_DOUBLE_EQ(beam.scene.robot.sensors.sensors().front().model.beam_width.deg(), 25.0);
  EXPECT_NEAR(beam.scene.sonar.aperture_radius_m, 0.0196, 0.0001);
  EXPECT_EQ(find("roughness", -18.0).scene.world.materials.front().rough_db, std::optional{-18.0});
  EXPECT_NEAR(find("distance", 2.2).scene.world.curves.front().points[2000].y, 2.2 + 0.16 * std::cos(0.5), 1e-9);
  EXPECT_EQ(find("curvature", 0.0).scene.world.curves.front().points.front().y, 1.0);
  EXPECT_EQ(find("range noise", 5.0).scene.sonar.range_noise_share, 0.05);
}

}  // namespace
}  // namespace echoarc::studies::barshan
