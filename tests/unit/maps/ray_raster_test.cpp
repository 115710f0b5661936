// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/ray_raster.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

constexpr CellBox everywhere{-1000, -1000, 1000, 1000};
const GridGeometry unit_cells{.cell_m = 1.0, .origin = {}};

std::vector<Cell> cells(Vec2 origin, Vec2 direction, double length_m, const CellBox& within = everywhere,
                        const GridGeometry& geometry = unit_cells) {
  RayRaster raster(geometry);
  const auto span = raster.cells(origin, direction, length_m, within);
  return {span.begin(), span.end()};
}

using Cells = std::vector<Cell>;

TEST(RayRaster, AlongTheAxes) {
  EXPECT_EQ(cells({0.5, 0.5}, {1, 0}, 2.2), (Cells{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(cells({0.5, 0.5}, {0, -1}, 1.0), (Cells{{0, 0}, {0, -1}}));
  EXPECT_EQ(cells({0.5, 0.5}, {-1, 0}, 0.2), (Cells{{0, 0}}));
}

TEST(RayRaster, AnEdgeBelongsToTheCellThatOwnsIt) {
  EXPECT_EQ(cells({0.5, 1.0}, {1, 0}, 1.0), (Cells{{0, 1}, {1, 1}}));
}

TEST(RayRaster, ThroughACornerVisitsBothNeighbours) {
  const double s = std::sqrt(0.5);
  EXPECT_EQ(cells({0.5, 0.5}, {s, s}, 1.5), (Cells{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
}

TEST(RayRaster, StaysInTheBox) {
  EXPECT_EQ(cells({-5.0, 0.5}, {1, 0}, 100.0, {2, 0, 5, 1}), (Cells{{2, 0}, {3, 0}, {4, 0}}));
  EXPECT_TRUE(cells({-5.0, 1.5}, {1, 0}, 100.0, {2, 0, 5, 1}).empty());
  EXPECT_TRUE(cells({-5.0, 0.5}, {1, 0}, 6.5, {2, 0, 5, 1}).empty());
  EXPECT_TRUE(cells({-5.0, 0.5}, {-1, 0}, 100.0, {2, 0, 5, 1}).empty());
  EXPECT_TRUE(cells({0.5, 0.5}, {1, 0}, 100.0, {}).empty());
}

/// The slow obvious version: every cell of the box whose open square the segment meets in a piece of positive length.
Cells crossed_cells(Vec2 origin, Vec2 direction, double length_m, const CellBox& box, const GridGeometry& geometry) {
  struct Crossing {
    double t;
    Cell cell;
  };
  std::vector<Crossing> crossings;
  for (std::int32_t j = box.j_begin; j < box.j_end; ++j)
    for (std::int32_t i = box.i_begin; i < box.i_end; ++i) {
      const Vec2 low = geometry.corner({i, j});
      const Vec2 high = geometry.corner({i + 1, j + 1});
      const double tx[] = {(low.x - origin.x) / direction.x, (high.x - origin.x) / direction.x};
      const double ty[] = {(low.y - origin.y) / direction.y, (high.y - origin.y) / direction.y};
      const double t_in = std::max({0.0, std::min(tx[0], tx[1]), std::min(ty[0], ty[1])});
      const double t_out = std::min({length_m, std::max(tx[0], tx[1]), std::max(ty[0], ty[1])});
      if (t_out > t_in + 1e-9) crossings.push_back({t_in, {i, j}});
    }
  std::ranges::sort(crossings, {}, &Crossing::t);
  Cells cells;
  for (const Crossing& c : crossings) cells.push_back(c.cell);
  return cells;
}

RC_GTEST_PROP(RayRasterProperty, FindsTheCellsTheSegmentCrossesInOrder, (std::uint64_t seed)) {
  Rng rng(seed);
  const GridGeometry geometry{.cell_m = rng.uniform(0.01, 0.1), .origin = {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
  const CellBox box{-int(rng.below(30)), -int(rng.below(30)), int(rng.below(30)), int(rng.below(30))};
  const Vec2 origin{rng.uniform(-2, 2), rng.uniform(-2, 2)};
  const Vec2 direction = unit(degrees(rng.uniform(-180, 180)));
  const double length_m = rng.uniform(0.0, 4.0);
  const Cells fast = cells(origin, direction, length_m, box, geometry);
  RC_ASSERT(fast == crossed_cells(origin, direction, length_m, box, geometry));
}

/// Rays anywhere, and such as run through corners and along edges.
RC_GTEST_PROP(RayRasterProperty, LeavesOutOnlyWhatABlockMaskLeavesOut, (std::uint64_t seed)) {
  Rng rng(seed);
  const CellBox box{-int(rng.below(150)), -int(rng.below(150)), 1 + int(rng.below(150)), 1 + int(rng.below(150))};
  BlockMask blocks(box);
  for (std::uint64_t k = rng.below(40); k > 0; --k)
    blocks.mark({box.i_begin + int(rng.below(std::uint64_t(box.width()))),
                 box.j_begin + int(rng.below(std::uint64_t(box.height())))});
  const bool on_lattice = rng.below(2) == 0;
  const auto place = [&] { return on_lattice ? 0.5 * double(rng.below(600)) - 150.0 : rng.uniform(-150, 150); };
  const double angle_deg = on_lattice ? 45.0 * double(rng.below(8)) : rng.uniform(-180, 180);
  const Vec2 origin{place(), place()};
  const double length_m = rng.uniform(0.0, 300.0);
  const auto wanted = [&](const BlockMask* mask) {
    RayRaster raster(unit_cells);
    Cells found;
    for (const Cell c : raster.cells(origin, unit(degrees(angle_deg)), length_m, box, mask))
      if (blocks.holds(c)) found.push_back(c);
    return found;
  };
  RC_ASSERT(wanted(&blocks) == wanted(nullptr));
}

TEST(BlockMask, HoldsTheBlocksOfMarkedCells) {
  BlockMask blocks({-10, -10, 100, 100});
  blocks.mark({-1, 70});
  EXPECT_TRUE(blocks.holds({-8, 64}));
  EXPECT_TRUE(blocks.holds({-1, 71}));
  EXPECT_FALSE(blocks.holds({0, 70}));
  EXPECT_FALSE(blocks.holds({-9, 70}));
  EXPECT_FALSE(blocks.holds({-1, 72}));
  EXPECT_FALSE(blocks.holds({1000, 70})) << "outside the box";
  EXPECT_FALSE(BlockMask().holds({0, 0}));
}

}  // namespace
}  // namespace echoarc
