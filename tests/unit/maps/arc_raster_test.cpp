// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/arc_raster.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "support/slow_arc_cells.hpp"

namespace echoarc {
namespace {

std::vector<Cell> cells_of(const GridGeometry& grid, const Arc& arc, ArcSampling sampling) {
  ArcRaster raster(grid, sampling);
  const auto cells = raster.cells(arc);
  return {cells.begin(), cells.end()};
}

constexpr ArcSampling both_ways[] = {ArcSampling::sampled, ArcSampling::exact};

// V2.1: 49 cells; by row 98 -> 12, 99 -> 16, 100 -> 21.
TEST(ArcRaster, MetreArcWorkedNumbers) {
  const GridGeometry grid{.cell_m = 0.01, .origin = {-0.5, 0.0}};
  const Arc arc = Arc::circular({0.005, 0.005}, degrees(90.0), 1.0, degrees(25.0));
  for (const ArcSampling sampling : both_ways) {
    std::map<int, int> per_row;
    for (const Cell c : cells_of(grid, arc, sampling)) ++per_row[c.j];
    EXPECT_EQ(per_row, (std::map<int, int>{{98, 12}, {99, 16}, {100, 21}}));
  }
}

// V2.2
TEST(ArcRaster, TinyArcWorkedNumbers) {
  const GridGeometry grid{.cell_m = 0.01, .origin = {-0.5, 0.0}};
  const Arc arc = Arc::circular({0.005, 0.005}, degrees(90.0), 0.05, degrees(25.0));
  for (const ArcSampling sampling : both_ways)
    EXPECT_EQ(cells_of(grid, arc, sampling), (std::vector<Cell>{{51, 5}, {50, 5}, {49, 5}}));
}

// V2.3: the arc crosses the bearing of 180 degrees.
TEST(ArcRaster, WrapAroundWorkedNumbers) {
  const GridGeometry grid{.cell_m = 0.01};
  const Arc arc = Arc::circular({0.505, 0.505}, degrees(180.0), 0.20, degrees(25.0));
  std::vector<Cell> expected;
  for (int j = 54; j >= 46; --j) expected.push_back({30, j});
  for (const ArcSampling sampling : both_ways) EXPECT_EQ(cells_of(grid, arc, sampling), expected);
}

// Section 2: the arc leaves cell (0,4), enters (0,5) and returns; each is counted once.
TEST(ArcRaster, ReturningArcCountsACellOnce) {
  const GridGeometry grid{.cell_m = 0.01};
  const Arc arc = Arc::circular({0.005, 0.00001}, degrees(90.0), 0.05, degrees(10.0));
  EXPECT_EQ(cells_of(grid, arc, ArcSampling::exact), (std::vector<Cell>{{0, 4}, {0, 5}}));
}

// From cell (-1,-1), whose indices have all bits set, into cell (0,0), whose indices have none.
TEST(ArcRaster, CrossesTheOrigin) {
  const GridGeometry grid{.cell_m = 0.1};
  const Arc arc = Arc::circular({-0.905, 0.953}, radians(-0.3), 1.308, radians(1.044));
  const auto cells = cells_of(grid, arc, ArcSampling::sampled);
  ASSERT_GE(cells.size(), 2U);
  EXPECT_EQ(cells[0], (Cell{-1, -1}));
  EXPECT_EQ(cells[1], (Cell{0, 0}));
}

Arc arbitrary_arc(Rng& rng) {
  const Pose2 tx{{rng.uniform(-5, 5), rng.uniform(-5, 5)}, degrees(rng.uniform(-180, 180))};
  const double range_m = rng.below(3) == 0 ? rng.uniform(0.02, 0.2) : rng.uniform(0.2, 6.0);
  const Angle beam = degrees(rng.uniform(2.0, 120.0));
  if (rng.below(2) == 0) return Arc::circular(tx.position, tx.heading, range_m, beam);
  const Pose2 rx{tx.position + 0.9 * range_m * Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)},
                 tx.heading + degrees(rng.uniform(-60, 60))};
  return *Arc::elliptical(tx, rx, range_m, beam);
}

/// The obvious way: every sample through the library's sine, every cell remembered.
std::set<Cell> slow_sampled_cells(const GridGeometry& grid, const Arc& arc) {
  const double bound_m = arc.range_m() * arc.range_m() / arc.semi_minor_m();
  const double span = (arc.t_end() - arc.t_begin()).rad();
  const int count = std::max(2, int(std::ceil(span * bound_m / (0.5 * grid.cell_m))) + 1);
  std::set<Cell> cells;
  for (int k = 0; k < count; ++k)
    cells.insert(grid.cell_of(arc.point_at(arc.t_begin() + radians(span * k / (count - 1)))));
  return cells;
}

RC_GTEST_PROP(ArcRasterProperty, SampledEqualsTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  const GridGeometry grid{.cell_m = rng.below(2) == 0 ? 0.01 : 0.05,
                          .origin = {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  for (int k = 0; k < 20; ++k) {
    const Arc arc = arbitrary_arc(rng);
    const auto cells = cells_of(grid, arc, ArcSampling::sampled);
    const std::set<Cell> distinct(cells.begin(), cells.end());
    RC_ASSERT(distinct.size() == cells.size());
    RC_ASSERT(distinct == slow_sampled_cells(grid, arc));
  }
}

RC_GTEST_PROP(ArcRasterProperty, ExactEqualsTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  const GridGeometry grid{.cell_m = rng.below(2) == 0 ? 0.01 : 0.05,
                          .origin = {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  for (int k = 0; k < 5; ++k) {
    const Arc arc = arbitrary_arc(rng);
    const auto cells = cells_of(grid, arc, ArcSampling::exact);
    const std::set<Cell> distinct(cells.begin(), cells.end());
    RC_ASSERT(distinct.size() == cells.size());
    RC_ASSERT(distinct == test::slow_exact_cells(grid, arc));
  }
}

// Whole quarter turns about a cell corner, with the outermost points of the arc on grid lines.
TEST(ArcRaster, ArcThatTouchesGridLinesDoesNotEnterThem) {
  const GridGeometry grid{.cell_m = 0.01};
  const auto right = cells_of(grid, Arc::circular({0, 0}, degrees(0.0), 1.0, degrees(30.0)), ArcSampling::exact);
  const auto up = cells_of(grid, Arc::circular({0, 0}, degrees(90.0), 1.0, degrees(30.0)), ArcSampling::exact);
  EXPECT_EQ(right.size(), up.size());
  for (const Cell c : right) EXPECT_LT(c.i, 100);
  for (const Cell c : up) EXPECT_LT(c.j, 100);
}

RC_GTEST_PROP(ArcRasterProperty, ExactHoldsEverySampleAndLeavesNoGap, (std::uint64_t seed)) {
  Rng rng(seed);
  const GridGeometry grid{.cell_m = 0.01, .origin = {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  const Arc arc = arbitrary_arc(rng);
  const auto cells = cells_of(grid, arc, ArcSampling::exact);
  const std::set<Cell> exact(cells.begin(), cells.end());
  RC_ASSERT(exact.size() == cells.size());
  for (int k = 1; k < 5000; ++k) {
    const Vec2 p = arc.point_at(arc.t_begin() + (k / 5000.0) * (arc.t_end() - arc.t_begin()));
    RC_ASSERT(exact.contains(grid.cell_of(p)));
  }
  const auto sampled = cells_of(grid, arc, ArcSampling::sampled);
  for (std::size_t k = 1; k < sampled.size(); ++k) {
    // The order is that of first entry, so a gap-free arc has a neighbour among the cells before.
    const bool near_previous =
        std::abs(sampled[k].i - sampled[k - 1].i) <= 1 && std::abs(sampled[k].j - sampled[k - 1].j) <= 1;
    const bool near_earlier =
        k >= 2 && std::abs(sampled[k].i - sampled[k - 2].i) <= 1 && std::abs(sampled[k].j - sampled[k - 2].j) <= 1;
    RC_ASSERT(near_previous || near_earlier);
  }
}

}  // namespace
}  // namespace echoarc
