// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/tiled_grid.hpp"

#include <map>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

constexpr std::size_t one_mib = std::size_t{1} << 20;

TEST(GridGeometry, CellsAreHalfOpen) {
  const GridGeometry grid{.cell_m = 0.25, .origin = {1.0, -1.0}};
  EXPECT_EQ(grid.cell_of({1.0, -1.0}), (Cell{0, 0}));
  EXPECT_EQ(grid.cell_of({1.25, -1.0}), (Cell{1, 0})) << "the right edge belongs to the neighbour";
  EXPECT_EQ(grid.cell_of({0.999, -1.001}), (Cell{-1, -1}));
  EXPECT_EQ(grid.centre({0, 0}), (Vec2{1.125, -0.875}));
}

TEST(GridGeometry, AbsurdPositionsAreClamped) {
  const GridGeometry grid{.cell_m = 0.001};
  EXPECT_EQ(grid.cell_of({1e300, -1e300}), (Cell{GridGeometry::max_index, -GridGeometry::max_index}));
}

TEST(TiledGrid, GrowsInEveryDirection) {
  TiledGrid<int> grid({.cell_m = 1.0}, one_mib);
  Rng rng(1);
  std::vector<std::pair<Cell, int>> written;
  for (int k = 1; k <= 40; ++k) {
    const Cell c{std::int32_t(rng.below(800)) - 400, std::int32_t(rng.below(800)) - 400};
    ASSERT_TRUE(grid.ensure(TiledGrid<int>::tile_of(c)));
    grid.at(c) = k;
    written.emplace_back(c, k);
  }
  std::map<Cell, int> expected;
  for (const auto& [c, k] : written) expected[c] = k;
  for (const auto& [c, k] : expected) EXPECT_EQ(grid.value(c), k);
  std::map<Cell, int> seen;
  grid.for_each_nonzero([&](Cell c, int value) { seen[c] = value; });
  EXPECT_EQ(seen, expected);
}

TEST(TiledGrid, MemoryLimitIsKeptAndRefusalChangesNothing) {
  TiledGrid<std::uint16_t> grid({.cell_m = 0.01}, 3 * sizeof(TiledGrid<std::uint16_t>::Tile) + 64);
  EXPECT_TRUE(grid.ensure_cells({0, 0, 130, 1}));
  EXPECT_EQ(grid.tile_count(), 3U);
  EXPECT_FALSE(grid.ensure({5, 5}));
  EXPECT_FALSE(grid.ensure_cells({0, 0, 1000000000, 1000000000})) << "a request of 10^18 cells";
  EXPECT_EQ(grid.tile_count(), 3U);
  EXPECT_LE(grid.memory_bytes(), grid.memory_limit_bytes());
}

TEST(TiledGrid, FarAwayTileIsRefusedForItsDirectory) {
  TiledGrid<std::uint16_t> grid({.cell_m = 0.01}, one_mib);
  EXPECT_TRUE(grid.ensure({0, 0}));
  EXPECT_FALSE(grid.ensure({1 << 22, 1 << 22}));
}

TEST(TiledGrid, SaveAndRestore) {
  TiledGrid<float> grid({.cell_m = 0.5, .origin = {1, 2}}, one_mib);
  ASSERT_TRUE(grid.ensure_cells({-70, -3, 70, 3}));
  grid.at({-70, -3}) = 1.5F;
  grid.at({69, 2}) = -2.5F;
  ByteWriter out;
  grid.save(out);
  const std::vector<std::byte> bytes = std::move(out).take();
  TiledGrid<float> copy({}, 0);
  ByteReader in(bytes);
  ASSERT_TRUE(copy.restore(in));
  EXPECT_TRUE(in.done());
  EXPECT_EQ(copy.geometry(), grid.geometry());
  EXPECT_EQ(copy.bounds(), (CellBox{-70, -3, 70, 3}));
  EXPECT_EQ(copy.value({-70, -3}), 1.5F);
  const std::span<const std::byte> all(bytes);
  ByteReader truncated(all.first(all.size() - 1));
  EXPECT_FALSE(copy.restore(truncated));
}

TEST(TiledGrid, DenseCopyHoldsTheBox) {
  TiledGrid<int> grid({.cell_m = 1.0, .origin = {10, 20}}, one_mib);
  ASSERT_TRUE(grid.ensure_cells({-1, -1, 2, 2}));
  grid.at({-1, 0}) = 7;
  grid.at({1, 1}) = 9;
  const DenseGrid<float> dense = to_dense<float>(grid, {-1, 0, 2, 2}, [](int v) { return float(v); });
  EXPECT_EQ(dense.geometry().origin, (Vec2{9, 20}));
  const std::vector<float> expected{7, 0, 0,   // row 0
                                    0, 0, 9};  // row 1
  EXPECT_EQ(std::vector<float>(dense.values().begin(), dense.values().end()), expected);
}

}  // namespace
}  // namespace echoarc
