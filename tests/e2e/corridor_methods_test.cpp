// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What methods score on recorded drives against the log's own laser, echoes below 3 m, options as in docs/corridor.md's
// second table: a change of a method that moves its map by centimetres shows here. The figures are this program's own.

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/wall_distance.hpp"
#include "echoarc/io/delimited.hpp"
#include "echoarc/pipeline/pipeline.hpp"

namespace echoarc {
namespace {

struct Pin {
  std::string method;
  std::string run;
  double accuracy_10cm;
  double coverage;
};

void PrintTo(const Pin& pin, std::ostream* out) {
  *out << pin.method << " on " << pin.run;
}

OptionMap options_of(const std::string& method) {
  if (method == "vt") return {{"cell_m", 0.02}, {"sampling", std::string("sampled")}};
  if (method == "carve" || method == "combined") return {{"guard_m", 0.02}};
  return {};
}

class CorridorMethods : public testing::TestWithParam<Pin> {};

TEST_P(CorridorMethods, ScoreAsBefore) {
  const std::filesystem::path root = ECHOARC_SOURCE_DIR;
  const std::filesystem::path input = root / "../shared/data/corridor" / GetParam().run;
  if (!std::filesystem::exists(input)) GTEST_SKIP() << "the recorded logs (../shared/data) are not here";
  const auto description = io::read_description(root / "descriptions/corridor.toml");
  ASSERT_TRUE(description) << description.error().message;
  const Result<Log> log = io::read_delimited(*description, input);
  ASSERT_TRUE(log) << log.error().message;

  std::vector<AnyMethod> method;
  method.push_back(*make_method(GetParam().method, options_of(GetParam().method)));
  InlineExecutor executor;
  const LogRun run = run_log(*log, {.range_cut_m = 2.9995}, method, executor);
  const Result<MapExport> map = method.front().export_map();
  ASSERT_TRUE(map) << map.error().message;
  std::vector<Vec2> points;
  for (const MapPoint& point : map->points.points()) points.push_back(point.position);
  std::vector<Vec2> path;
  for (const Odometry& sample : run.path) path.push_back(sample.T_world_robot.position);

  const Result<Reference> laser = laser_reference(*log);
  ASSERT_TRUE(laser) << laser.error().message;
  const WallDistance score = wall_distance(*PointSet::make(points), *laser, *PointSet::make(path)).all;
  constexpr double tolerance = 0.02;
  EXPECT_NEAR(score.accuracy[1], GetParam().accuracy_10cm, tolerance);
  EXPECT_NEAR(score.coverage, GetParam().coverage, tolerance);
}

INSTANTIATE_TEST_SUITE_P(RecordedDrives, CorridorMethods,
                         testing::Values(Pin{"vt", "run1", 0.754, 0.599}, Pin{"vt", "run2", 0.692, 0.442},
                                         Pin{"vt", "run3", 0.664, 0.550}, Pin{"dm", "run1", 0.756, 0.492},
                                         Pin{"dm", "run2", 0.682, 0.367}, Pin{"dm", "run3", 0.627, 0.497},
                                         Pin{"carve", "run1", 0.712, 0.658}, Pin{"carve", "run2", 0.805, 0.448},
                                         Pin{"carve", "run3", 0.757, 0.591}, Pin{"combined", "run1", 0.825, 0.672},
                                         Pin{"combined", "run2", 0.873, 0.456}, Pin{"combined", "run3", 0.782, 0.614}),
                         [](const auto& pin) { return pin.param.method + "_" + pin.param.run; });

}  // namespace
}  // namespace echoarc
