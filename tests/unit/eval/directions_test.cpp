// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/directions.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/correct_detection.hpp"
#include "points.hpp"

namespace echoarc {
namespace {

/// How many directions are full of the one point.
std::uint64_t lines_of(Vec2 p, const DirectionSet& directions, double cell_m = 0.0) {
  const auto score = correct_detection({}, test::reference_of({p}, cell_m), directions);
  EXPECT_TRUE(score) << score.error().message;
  return score->full;
}

TEST(Directions, ColumnsAreTheColumnsOfTheGrid) {
  const GridGeometry geometry{0.01, {-0.30, 0.0}};
  const DirectionSet columns = column_directions(geometry, 121, 130);
  EXPECT_EQ(columns.line_count(), 121);
  ASSERT_EQ(columns.families.size(), 1U);
  for (int i = 0; i < 121; ++i) EXPECT_EQ(lines_of(geometry.centre({i, 77}), columns), 1U);
  EXPECT_EQ(lines_of(geometry.centre({121, 0}), columns), 0U);
  EXPECT_EQ(lines_of(geometry.centre({-1, 0}), columns), 0U);
  EXPECT_EQ(lines_of(geometry.centre({5, 130}), columns), 0U) << "above the grid";
  EXPECT_EQ(lines_of(geometry.centre({5, -1}), columns), 0U) << "below the grid";
}

TEST(Directions, RowsAreTheRowsOfTheGrid) {
  const GridGeometry geometry{0.1, {1.0, -2.0}};
  const DirectionSet rows = row_directions(geometry, 5, 3);
  EXPECT_EQ(rows.line_count(), 3);
  EXPECT_EQ(lines_of(geometry.centre({4, 2}), rows), 1U);
  EXPECT_EQ(lines_of(geometry.centre({5, 2}), rows), 0U);
  EXPECT_EQ(lines_of(geometry.centre({4, 3}), rows), 0U);
}

TEST(Directions, AxisLinesHaveAMiddleThroughTheOrigin) {
  const Box region{{-1.0, -1.0}, {1.0, 1.0}};
  // Middles at x = 0, +-0.5, +-1: the outer two are half outside.
  EXPECT_EQ(axis_directions(region, {0.0, 7.0}, degrees(90.0), 0.5).line_count(), 5);
  // Middles at x = +-0.25, +-0.75: they tile the region.
  EXPECT_EQ(axis_directions(region, {0.25, 0.0}, degrees(90.0), 0.5).line_count(), 4);
}

TEST(Directions, AxisLinesCoverTheRegionWhateverTheirDirection) {
  const Box region{{-1.0, 0.0}, {2.0, 1.0}};
  for (const double along_deg : {0.0, 30.0, 90.0, 135.0, 180.0, -77.0}) {
    const DirectionSet lines = axis_directions(region, {0.3, 0.4}, degrees(along_deg), 0.02);
    ASSERT_TRUE(validate(lines));
    for (double x = -0.995; x < 2.0; x += 0.05)
      for (double y = 0.001; y < 1.0; y += 0.05)
        ASSERT_EQ(lines_of({x, y}, lines), 1U) << along_deg << " degrees, " << x << ", " << y;
  }
}

TEST(Directions, WallLinesGoOutwardFromTheInterior) {
  // The lower wall of a room, from left to right: the inside is above, lines look down.
  const std::vector<WallSpan> walls = {{{0.0, 0.0}, {1.0, 0.0}, 0.5}};
  const DirectionSet lines = wall_directions(walls, {{-1.0, -1.0}, {2.0, 2.0}}, 0.01);
  EXPECT_EQ(lines.line_count(), 100);
  ASSERT_TRUE(validate(lines));
  EXPECT_EQ(lines_of({0.005, 0.0}, lines), 1U) << "on the wall";
  EXPECT_EQ(lines_of({0.005, 0.49}, lines), 1U) << "between path and wall";
  EXPECT_EQ(lines_of({0.005, -0.9}, lines), 1U) << "behind the wall";
  EXPECT_EQ(lines_of({0.005, 0.51}, lines), 0U) << "behind the robot";
  EXPECT_EQ(lines_of({0.005, -1.1}, lines), 0U) << "beyond the border";
  EXPECT_EQ(lines_of({-0.005, 0.0}, lines), 0U) << "beside the span";
}

TEST(Directions, ACornerLiesOnLinesOfBothWalls) {
  const std::vector<WallSpan> walls = {{{0.0, 0.0}, {1.0, 0.0}, 0.5}, {{1.0, 0.0}, {1.0, 1.0}, 0.5}};
  const DirectionSet lines = wall_directions(walls, {{-1.0, -1.0}, {2.0, 2.0}}, 0.01);
  EXPECT_EQ(lines.line_count(), 200);
  EXPECT_EQ(lines_of({0.995, 0.005}, lines), 2U);
}

TEST(Directions, AWallShorterThanHalfALineHasNone) {
  const std::vector<WallSpan> walls = {{{0.0, 0.0}, {0.004, 0.0}, 0.5}, {{1.0, 1.0}, {1.0, 1.0}, 0.5}};
  EXPECT_TRUE(wall_directions(walls, {{-1.0, -1.0}, {2.0, 2.0}}, 0.01).families.empty());
}

TEST(Directions, CoarseCellsLieOnEveryFineLineTheyCover) {
  const DirectionSet fine = column_directions({0.01, {0.0, 0.0}}, 100, 100);
  const GridGeometry coarse{0.05, {0.0, 0.0}};
  EXPECT_EQ(lines_of(coarse.centre({3, 3}), fine, 0.05), 5U);
  EXPECT_EQ(lines_of({0.155, 0.5}, fine, 0.01), 1U) << "a cell of the grid itself";
  EXPECT_EQ(lines_of({0.155, 0.5}, fine, 0.001), 1U) << "a finer cell is on the line of its centre";
  EXPECT_EQ(lines_of({0.02, 0.5}, fine, 1.0), 52U) << "clipped at the first line";
}

TEST(Directions, RefusesWhatAreNoLines) {
  const LineFamily good{{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, 0.01, 10};
  const auto refuses = [](const LineFamily& family) { return !validate(DirectionSet{{}, {family}}); };
  ASSERT_FALSE(refuses(good));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  LineFamily bad = good;
  bad.corner.x = nan;
  EXPECT_TRUE(refuses(bad));
  for (const Vec2 along : {Vec2{0.0, 2.0}, Vec2{1.0, 0.0}, Vec2{nan, 1.0}, Vec2{0.0, 0.0}}) {
    bad = good;
    bad.along = along;
    EXPECT_TRUE(refuses(bad)) << along.x << ", " << along.y;
  }
  for (const double width_m : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    bad = good;
    bad.width_m = width_m;
    EXPECT_TRUE(refuses(bad)) << width_m;
  }
  for (const std::int32_t count : {-1, 2'000'000'000}) {
    bad = good;
    bad.count = count;
    EXPECT_TRUE(refuses(bad)) << count;
  }
  EXPECT_FALSE(validate(axis_directions({{0.0, 0.0}, {1e6, 1e6}}, {0.0, 0.0}, degrees(90.0), 1e-6)));
  EXPECT_FALSE(correct_detection({}, test::reference_of({{0.0, 0.0}}), DirectionSet{{}, {bad}}));
}

}  // namespace
}  // namespace echoarc
