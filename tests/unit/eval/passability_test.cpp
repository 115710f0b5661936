// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/passability.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

const Strip opening{{1.0, 2.0}, {1.0, 2.8}, 0.2, 0.2};  // upwards: left is -x

// A beam of 22.5 degrees past an opening of 0.8 m: from 1.2 m it looks too narrow for a robot of 0.45 m, from 2.5 m it
// is gone.
TEST(Passability, CenterlineOpening) {
  EXPECT_NEAR(centerline_opening_m(0.8, 1.2, degrees(22.5)), 0.322610, 5e-7);
  EXPECT_NEAR(centerline_opening_m(0.8, 2.5, degrees(22.5)), -0.194562, 5e-7);
  EXPECT_EQ(centerline_opening_m(0.8, 0.0, degrees(22.5)), 0.8);
}

TEST(Passability, StripCoordinates) {
  EXPECT_EQ(opening.local({1.0, 2.0}), (Vec2{0.0, 0.0}));
  const auto left = opening.local({0.9, 2.5});
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->x, 0.5, 1e-12);
  EXPECT_NEAR(left->y, 0.1, 1e-12);
  EXPECT_FALSE(opening.local({0.79, 2.5}));
  EXPECT_FALSE(opening.local({1.0, 2.81}));
}

TEST(Passability, WidestGap) {
  EXPECT_NEAR(widest_gap({}, opening).width_m(), 0.8, 1e-12);
  const std::vector<Vec2> points{{1.1, 2.1}, {0.9, 2.6}, {1.5, 2.3}};  // the last one is out of the strip
  const Gap gap = widest_gap(points, opening);
  EXPECT_NEAR(gap.begin_m, 0.1, 1e-12);
  EXPECT_NEAR(gap.end_m, 0.6, 1e-12);
  EXPECT_EQ(count_points(points, opening), 2U);
  const std::vector<Vec2> at_the_ends{{1.0, 2.0}, {1.0, 2.8}};
  EXPECT_NEAR(widest_gap(at_the_ends, opening).width_m(), 0.8, 1e-12);
}

TEST(Passability, PassageBetweenSidesAndPoints) {
  const Strip hall{{0.0, 0.0}, {4.0, 0.0}, 0.7, 0.7};
  EXPECT_NEAR(passage_width_m({}, hall), 1.4, 1e-12);
  const std::vector<Vec2> post{{2.0, 0.1}};
  EXPECT_NEAR(passage_width_m(post, hall), 0.8, 1e-12);
  // Staggered posts block the straight lane but leave a way round.
  const std::vector<Vec2> staggered{{1.0, -0.3}, {3.0, 0.3}};
  EXPECT_NEAR(passage_width_m(staggered, hall), 1.0, 1e-12);
  const Strip across{{0.0, -0.7}, {0.0, 0.7}, 0.0, 4.0};
  EXPECT_NEAR(widest_gap(staggered, across).width_m(), 0.6, 1e-12);
  const std::vector<Vec2> fence{{1.0, -0.5}, {1.0, -0.1}, {1.0, 0.3}};
  EXPECT_NEAR(passage_width_m(fence, hall), 0.4, 1e-12);
}

// A disc of diameter w passes if the sides stay apart when everything within w/2 of points is filled: whether the left
// side is connected to the right one by steps shorter than w, tried width by width.
double slow_passage_m(const std::vector<Vec2>& points, const Strip& strip) {
  const auto blocked = [&](double width) {
    std::vector<Vec2> reached;
    std::vector<bool> seen(points.size(), false);
    for (std::size_t k = 0; k < points.size(); ++k)
      if (strip.left_m - points[k].y <= width) {
        seen[k] = true;
        reached.push_back(points[k]);
      }
    for (std::size_t n = 0; n < reached.size(); ++n)
      for (std::size_t k = 0; k < points.size(); ++k)
        if (!seen[k] && norm(points[k] - reached[n]) <= width) {
          seen[k] = true;
          reached.push_back(points[k]);
        }
    for (const Vec2 p : reached)
      if (p.y + strip.right_m <= width) return true;
    return strip.left_m + strip.right_m <= width;
  };
  double low = 0.0, high = strip.left_m + strip.right_m;
  for (int round = 0; round < 60; ++round) (blocked(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return high;
}

TEST(Passability, PassageAgreesWithTryingWidths) {
  const Strip hall{{0.0, 0.0}, {2.0, 0.0}, 0.7, 0.7};
  Rng rng(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec2> points;
    for (int k = 0; k < 12; ++k) points.push_back({rng.uniform(0.0, 2.0), rng.uniform(-0.7, 0.7)});
    EXPECT_NEAR(passage_width_m(points, hall), slow_passage_m(points, hall), 1e-9);
  }
}

}  // namespace
}  // namespace echoarc
