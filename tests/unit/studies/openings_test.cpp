// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/openings.hpp"

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

TEST(Openings, StretchesWithoutWalls) {
  sim::WorldDescription world;
  world.walls = {{{2.8, 1.0}, {5.0, 1.0}}, {{-1.0, 1.0}, {2.0, 1.0}}, {{2.0, 1.0}, {2.0, 3.0}}};
  const auto open = open_stretches(world, {0.0, 1.0}, {6.0, 1.0});
  ASSERT_EQ(open.size(), 2U);
  EXPECT_NEAR(open[0].begin_m, 2.0, 1e-12);
  EXPECT_NEAR(open[0].end_m, 2.8, 1e-12);
  EXPECT_NEAR(open[1].begin_m, 5.0, 1e-12);
  EXPECT_NEAR(open[1].end_m, 6.0, 1e-12);
  const Strip strip = strip_over({0.0, 1.0}, {6.0, 1.0}, open[0], 0.2);
  EXPECT_NEAR(strip.length_m(), 0.8, 1e-12);
  EXPECT_TRUE(strip.local({2.4, 1.1}));
  EXPECT_FALSE(strip.local({2.4, 1.3}));
}

TEST(Openings, BackwardsAndWhole) {
  sim::WorldDescription world;
  world.walls = {{{0.0, 0.0}, {1.0, 0.0}}};
  const auto open = open_stretches(world, {3.0, 0.0}, {0.0, 0.0});
  ASSERT_EQ(open.size(), 1U);
  EXPECT_NEAR(open[0].width_m(), 2.0, 1e-12);
  EXPECT_TRUE(open_stretches(world, {0.0, 0.0}, {1.0, 0.0}).empty());
}

}  // namespace
}  // namespace echoarc::studies
