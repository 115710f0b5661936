// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/arc_study.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/random_readings.hpp"
#include "support/test_threads.hpp"

namespace echoarc::studies {
namespace {

std::vector<AnyMethod> methods_of(const std::vector<std::pair<std::string, OptionMap>>& wanted) {
  std::vector<AnyMethod> methods;
  for (const auto& [name, options] : wanted) methods.push_back(std::move(*make_method(name, options)));
  return methods;
}

/// Three arcs of one sensor turning on the spot, one a scan: the third, longer one carves the second, not the first.
std::vector<Reading> three_scans() {
  std::vector<Reading> readings(3);
  const double yaw_deg[] = {-60.0, 0.0, 10.0};
  const double range_m[] = {1.0, 1.1, 1.3};
  for (std::size_t k = 0; k < readings.size(); ++k) {
    readings[k].ping = k;
    readings[k].scan = std::uint32_t(k);
    readings[k].T_world_tx = readings[k].T_world_rx = {{0.0, 0.0}, degrees(yaw_deg[k])};
    readings[k].beam_width = degrees(22.5);
    readings[k].outcome = Echo{range_m[k]};
  }
  return readings;
}

TEST(ArcStudy, CountsAHistoryOfTwoByHand) {
  auto methods = methods_of({{"carve", {{"history", std::int64_t{2}}}}, {"centerline", {}}, {"vt", {}}});
  InlineExecutor here;
  const std::vector<ArcStudy> studies = study_arcs(methods, three_scans(), here);
  // Full after the second scan: neither carved. After the third: the second carved, the third not; the first has left.
  EXPECT_EQ(studies[0].latency.samples, 2U);
  EXPECT_DOUBLE_EQ(studies[0].latency.unprocessed_share, 0.75);
  EXPECT_EQ(studies[0].finished, 1U);
  EXPECT_EQ(studies[0].improved, 0U);
  EXPECT_EQ(studies[0].fully_carved_share, 0.0);
  EXPECT_EQ(studies[0].azimuth[4].arcs, 1U);
  EXPECT_EQ(studies[0].azimuth[4].carved, 0U);
  EXPECT_EQ(studies[1].latency.unprocessed_share, 0.0);
  EXPECT_EQ(studies[1].latency.samples, 3U);
  EXPECT_TRUE(std::isnan(studies[1].fully_carved_share));
  EXPECT_EQ(studies[2].latency.samples, 0U);
}

TEST(ArcStudy, LooksOnceAtAHistoryThatNeverFills) {
  auto methods = methods_of({{"atm_mod", {}}, {"carve", {{"history", std::int64_t{100}}}}});
  InlineExecutor here;
  for (const ArcStudy& study : study_arcs(methods, three_scans(), here)) EXPECT_EQ(study.latency.samples, 1U);
}

TEST(ArcStudy, DoesNotDependOnThreads) {
  Rng rng(3);
  std::vector<Reading> readings = test::wall_drive(rng, 80);
  for (std::size_t k = 0; k < readings.size(); ++k) readings[k].scan = std::uint32_t(k / 5);
  const std::vector<std::pair<std::string, OptionMap>> wanted{
      {"atm_silver", {}}, {"carve", {}}, {"combined", {}}, {"centerline", {}}};
  auto first = methods_of(wanted);
  auto second = methods_of(wanted);
  InlineExecutor here;
  test::TestThreads threads(3);
  const auto alone = study_arcs(first, readings, here);
  const auto shared = study_arcs(second, readings, threads);
  for (std::size_t k = 0; k < alone.size(); ++k) {
    EXPECT_EQ(alone[k].latency.unprocessed_share, shared[k].latency.unprocessed_share);
    EXPECT_EQ(alone[k].latency.arcs_by_radius, shared[k].latency.arcs_by_radius);
    EXPECT_EQ(first[k].save(), second[k].save());
  }
  // Both together leave fewer arcs unprocessed than either alone ([Silver04] Table I).
  EXPECT_LE(alone[2].latency.unprocessed_share, alone[0].latency.unprocessed_share);
  EXPECT_LE(alone[2].latency.unprocessed_share, alone[1].latency.unprocessed_share);
}

}  // namespace
}  // namespace echoarc::studies
