// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/comparison.hpp"

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sim/simulate.hpp"
#include "echoarc/studies/comparison_findings.hpp"
#include "echoarc/studies/comparison_report.hpp"
#include "hand_made_scene.hpp"
#include "support/test_threads.hpp"

namespace echoarc::studies {
namespace {

StudyHost host_on(Executor& executor, int seeds) {
  StudyHost host;
  host.executor = &executor;
  host.seeds = seeds;
  host.scene = [](std::string_view) -> Result<StudyScene> { return test::wall_scene(); };
  return host;
}

std::vector<ComparedMethod> two_methods() {
  std::vector<ComparedMethod> methods = compared_methods();
  std::erase_if(methods,
                [](const ComparedMethod& m) { return m.label != default_consensus && m.method != "centerline"; });
  return methods;
}

/// A wall seen by sonars and a laser, as if it had been recorded.
Log recorded_log() {
  StudyScene scene = test::wall_scene();
  scene.scene.robot.lasers = {{.id = 0, .mount = {}}};
  scene.scene.lasers = {{.rate_hz = 5.0}};
  Log log = sim::simulate(scene.scene, 1).value().log;
  log.truth.clear();
  return log;
}

/// A map of which so many points are right, and which finds so much.
ComparedMap map_with(std::uint64_t points, double accuracy, double coverage) {
  ComparedMap map;
  map.distance.all.points = map.distance.one_per_cell.points = points;
  map.distance.all.accuracy = map.distance.one_per_cell.accuracy = {accuracy, accuracy, accuracy};
  map.distance.all.coverage = map.distance.one_per_cell.coverage = coverage;
  return map;
}

/// centerline, centerline < 3 m and consensus on two places.
Comparison hand_made_comparison() {
  Comparison comparison{.seeds = 1, .methods = two_methods(), .places = {}};
  ComparedPlace log;
  log.name = "a";
  log.maps = {{map_with(200, 0.6, 0.5)}, {map_with(200, 0.97, 0.72)}, {map_with(200, 0.95, 0.70)}};
  log.maps[2].front().claims = {{PointLabel::wall, 0.9, 0.1, 0.0}};
  ComparedPlace scene;
  scene.name = "b";
  scene.kind = PlaceKind::scene;
  scene.maps = {{map_with(99, 0.1, 0.1)}, {map_with(200, 0.6, 0.695)}, {map_with(200, 0.95, 0.70)}};
  scene.maps[2].front().claims = {{PointLabel::link, 0.8, 0.1, 0.2}};
  scene.maps[2].push_back(scene.maps[2].front());  // a second seed
  comparison.places = {log, scene};
  return comparison;
}

TEST(ComparedMethods, CoverTheCatalogueAndCanBeMade) {
  std::set<std::string> labels;
  std::set<std::string> names;
  for (const ComparedMethod& method : compared_methods()) {
    EXPECT_TRUE(labels.insert(method.label).second) << method.label;
    names.insert(method.method);
    EXPECT_TRUE(echoarc::make_method(method.method, method.options)) << method.label;
  }
  EXPECT_EQ(names.size(), catalog().size());
  EXPECT_TRUE(labels.contains(std::string(default_consensus)));
  EXPECT_TRUE(labels.contains(std::string(careful_median)));
}

TEST(Comparison, TheNamedMethodsAreTheShippedOnes) {
  const AnyMethod consensus = echoarc::make_method("consensus").value();
  EXPECT_EQ("consensus " + std::get<std::string>(consensus.options().at("mode")), default_consensus);
  EXPECT_EQ(std::get<double>(echoarc::make_method("atm_mod").value().options().at("theta_t_deg")), 13.0);
}

TEST(Comparison, FirstSecondsHoldNothingLater) {
  Log log;
  for (int k = 0; k < 10; ++k) {
    log.odometry.push_back({.time_s = 100.0 + k});
    log.pings.push_back({.time_s = 100.5 + k});
    log.scans.push_back({.time_s = 100.5 + k});
  }
  const Log cut = first_seconds(log, 4.0);
  EXPECT_EQ(cut.odometry.size(), 4u);
  EXPECT_EQ(cut.pings.size(), 4u);
  EXPECT_EQ(cut.scans.size(), 4u);
  EXPECT_EQ(first_seconds(Log{}, 4.0).odometry.size(), 0u);
}

TEST(Comparison, OfASceneDoesNotDependOnThreads) {
  InlineExecutor inline_executor;
  echoarc::test::TestThreads threads(3);
  const ComparisonRequest request{.logs = {}, .scenes = {"wall"}, .methods = two_methods()};
  const auto one = compare_methods(host_on(inline_executor, 2), request);
  const auto three = compare_methods(host_on(threads, 2), request);
  ASSERT_TRUE(one && three);
  ASSERT_EQ(one->places.size(), 1u);
  const ComparedPlace& place = one->places.front();
  EXPECT_EQ(place.kind, PlaceKind::scene);
  EXPECT_TRUE(place.picture);
  for (std::size_t m = 0; m < 3; ++m) {
    ASSERT_EQ(place.maps[m].size(), 2u);
    const MeanScores scores = mean_scores(place.maps[m], every_point);
    EXPECT_GT(scores.points, 10.0);
    EXPECT_GT(scores.accuracy[1], 0.5);
    EXPECT_EQ(scores.coverage, mean_scores(three->places.front().maps[m], every_point).coverage);
    EXPECT_EQ(place.maps[m].front().claims.empty(), m != 2);
  }
}

TEST(Comparison, OfARecordedLogIsHeldAgainstItsLaser) {
  InlineExecutor executor;
  const ComparisonRequest request{.logs = {{"hand", recorded_log()}}, .scenes = {}, .methods = two_methods()};
  const auto result = compare_methods(host_on(executor, 1), request);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_FALSE(result->places.empty());
  EXPECT_EQ(result->places.front().name, "hand");
  EXPECT_EQ(result->places.front().kind, PlaceKind::log);
  EXPECT_NE(result->places.front().provenance.find("laser"), std::string::npos);
  EXPECT_GT(mean_scores(result->places.front().maps[2], one_per_cell).accuracy[1], 0.8);
}

TEST(Comparison, OfALogWithoutALaserIsRefused) {
  InlineExecutor executor;
  Log log = recorded_log();
  log.scans.clear();
  const auto result = compare_methods(host_on(executor, 1), {.logs = {{"dark", log}}, .scenes = {}});
  ASSERT_FALSE(result);
  EXPECT_FALSE(result.error().remedy.empty());
}

TEST(Comparison, CanBeCancelled) {
  InlineExecutor executor;
  StudyHost host = host_on(executor, 1);
  host.cancelled = [] { return true; };
  const auto result = compare_methods(host, {.logs = {}, .scenes = {"wall"}, .methods = two_methods()});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::interrupted);
}

TEST(Findings, DominatingTakesBothScoresAndAHundredPoints) {
  const auto scores = [](double points, double accuracy, double coverage) {
    return MeanScores{.points = points, .accuracy = {0.0, accuracy, 1.0}, .coverage = coverage};
  };
  EXPECT_TRUE(dominates(scores(100, 0.92, 0.62), scores(100, 0.90, 0.60)));
  EXPECT_FALSE(dominates(scores(100, 0.92, 0.605), scores(100, 0.90, 0.60)));
  EXPECT_FALSE(dominates(scores(99, 0.92, 0.62), scores(100, 0.90, 0.60)));
  EXPECT_FALSE(dominates(scores(100, std::nan(""), 0.62), scores(100, 0.90, 0.60)));
}

TEST(Findings, NameWhoDominatesWhomWhere) {
  const Comparison comparison = hand_made_comparison();
  const std::vector<Dominance> dominators = dominators_of_consensus(comparison);
  ASSERT_EQ(dominators.size(), 2u);  // either counting
  EXPECT_EQ(comparison.methods[dominators.front().better].label, "centerline < 3 m");
  EXPECT_EQ(dominators.front().place, 0u);
  const std::vector<Duel> all = duels(comparison, one_per_cell);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].places, 1u);  // 99 points are too few on the other
  EXPECT_EQ(all[0].dominated, 1u);
  EXPECT_EQ(all[1].places, 2u);
  EXPECT_EQ(all[1].dominated, 0u);
  EXPECT_EQ(all[1].not_more_accurate, 1u);
  EXPECT_EQ(all[1].not_more_complete, 2u);
  EXPECT_EQ(all[1].others, (std::vector<std::size_t>{0, 1}));
}

TEST(Findings, MeansLeaveOutWhatIsNoNumber) {
  const std::vector<ComparedMap> maps{map_with(10, 0.5, 0.25), map_with(0, std::nan(""), 0.75)};
  const MeanScores scores = mean_scores(maps, every_point);
  EXPECT_EQ(scores.points, 5.0);
  EXPECT_EQ(scores.accuracy[1], 0.5);
  EXPECT_EQ(scores.coverage, 0.5);
  EXPECT_TRUE(std::isnan(mean_scores_against_whole(maps, every_point).coverage));
}

TEST(Findings, PoolTheFirstSeedOfEveryPlace) {
  const Comparison comparison = hand_made_comparison();
  EXPECT_EQ(pooled_claims(comparison, 2, Pool::all).size(), 2u);
  EXPECT_EQ(pooled_claims(comparison, 2, Pool::logs).size(), 1u);
  EXPECT_EQ(claims_of(comparison.places[1], 2).size(), 2u);
  EXPECT_EQ(with_label(pooled_claims(comparison, 2, Pool::all), PointLabel::link).size(), 1u);
}

TEST(ComparisonReport, RowsAreAsWideAsTheirHeads) {
  std::set<std::string> ids;
  for (const ComparisonSection& section : comparison_sections(hand_made_comparison())) {
    for (const TextTable& table : section.tables) {
      EXPECT_TRUE(ids.insert(table.id).second) << table.id;
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.head.size()) << table.id;
    }
    for (const ChartFigure& figure : section.charts) EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
  }
  EXPECT_TRUE(ids.contains("overview"));
  EXPECT_TRUE(ids.contains("dominators"));
  EXPECT_TRUE(ids.contains("calibration-consensus-balanced"));
}

}  // namespace
}  // namespace echoarc::studies
