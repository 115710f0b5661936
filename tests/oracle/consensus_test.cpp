// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Tangent consensus against its plain form, on made-up drives and on a recorded one; and the scores of the recorded
// ones, as an independent program found them.

#include "echoarc/mapping/consensus.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/eval/wall_distance.hpp"
#include "oracle/consensus_oracle.hpp"
#include "support/corridor_log.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

PointMap mapped(const ConsensusOptions& options, std::span<const Reading> readings) {
  Consensus method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method.map();
}

struct Agreement {
  std::size_t expected = 0;
  std::size_t found = 0;
  std::size_t same = 0;  ///< same label, same echo, within 5 mm, p and bound alike
};

/// Links have no echo of their own: they agree when one lies within 5 mm.
Agreement compare(const std::vector<oracle::OraclePoint>& expected, const PointMap& found) {
  Agreement agreement{expected.size(), found.size(), 0};
  for (const oracle::OraclePoint& e : expected)
    for (std::size_t k = 0; k < found.size(); ++k) {
      const MapPoint& f = found.points()[k];
      if (f.label != e.label || norm(f.position - e.p) > 0.005) continue;
      if (e.label != PointLabel::link && f.ping != e.ping) continue;
      if (std::abs(f.bound_m - e.bound_m) > 0.03 || std::abs(found.beliefs()[k].probability - e.probability) > 0.01)
        continue;
      ++agreement.same;
      break;
    }
  return agreement;
}

constexpr int no_misses = 1'000'000;  // the plain form knows nothing of silent sensors
constexpr std::array modes{ConsensusMode::strict, ConsensusMode::balanced, ConsensusMode::complete};

TEST(ConsensusOracle, AgreesOnAWall) {
  for (const ConsensusMode mode : modes) {
    Rng rng(3);
    const std::vector<Reading> readings = test::wall_drive(rng, 20);
    ConsensusOptions options;
    options.mode = mode;
    options.link_misses = no_misses;
    const auto expected = oracle::ConsensusOracle(options, readings).map();
    const Agreement agreement = compare(expected, mapped(options, readings));
    EXPECT_GT(agreement.expected, 20U);
    EXPECT_EQ(agreement.found, agreement.expected);
    EXPECT_EQ(agreement.same, agreement.expected);
  }
}

TEST(ConsensusOracle, AgreesOnARecordedDrive) {
  if (!std::filesystem::exists(test::corridor_folder("run2")))
    GTEST_SKIP() << "the recorded logs (../shared/data) are not here";
  test::CorridorDrive drive;
  test::read_corridor("run2", drive);
  ConsensusOptions options;
  options.mode = ConsensusMode::complete;  // holds the layers of the other modes
  options.link_misses = no_misses;
  const Agreement agreement =
      compare(oracle::ConsensusOracle(options, drive.readings).map(), mapped(options, drive.readings));
  EXPECT_GT(agreement.expected, 1000U);
  const double all = double(agreement.expected);
  EXPECT_NEAR(double(agreement.found), all, 0.002 * all);
  EXPECT_GT(double(agreement.same), 0.998 * all);
}

/// The map brought up to date after every so many readings, and then once more: with nothing new, all is weighed.
PointMap mapped_on_line(const ConsensusOptions& options, std::span<const Reading> readings, std::size_t step) {
  Consensus method(options);
  InlineExecutor executor;
  for (std::size_t k = 0; k < readings.size(); k += step) {
    method.insert(readings.subspan(k, std::min(step, readings.size() - k)), executor);
    method.finish(executor);
  }
  method.finish(executor);
  return method.map();
}

WallDistance score_of(const PointMap& map, const test::CorridorDrive& drive) {
  std::vector<Vec2> points;
  for (const MapPoint& point : map.points()) points.push_back(point.position);
  return wall_distance(*PointSet::make(points), *laser_reference(drive.log), *PointSet::make(drive.path)).all;
}

class ConsensusOnLine : public testing::TestWithParam<const char*> {};

TEST_P(ConsensusOnLine, ScoresAsInOneBatch) {
  if (!std::filesystem::exists(test::corridor_folder(GetParam())))
    GTEST_SKIP() << "the recorded logs (../shared/data) are not here";
  test::CorridorDrive drive;
  test::read_corridor(GetParam(), drive);
  for (const std::size_t step : {8, 100}) {
    const auto batch = score_of(mapped({}, drive.readings), drive);
    const auto on_line = score_of(mapped_on_line({}, drive.readings, step), drive);
    RecordProperty("accuracy_10cm_" + std::to_string(step), std::to_string(on_line.accuracy[1]));
    RecordProperty("coverage_" + std::to_string(step), std::to_string(on_line.coverage));
    EXPECT_NEAR(on_line.accuracy[1], batch.accuracy[1], 0.01) << step;
    EXPECT_NEAR(on_line.coverage, batch.coverage, 0.01) << step;
  }
}

INSTANTIATE_TEST_SUITE_P(RecordedDrives, ConsensusOnLine, testing::Values("run1", "run2", "run3"));

/// Those of the independent program; ours were chosen on more logs and scenes (docs/methods/consensus.md). Its zones
/// and weak points follow other rules, so its mode complete is not compared.
ConsensusOptions constants_of_the_reference() {
  ConsensusOptions options;
  options.independence = 0.25;
  options.facing = 0.3;
  options.tolerance_m = 0.10;
  options.accept_p = 0.4;
  options.blocked_ratio = 0.0;
  options.link_misses = no_misses;
  // It ends at links: nothing but its own vote removes a point, and no zones.
  options.search_beams = 0.75;
  options.wider_growth = 1e6;
  options.free_floor = 0.499;
  options.occupied_threshold = 0.5;
  options.link_m = 0.6;
  options.link_p = 0.0;
  options.zone = 0.0;
  return options;
}

struct Published {
  const char* run;
  ConsensusMode mode;
  double accuracy_10cm;
  double coverage;
};

class ConsensusScores : public testing::TestWithParam<Published> {};

/// Readings whose range changed by exactly `thin_range_m` are kept or passed over by the last digit of their ranges,
/// and a link more or less is a percent of the wall of a short run: hence the tolerances.
TEST_P(ConsensusScores, AreThoseOfTheReference) {
  const Published& published = GetParam();
  if (!std::filesystem::exists(test::corridor_folder(published.run)))
    GTEST_SKIP() << "the recorded logs (../shared/data) are not here";
  test::CorridorDrive drive;
  test::read_corridor(published.run, drive);
  ConsensusOptions options = constants_of_the_reference();
  options.mode = published.mode;
  const PointMap map = mapped(options, drive.readings);
  const auto score = score_of(map, drive);
  RecordProperty("accuracy_10cm", std::to_string(score.accuracy[1]));
  RecordProperty("coverage", std::to_string(score.coverage));
  EXPECT_NEAR(score.accuracy[1], published.accuracy_10cm, 0.006);
  EXPECT_NEAR(score.coverage, published.coverage, 0.012);
}

INSTANTIATE_TEST_SUITE_P(RecordedDrives, ConsensusScores,
                         testing::Values(Published{"run1", ConsensusMode::strict, 0.988, 0.671},
                                         Published{"run1", ConsensusMode::balanced, 0.966, 0.689},
                                         Published{"run2", ConsensusMode::strict, 0.954, 0.425},
                                         Published{"run2", ConsensusMode::balanced, 0.951, 0.456},
                                         Published{"run3", ConsensusMode::strict, 0.938, 0.523},
                                         Published{"run3", ConsensusMode::balanced, 0.946, 0.574}));

}  // namespace
}  // namespace echoarc
