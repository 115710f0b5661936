// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/depth_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

/// 144 returns, one every 2.5 degrees from `start_deg` on, of a room whose depth at a bearing is `depth(bearing_deg)`.
template <class Depth>
std::vector<DepthReturn> sweep(Depth&& depth, double start_deg = 0.0) {
  std::vector<DepthReturn> returns;
  for (int k = 0; k < 144; ++k) returns.push_back({degrees(start_deg + 2.5 * k), depth(2.5 * k), PingId(k)});
  return returns;
}

TEST(DepthRegions, ARunOfEqualDepthsIsOneRegion) {
  const auto returns = sweep([](double at) { return at >= 40.0 && at <= 60.0 ? 1.5 : 2.0 + 0.1 * std::fmod(at, 7.0); });
  const auto regions = depth_regions({1.0, 2.0}, returns);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_NEAR(regions[0].bearing.deg(), 50.0, 1e-9);
  EXPECT_NEAR(regions[0].extent.deg(), 20.0, 1e-9);
  EXPECT_EQ(regions[0].pings.size(), 9U);
  EXPECT_NEAR(regions[0].depth_m, 1.5, 1e-12);
  EXPECT_NEAR(norm(regions[0].echo_point() - (Vec2{1.0, 2.0} + 1.5 * unit(degrees(50.0)))), 0.0, 1e-12);
}

TEST(DepthRegions, RunsJoinAcrossTheStart) {
  const auto returns = sweep([](double at) { return at <= 10.0 || at >= 350.0 ? 1.5 : 9.0 - 0.02 * at; });
  const auto regions = depth_regions({}, returns, {.range_max_m = 100.0});
  ASSERT_FALSE(regions.empty());
  const auto& region = regions[0].depth_m < 2.0 ? regions[0] : regions.back();
  EXPECT_NEAR(region.bearing.deg(), 0.0, 1e-9);
  EXPECT_EQ(region.pings.size(), 9U);
}

TEST(DepthRegions, AllAroundIsOneRegion) {
  const auto regions = depth_regions({}, sweep([](double) { return 1.0; }));
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].pings.size(), 144U);
}

TEST(DepthRegions, SilenceGapsAndShortRunsEndRegions) {
  constexpr double silence = std::numeric_limits<double>::infinity();
  auto returns = sweep([](double at) { return at < 20.0 ? 1.5 : silence; });
  ASSERT_EQ(depth_regions({}, returns).size(), 1U);
  returns[4].depth_m = silence;
  EXPECT_TRUE(depth_regions({}, returns).empty()) << "four and three returns, both narrower than 10 degrees";
  EXPECT_TRUE(depth_regions({}, {}).empty());
  std::vector<DepthReturn> sparse;
  for (int k = 0; k < 8; ++k) sparse.push_back({degrees(45.0 * k), 1.5, PingId(k)});
  EXPECT_TRUE(depth_regions({}, sparse).empty());
}

RC_GTEST_PROP(DepthRegionsProperty, DoNotDependOnWhereBearingZeroPoints, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<double> depths(144);
  double depth = 2.0;
  for (double& d : depths) {
    if (rng.below(8) == 0) depth = rng.uniform(0.5, 4.0);
    d = depth + rng.uniform(-0.02, 0.02);
    if (rng.below(20) == 0) d = std::numeric_limits<double>::infinity();
  }
  const Angle turn = degrees(rng.uniform(-180.0, 180.0));
  const auto here = depth_regions({}, sweep([&](double at) { return depths[std::size_t(std::lround(at / 2.5))]; }));
  const auto there =
      depth_regions({}, sweep([&](double at) { return depths[std::size_t(std::lround(at / 2.5))]; }, turn.deg()));
  RC_ASSERT(here.size() == there.size());
  // The cut after the largest jump is unique, except among several silences: compare as sets.
  for (const DepthRegion& a : here) {
    const bool found = std::ranges::any_of(there, [&](const DepthRegion& b) {
      return a.pings == b.pings && std::abs(a.depth_m - b.depth_m) < 1e-12 &&
             abs(wrap(a.bearing + turn - b.bearing)) < radians(1e-9);
    });
    RC_ASSERT(found);
  }
}

}  // namespace
}  // namespace echoarc
