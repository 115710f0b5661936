// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/sweep.hpp"

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "echoarc/eval/score_report.hpp"
#include "echoarc/pipeline/pipeline.hpp"
#include "echoarc/studies/experiment.hpp"
#include "echoarc/studies/scene_reference.hpp"
#include "support/test_threads.hpp"

namespace echoarc::studies {
namespace {

constexpr double wall_y_m = 1.505;

/// A robot that stops 20 times along +x and looks at a wall on its left with three sonars.
StudyScene wall_scene() {
  StudyScene made;
  sim::Scene& scene = made.scene;
  scene.name = "wall";
  scene.world.walls = {{.a = {-2.0, wall_y_m}, .b = {3.0, wall_y_m}}};
  SensorModel model;
  model.range_max_m = 4.0;
  scene.robot.sensors = SensorArray::make(ring(3, 0.2, degrees(90.0), model)).value();
  scene.drive.start = {{0.0, 0.0}, Angle{}};
  scene.drive.legs = {{.to = Vec2{0.6, 0.0}}};
  scene.drive.stop_step_m = 0.03;
  made.scoring.region = {{-0.5, 0.0}, {1.1, 2.0}};
  made.scoring.axis = degrees(90.0);
  return made;
}

/// The same as a log, judged as a whole map.
JudgedLog wall_log() {
  JudgedLog judged;
  Log& log = judged.log;
  log.robot.sensors = SensorArray::make(ring(1, 0.2, degrees(90.0), {})).value();
  for (int k = 0; k <= 20; ++k) {
    log.odometry.push_back({.time_s = double(k), .T_world_robot = {{0.03 * k, 0.0}, Angle{}}});
    log.pings.push_back({.time_s = double(k), .range_m = wall_y_m - 0.2 + 0.004 * (k % 3)});
  }
  const std::vector<Polyline> walls{{{-2.0, wall_y_m}, {3.0, wall_y_m}}};
  judged.reference = polyline_reference(walls, "the wall").value();
  const double inf = std::numeric_limits<double>::infinity();
  judged.scoring.region = {{-inf, -inf}, {inf, inf}};
  return judged;
}

SweepRequest request_of(SweepSubject subject, std::vector<std::string> methods, const std::vector<std::string>& axes) {
  SweepRequest request{.subject = std::move(subject), .methods = std::move(methods), .axes = {}};
  const bool has_scene = std::holds_alternative<StudyScene>(request.subject);
  for (const std::string& text : axes) request.axes.push_back(parse_axis(text, request.methods, has_scene).value());
  return request;
}

StudyHost host_of(Executor& executor, int seeds = 1) {
  StudyHost host;
  host.executor = &executor;
  host.seeds = seeds;
  return host;
}

/// Equal to the bit, NaN included.
void expect_same(const SweepScores& a, const SweepScores& b) {
  for (const SweepMetric& metric : sweep_metrics())
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.*metric.value), std::bit_cast<std::uint64_t>(b.*metric.value))
        << metric.name;
}

TEST(Sweep, OfALogEqualsSingleRuns) {
  const JudgedLog judged = wall_log();
  InlineExecutor here;
  const auto swept =
      run_sweep(request_of(judged, {"vt", "dm"}, {"threshold=1,2,3", "range_cut_m=0,1.308"}), host_of(here));
  ASSERT_TRUE(swept) << swept.error().message;
  ASSERT_EQ(swept->rows.size(), 12U);
  EXPECT_EQ(swept->seeds, std::vector<std::uint64_t>{0});
  for (const SweepRow& row : swept->rows) {
    // As `map` and `eval` do it.
    std::vector<AnyMethod> methods;
    methods.push_back(echoarc::make_method(row.method, {{"threshold", row.values[0]}}).value());
    const auto sensing = make_options<SensingOptions>({{"range_cut_m", row.values[1]}});
    (void)run_log(judged.log, *sensing, methods, here);
    const PointSet map = PointSet::of_occupied(methods[0].export_map()->states).value();
    const ScoreRequest request{.path = PointSet::make(path_positions(judged.log)).value()};
    const WallDistance expected = score(map, judged.reference, request)->wall_distance.all;
    const SweepScores& found = row.runs.front();
    EXPECT_EQ(found.cells, double(expected.points));
    if (expected.points > 0) {
      EXPECT_NEAR(found.mae_m, expected.mean_m, 1e-12);
    }
    EXPECT_EQ(found.within_5cm, expected.accuracy[0]);
    EXPECT_EQ(found.coverage, expected.coverage);
    EXPECT_TRUE(std::isnan(found.cdr_overall));
    EXPECT_TRUE(std::isnan(found.cpu_per_reading_s));
  }
  EXPECT_TRUE(swept->choices.empty());
  EXPECT_GT(swept->rows[0].runs[0].cells, swept->rows[1].runs[0].cells);  // the cut leaves echoes out
}

TEST(Sweep, OfASceneEqualsSingleTrials) {
  const StudyScene scene = wall_scene();
  InlineExecutor here;
  const auto swept = run_sweep(
      request_of(scene, {"vt", "mp"}, {"sonar.range_noise_share=0,0.01", "sensing.range_cut_m=0,2", "vt.threshold=3"}),
      host_of(here, 2));
  ASSERT_TRUE(swept) << swept.error().message;
  ASSERT_EQ(swept->rows.size(), 8U);
  for (const SweepRow& row : swept->rows)
    for (std::size_t run = 0; run < 2; ++run) {
      StudyScene changed = scene;
      changed.scene.sonar.range_noise_share = std::get<double>(row.values[0]);
      const auto experiment = Experiment::make(changed, {.range_cut_m = std::get<double>(row.values[1])});
      const auto trial = experiment->trial(swept->seeds[run]);
      MethodSpec spec{.label = "", .method = row.method, .options = {}};
      if (row.method == "vt") spec.options["threshold"] = std::int64_t{3};
      const MethodResult expected = run_methods(*trial, std::span(&spec, 1))->front();
      EXPECT_EQ(row.runs[run].mae_m, expected.cells.mae_m);
      EXPECT_EQ(row.runs[run].cdr_overall, expected.cells.detection.overall_ratio());
      EXPECT_EQ(row.runs[run].cells, double(expected.cells.points));
      EXPECT_GT(expected.cells.points, 0U);
    }
}

TEST(Sweep, DoesNotDependOnThreads) {
  const SweepRequest request =
      request_of(wall_scene(), {"vt", "carve"}, {"sonar.dropout_share=0,0.2", "cell_m=0.01,0.02"});
  InlineExecutor here;
  test::TestThreads threads(3);
  const auto alone = run_sweep(request, host_of(here, 3));
  const auto shared = run_sweep(request, host_of(threads, 3));
  ASSERT_TRUE(alone && shared);
  ASSERT_EQ(alone->rows.size(), 8U);
  for (std::size_t row = 0; row < alone->rows.size(); ++row)
    for (std::size_t run = 0; run < 3; ++run) expect_same(alone->rows[row].runs[run], shared->rows[row].runs[run]);
}

TEST(Sweep, ChoosesByTheRule) {
  StudyScene scene = wall_scene();
  scene.scene.world.walls = {{.a = {-0.1, wall_y_m}, .b = {0.5, wall_y_m}}};  // and empty directions beside it
  InlineExecutor here;
  const auto swept =
      run_sweep(request_of(scene, {"vt", "dm"}, {"threshold=1:6:1", "dm.doi=axis", "dm.axis_deg=90"}), host_of(here));
  ASSERT_TRUE(swept) << swept.error().message;
  ASSERT_EQ(swept->choices.size(), 2U);
  for (std::size_t method = 0; method < 2; ++method) {
    const SweepChoice& choice = swept->choices[method];
    EXPECT_EQ(choice.method, swept->rows[choice.best].method);
    const auto gap = [&](std::size_t row) {
      const SweepScores& scores = swept->rows[row].runs[0];
      return std::abs(scores.cdr_full - scores.cdr_empty);
    };
    for (std::size_t row = 6 * method; row < 6 * method + 6; ++row) EXPECT_GE(gap(row), gap(choice.best));
  }
  // The directional maximum finds what voting finds, direction by direction.
  EXPECT_EQ(swept->choices[0].best + 6, swept->choices[1].best);
}

TEST(Sweep, MeasuresTimeWhereThereIsAClock) {
  InlineExecutor here;
  StudyHost host = host_of(here);
  double now_s = 0.0;
  host.thread_cpu_s = [&] { return now_s += 0.5; };
  const auto swept = run_sweep(request_of(wall_log(), {"vt"}, {}), host);
  ASSERT_TRUE(swept);
  ASSERT_EQ(swept->rows.size(), 1U);
  EXPECT_NEAR(swept->rows[0].runs[0].cpu_per_reading_s, 1.0 / 21.0, 1e-12);
}

TEST(Sweep, RefusesWhatCannotBeMeant) {
  InlineExecutor here;
  const auto message = [&](const SweepRequest& request, int seeds = 1) {
    const auto swept = run_sweep(request, host_of(here, seeds));
    return swept ? std::string("no error") : swept.error().message;
  };
  EXPECT_EQ(message(request_of(wall_log(), {}, {})), "the sweep has no method");
  EXPECT_EQ(message(request_of(wall_log(), {"vt"}, {}), 0), "the sweep has no seed");
  EXPECT_EQ(message({.subject = wall_log(), .methods = {"vd"}, .axes = {}}), "there is no method vd");
  EXPECT_EQ(message(request_of(wall_log(), {"vt"}, {"threshold=1", "method.threshold=2"})), "threshold is given twice");
  EXPECT_EQ(message(request_of(wall_log(), {"vt", "dm"}, {"dm.threshold=1,2"})),
            "dm.threshold varies an option of one method among several");
  EXPECT_EQ(message(request_of(wall_log(), {"vt"}, {"threshold=1:1000:1", "cell_m=0.01:1.01:0.01"})),
            "the sweep has more than 100000 maps");
  SweepRequest strange = request_of(wall_scene(), {"vt"}, {"sonar.dropout_share=0"});
  strange.subject = wall_log();
  EXPECT_EQ(message(strange), "sonar.dropout_share belongs to nothing in this sweep");
  StudyScene mute = wall_scene();
  mute.scene.robot.sensors = {};
  EXPECT_NE(message(request_of(mute, {"vt"}, {})), "no error");
}

TEST(Sweep, EndsWhenTold) {
  InlineExecutor here;
  StudyHost host = host_of(here);
  int asked = 0;
  host.cancelled = [&] { return ++asked > 2; };
  const auto swept = run_sweep(request_of(wall_log(), {"vt"}, {"threshold=1:50:1"}), host);
  ASSERT_FALSE(swept);
  EXPECT_EQ(swept.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace echoarc::studies
