// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/arc_statistics.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

ArcState arc_of_radius(double radius_m, bool processed = false) {
  return {.arc = Arc::circular({}, Angle{}, radius_m, degrees(22.5)), .source = {}, .crossed = processed};
}

ArcState carved_arc(double radius_m, double left_deg) {
  ArcState state = arc_of_radius(radius_m);
  state.arc.set_limits(degrees(-0.5 * left_deg), degrees(0.5 * left_deg));
  state.carved = true;
  return state;
}

void look(LatencyMeter& meter, int arcs, int unprocessed) {
  for (int k = 0; k < arcs; ++k) meter.see(arc_of_radius(1.0, k >= unprocessed));
  meter.end_sample();
}

// V5.2: 79, 139 and 19 of 250; [Silver04] Table I prints 31.75, 55.59 and 7.68 %.
TEST(LatencyMeter, GivesTheSharesOfV52) {
  for (const auto& [unprocessed, share] : {std::pair{79, 0.316}, {139, 0.556}, {19, 0.076}}) {
    LatencyMeter meter;
    look(meter, 250, unprocessed);
    EXPECT_NEAR(meter.latency().unprocessed_share, share, 5e-4);
  }
}

TEST(LatencyMeter, AveragesSharesOfSamples) {
  LatencyMeter meter;
  look(meter, 4, 1);
  look(meter, 2, 1);
  EXPECT_DOUBLE_EQ(meter.latency().unprocessed_share, 0.375);  // of 0.25 and 0.5, not 2 of 6
  EXPECT_EQ(meter.latency().samples, 2U);
}

TEST(LatencyMeter, GathersRadiiOverAllSamples) {
  LatencyMeter meter;
  meter.see(arc_of_radius(0.1, true));
  meter.see(arc_of_radius(0.2));
  meter.end_sample();
  meter.see(arc_of_radius(0.1));
  meter.see(arc_of_radius(0.25));
  meter.see(arc_of_radius(3.81));
  meter.see(arc_of_radius(3.82));  // beyond the classes, yet in the history
  meter.end_sample();
  const Latency latency = meter.latency();
  ASSERT_EQ(latency.share_by_radius.size(), 16U);
  EXPECT_DOUBLE_EQ(latency.share_by_radius[0], 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(latency.share_by_radius[1], 1.0);
  EXPECT_TRUE(std::isnan(latency.share_by_radius[2]));
  EXPECT_EQ(latency.arcs_by_radius[15], 1U);
  EXPECT_DOUBLE_EQ(latency.unprocessed_share, 0.75);
}

TEST(LatencyMeter, LeavesRemovedArcsOut) {
  LatencyMeter meter;
  ArcState removed = arc_of_radius(1.0);
  removed.removed = true;
  meter.see(removed);
  meter.end_sample();
  EXPECT_EQ(meter.latency().samples, 0U);
  EXPECT_TRUE(std::isnan(meter.latency().unprocessed_share));
  meter.see(removed);
  meter.see(arc_of_radius(1.0, true));
  meter.end_sample();
  EXPECT_EQ(meter.latency().unprocessed_share, 0.0);
  EXPECT_EQ(meter.latency().arcs_by_radius[4], 1U);
}

TEST(AzimuthMeter, DescribesCarvedArcsByRadius) {
  AzimuthMeter meter;
  for (const double left_deg : {2.0, 4.0, 12.0}) meter.see(carved_arc(1.0, left_deg));
  meter.see(arc_of_radius(1.0));
  ArcState removed = carved_arc(1.0, 1.0);
  removed.carved = false;
  removed.removed = true;
  meter.see(removed);
  const AzimuthClass found = meter.classes()[4];
  EXPECT_EQ(found.arcs, 4U);
  EXPECT_EQ(found.carved, 3U);
  EXPECT_NEAR(found.mean_length_rad, degrees(6.0).rad(), 1e-12);
  EXPECT_NEAR(found.median_length_rad, degrees(4.0).rad(), 1e-12);
  // E_s = 2 r sin(theta_d / 4): 0.5, 1 and 3 degrees, and 5.625 of the arc that was not carved.
  const double carved = 2.0 * (std::sin(0.0087266463) + std::sin(0.0174532925) + std::sin(0.0523598776));
  EXPECT_NEAR(found.mean_error_m, carved / 3.0, 1e-9);
  EXPECT_NEAR(found.mean_error_all_m, (carved + centerline_error_m(1.0, degrees(22.5))) / 4.0, 1e-9);
  EXPECT_TRUE(std::isnan(meter.classes()[3].mean_error_m));
}

TEST(RadiusBins, CoverUpToTheirEnd) {
  const RadiusBins bins;
  EXPECT_EQ(bins.count(), 16U);
  EXPECT_EQ(bins.of(0.0), 0U);
  EXPECT_EQ(bins.of(0.25), 1U);
  EXPECT_EQ(bins.of(3.81), 15U);
  EXPECT_FALSE(bins.of(3.8100001));
  EXPECT_FALSE(bins.of(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(bins.of(-0.1));
  EXPECT_DOUBLE_EQ(bins.middle_m(0), 0.125);
  EXPECT_DOUBLE_EQ(bins.middle_m(15), 3.78);
  EXPECT_EQ((RadiusBins{0.1, 0.3}.count()), 3U);
  EXPECT_EQ((RadiusBins{0.1, 0.3}.of(0.3)), 2U);
  EXPECT_TRUE(validate(bins));
  EXPECT_FALSE(validate(RadiusBins{0.0, 1.0}));
  EXPECT_FALSE(validate(RadiusBins{1e-9, 1e9}));
  EXPECT_FALSE(validate(RadiusBins{0.1, std::numeric_limits<double>::infinity()}));
}

// V3.14 in metres at one inch, and [Silver04] eq. 5.3 for an uncarved arc.
TEST(ArcErrors, FollowThePapersCurves) {
  EXPECT_NEAR(crossing_error_m(0.0254, degrees(30.0)), 0.094794, 5e-7);
  EXPECT_NEAR(crossing_error_m(0.0254, degrees(5.0)), 0.581756, 5e-7);
  EXPECT_NEAR(crossing_error_m(0.0254, degrees(90.0)), 0.0254, 1e-12);
  EXPECT_NEAR(centerline_error_m(1.0, degrees(22.5)), 0.1960342807, 1e-9);
}

TEST(FullyCarvedShare, CountsEveryArcOnce) {
  EXPECT_DOUBLE_EQ(fully_carved_share(20, 5, 75), 0.2);
  EXPECT_TRUE(std::isnan(fully_carved_share(0, 0, 0)));
}

}  // namespace
}  // namespace echoarc
