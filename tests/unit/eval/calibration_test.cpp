// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/calibration.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

PointMap map_of(const std::vector<Vec2>& positions, double p, double bound_m) {
  PointMap map;
  for (const Vec2 position : positions)
    map.add({.position = position, .label = PointLabel::wall, .bound_m = bound_m}, {},
            {.normal = {0.0, 1.0}, .probability = p});
  return map;
}

TEST(ObservedShare, HasTheIntervalOfWilson) {
  // Worked by hand for 8 of 10 and z = 1.96: middle (.8 + .19208) / 1.38416, half width sqrt(...) / 1.38416.
  const ObservedShare share = observed_share(8, 10);
  EXPECT_DOUBLE_EQ(share.share, 0.8);
  EXPECT_NEAR(share.low, 0.4902, 5e-4);
  EXPECT_NEAR(share.high, 0.9433, 5e-4);
  EXPECT_EQ(observed_share(0, 5).low, 0.0);
  EXPECT_EQ(observed_share(5, 5).high, 1.0);
  EXPECT_TRUE(std::isnan(observed_share(0, 0).share));
}

TEST(Calibration, CountsWhatIsRightAndWhatIsBounded) {
  const std::vector<ClaimedPoint> points{{PointLabel::wall, 0.95, 0.05, 0.02},    // right, bounded
                                         {PointLabel::wall, 0.91, 0.05, 0.08},    // right, not bounded
                                         {PointLabel::link, 0.55, 0.30, 0.20},    // wrong, bounded
                                         {PointLabel::point, 0.55, 0.12, 0.50}};  // wrong, not bounded
  const Calibration result = calibrate(points);
  EXPECT_EQ(result.points, 4u);
  EXPECT_NEAR(result.claimed, 0.74, 1e-12);
  EXPECT_EQ(result.right.hits, 2u);
  EXPECT_EQ(result.bound_held.hits, 2u);
  EXPECT_EQ(result.by_p[9].observed.of, 2u);
  EXPECT_DOUBLE_EQ(result.by_p[9].observed.share, 1.0);
  EXPECT_NEAR(result.by_p[9].claimed, 0.93, 1e-12);
  EXPECT_EQ(result.by_p[5].observed.of, 2u);
  EXPECT_DOUBLE_EQ(result.by_p[5].observed.share, 0.0);
  // (2 * |.93 - 1| + 2 * |.55 - 0|) / 4
  EXPECT_NEAR(result.error, 0.31, 1e-12);
  EXPECT_EQ(result.bound[0].observed.of, 2u);  // up to 5 cm, 5 cm included
  EXPECT_EQ(result.bound[3].observed.of, 1u);  // 10 to 15 cm
  EXPECT_EQ(result.bound[5].observed.hits, 1u);
}

TEST(Calibration, LimitsAreReachedDespiteRounding) {
  const std::vector<ClaimedPoint> points{{PointLabel::wall, 1.0, 0.1 + 0.2, 0.3}, {PointLabel::wall, 1.0, 0.1, 0.1}};
  const Calibration result = calibrate(points);
  EXPECT_EQ(result.bound_held.hits, 2u);
  EXPECT_EQ(result.by_p[9].observed.of, 2u);
  EXPECT_EQ(result.right.hits, 1u);
}

TEST(Calibration, OfNothingIsNothing) {
  const Calibration result = calibrate({});
  EXPECT_EQ(result.points, 0u);
  EXPECT_TRUE(std::isnan(result.claimed));
  EXPECT_TRUE(std::isnan(result.error));
  EXPECT_TRUE(std::isnan(result.by_p[0].claimed));
}

TEST(Calibration, BadClaimsCountAsWrong) {
  const std::vector<ClaimedPoint> points{{PointLabel::wall, nan, nan, 0.0}, {PointLabel::wall, 7.0, -1.0, 0.5}};
  const Calibration result = calibrate(points);
  EXPECT_EQ(result.by_p[0].observed.of, 1u);
  EXPECT_EQ(result.by_p[9].observed.of, 1u);
  EXPECT_EQ(result.bound_held.hits, 0u);
}

TEST(Calibration, AnHonestMethodIsCalibrated) {
  Rng rng(7);
  std::vector<ClaimedPoint> points;
  for (int k = 0; k < 20'000; ++k) {
    const double p = rng.uniform();
    points.push_back({PointLabel::wall, p, 0.2, rng.uniform() < p ? 0.05 : 0.5});
  }
  const Calibration result = calibrate(points);
  EXPECT_LT(result.error, 0.02);
  for (const CalibrationBin& bin : result.by_p) {
    EXPECT_LT(bin.observed.low, bin.claimed + 0.02);
    EXPECT_GT(bin.observed.high, bin.claimed - 0.02);
  }
}

TEST(ClaimedPoints, AreTheFirstOfEveryCell) {
  const Result<PointSet> wall = PointSet::make({{0.0, 0.0}});
  ASSERT_TRUE(wall);
  const NearestPoints reference(*wall);
  const PointMap map = map_of({{0.01, 0.0}, {0.02, 0.0}, {0.30, 0.0}}, 0.8, 0.05);
  const auto every = claimed_points(map, reference);
  ASSERT_TRUE(every);
  EXPECT_EQ(every->size(), 3u);
  const auto thinned = claimed_points(map, reference, 0.05);
  ASSERT_TRUE(thinned);
  ASSERT_EQ(thinned->size(), 2u);
  EXPECT_NEAR((*thinned)[0].distance_m, 0.01, 1e-12);
  EXPECT_NEAR((*thinned)[1].distance_m, 0.30, 1e-12);
  EXPECT_DOUBLE_EQ((*thinned)[1].probability, 0.8);
}

TEST(ClaimedPoints, AreNoneWithoutBeliefs) {
  const Result<PointSet> wall = PointSet::make({{0.0, 0.0}});
  const NearestPoints reference(*wall);
  PointMap map;
  map.add({.position = {0.0, 0.0}});
  const auto claims = claimed_points(map, reference, 0.05);
  ASSERT_TRUE(claims);
  EXPECT_TRUE(claims->empty());
}

TEST(ClaimedPoints, RefuseWhatIsNoPlace) {
  const Result<PointSet> wall = PointSet::make({{0.0, 0.0}});
  const NearestPoints reference(*wall);
  EXPECT_FALSE(claimed_points(map_of({{nan, 0.0}}, 0.5, 0.1), reference, 0.05));
}

}  // namespace
}  // namespace echoarc
