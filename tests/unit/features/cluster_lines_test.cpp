// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/features/cluster_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/pose2.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/features/fitted_line.hpp"

namespace echoarc {
namespace {

/// Points every 5 cm from a to b with `noise_m` on both coordinates.
std::vector<Vec2> row(Vec2 a, Vec2 b, Rng& rng, double noise_m = 0.0) {
  std::vector<Vec2> points;
  const int count = int(norm(b - a) / 0.05);
  for (int k = 0; k <= count; ++k)
    points.push_back(a + (double(k) / count) * (b - a) + Vec2{rng.normal(0.0, noise_m), rng.normal(0.0, noise_m)});
  return points;
}

std::vector<Vec2> together(std::vector<Vec2> a, const std::vector<Vec2>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(FittedLine, LeastSquaresBesideTheLine) {
  PointMoments moments;
  for (const Vec2 p : {Vec2{1e6, 1.0}, Vec2{1e6 + 1.0, 2.0}, Vec2{1e6 + 2.0, 3.0}}) moments.add(p);
  const FittedLine line = FittedLine::of(moments);
  EXPECT_NEAR(std::abs(line.direction.x), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(line.direction.x, line.direction.y, 1e-12);
  EXPECT_NEAR(line.rms_m, 0.0, 1e-7);
  PointMoments square;  // beside the x axis by 0.1
  for (const Vec2 p : {Vec2{0, 0.1}, Vec2{0, -0.1}, Vec2{5, 0.1}, Vec2{5, -0.1}}) square.add(p);
  EXPECT_NEAR(FittedLine::of(square).rms_m, 0.1, 1e-12);
}

TEST(FittedLine, MomentsAdd) {
  Rng rng(1);
  PointMoments all, first, second;
  for (int k = 0; k < 20; ++k) {
    const Vec2 p{rng.uniform(-5, 5), rng.uniform(-5, 5)};
    all.add(p);
    (k < 7 ? first : second).add(p);
  }
  first.add(second);
  EXPECT_EQ(first.count(), 20U);
  EXPECT_NEAR(norm(first.mean() - all.mean()), 0.0, 1e-12);
  EXPECT_NEAR(first.scatter().xy, all.scatter().xy, 1e-10);
  EXPECT_NEAR(first.scatter().yy, all.scatter().yy, 1e-10);
}

TEST(ClusterLines, TwoWallsOfACornerAreTwoLines) {
  Rng rng(2);
  const std::vector<Vec2> points = together(row({0, 0}, {2, 0}, rng, 0.005), row({2, 0.05}, {2, 1.5}, rng, 0.005));
  const std::vector<Feature> lines = cluster_lines(points);
  ASSERT_EQ(lines.size(), 2U);
  for (const Feature& line : lines) {
    EXPECT_EQ(line.kind, FeatureKind::line);
    EXPECT_LT(line.residual_m, 0.03);
    const bool flat = std::abs(line.end.y - line.begin.y) < 0.1;
    EXPECT_NEAR(norm(line.end - line.begin), flat ? 2.0 : 1.45, 0.12);
  }
}

TEST(ClusterLines, ADoorStaysOpenAndASmallGapIsClosed) {
  Rng rng(3);
  const auto lines_of = [&](double gap_m) {
    return cluster_lines(together(row({0, 0}, {1, 0}, rng), row({1 + gap_m, 0}, {2 + gap_m, 0}, rng))).size();
  };
  EXPECT_EQ(lines_of(0.15), 1U);  // one cluster
  EXPECT_EQ(lines_of(0.25), 1U);  // two clusters, joined
  EXPECT_EQ(lines_of(0.35), 2U);
}

TEST(ClusterLines, ParallelWallsAreNotJoined) {
  Rng rng(4);
  EXPECT_EQ(cluster_lines(together(row({0, 0}, {1, 0}, rng), row({1.25, 0.06}, {2, 0.06}, rng))).size(), 2U);
  EXPECT_EQ(cluster_lines(together(row({0, 0}, {1, 0}, rng), row({1.25, 0.04}, {2, 0.04}, rng))).size(), 1U);
}

TEST(ClusterLines, FewPointsShortPiecesAndNumbersThatAreNoneAreDropped) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(cluster_lines({}).empty());
  EXPECT_TRUE(cluster_lines(std::vector<Vec2>{{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}}).empty());
  EXPECT_TRUE(cluster_lines(std::vector<Vec2>{{0, 0}, {0.01, 0}, {0.02, 0}, {0.03, 0}, {0.04, 0}}).empty());
  EXPECT_TRUE(cluster_lines(std::vector<Vec2>(100, Vec2{nan, 0})).empty());
  EXPECT_TRUE(cluster_lines(std::vector<Vec2>(100, Vec2{1e300, -1e300})).empty());
}

TEST(ClusterLines, ManyEqualAndManyScatteredPointsTakeBoundedTime) {
  EXPECT_TRUE(cluster_lines(std::vector<Vec2>(200000, Vec2{1.0, 2.0})).empty());
  Rng rng(5);
  std::vector<Vec2> cloud;
  for (int k = 0; k < 50000; ++k) cloud.push_back({rng.uniform(-3, 3), rng.uniform(-3, 3)});
  for (const Feature& line : cluster_lines(cloud)) EXPECT_LE(line.residual_m, 0.08);
}

RC_GTEST_PROP(SingleLinkOracle, ChainsOfNeighbours, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> points;
  const auto count = rng.below(120);
  for (std::uint64_t k = 0; k < count; ++k) points.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1)});
  const double link_m = rng.uniform(0.02, 0.4);
  const std::vector<std::size_t> cluster = single_link_clusters(points, link_m);
  // The oracle floods from point to point.
  std::vector<std::size_t> expected(points.size(), points.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (expected[k] != points.size()) continue;
    std::vector<std::size_t> open{k};
    expected[k] = next;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (std::size_t other = 0; other < points.size(); ++other) {
        if (expected[other] != points.size() || squared_norm(points[at] - points[other]) > link_m * link_m) continue;
        expected[other] = next;
        open.push_back(other);
      }
    }
    ++next;
  }
  RC_ASSERT(cluster == expected);
}

/// A cut parts what a line must not join again.
RC_GTEST_PROP(ClusterLinesProperty, NoLineLeadsAcrossAGap, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> points;
  Vec2 from{0.0, 0.0};
  for (int k = 0; k < 6; ++k) {
    const Vec2 to = from + rng.uniform(0.2, 1.0) * unit(degrees(rng.uniform(-180, 180)));
    points = together(points, row(from, to, rng, 0.01));
    from = to;
  }
  const ClusterLineOptions options;
  for (const Feature& line : cluster_lines(points, options))
    for (double share = 0.0; share <= 1.0; share += 0.02) {
      const Vec2 at = line.begin + share * (line.end - line.begin);
      const auto off = [&](Vec2 p) { return norm(p - at); };
      RC_ASSERT(off(*std::ranges::min_element(points, {}, off)) <
                std::hypot(0.5 * options.merge_gap_m, options.split_m + options.merge_offset_m));
    }
}

RC_GTEST_PROP(ClusterLinesProperty, MoveWithTheWorld, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> points = together(row({0, 0}, {2, 0.3}, rng, 0.01), row({2, 0.4}, {2.2, 1.5}, rng, 0.01));
  points = together(points, row({0.3, 1.4}, {1.2, 1.6}, rng, 0.02));
  const Pose2 T{{rng.uniform(-9, 9), rng.uniform(-9, 9)}, degrees(rng.uniform(-180, 180))};
  std::vector<Vec2> moved;
  for (const Vec2 p : points) moved.push_back(T * p);
  const std::vector<Feature> here = cluster_lines(points);
  const std::vector<Feature> there = cluster_lines(moved);
  RC_ASSERT(here.size() == there.size());
  for (std::size_t k = 0; k < here.size(); ++k) {
    RC_ASSERT(norm(T * here[k].begin - there[k].begin) < 1e-9);
    RC_ASSERT(norm(T * here[k].end - there[k].end) < 1e-9);
    RC_ASSERT(here[k].count == there[k].count);
  }
}

}  // namespace
}  // namespace echoarc
