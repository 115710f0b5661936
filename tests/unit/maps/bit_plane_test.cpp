// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/bit_plane.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/maps/tiled_bits.hpp"
#include "maps/bit_kernels.hpp"

namespace echoarc {
namespace {

/// The obvious way, cell by cell.
template <class Rule>
BitPlane slow(const BitPlane& plane, Rule&& rule) {
  BitPlane out(plane.width(), plane.height());
  for (std::int32_t j = 0; j < plane.height(); ++j)
    for (std::int32_t i = 0; i < plane.width(); ++i) {
      int neighbours = 0;
      for (std::int32_t dj = -1; dj <= 1; ++dj)
        for (std::int32_t di = -1; di <= 1; ++di)
          if (const Cell c{i + di, j + dj}; (di != 0 || dj != 0) && plane.box().contains(c) && plane.at(c))
            ++neighbours;
      if (rule(plane.at({i, j}), neighbours)) out.set({i, j});
    }
  return out;
}

BitPlane slow_thinned(const BitPlane& plane, int m) {
  return slow(plane, [&](bool set, int neighbours) { return set && neighbours >= m; });
}
BitPlane slow_dilated(const BitPlane& plane) {
  return slow(plane, [](bool set, int neighbours) { return set || neighbours > 0; });
}

BitPlane random_plane(Rng& rng) {
  BitPlane plane(std::int32_t(1 + rng.below(200)), std::int32_t(1 + rng.below(70)));
  const double share = rng.uniform();
  for (std::int32_t j = 0; j < plane.height(); ++j)
    for (std::int32_t i = 0; i < plane.width(); ++i) plane.set({i, j}, rng.uniform() < share);
  return plane;
}

/// V3.3: 15 cells in a block, a tail of three, a lone cell and a pair.
BitPlane worked_example() {
  BitPlane plane(9, 7);
  for (int j = 2; j <= 4; ++j)
    for (int i = 1; i <= 5; ++i) plane.set({i, j});
  for (int i = 6; i <= 8; ++i) plane.set({i, 3});
  for (const Cell c : {Cell{8, 0}, Cell{0, 0}, Cell{0, 1}}) plane.set(c);
  return plane;
}

TEST(BitPlane, ThinningWorkedNumbers) {
  const std::int64_t survivors[] = {21, 20, 18, 16, 15, 11, 4, 3, 3};
  for (int m = 0; m <= 8; ++m) EXPECT_EQ(worked_example().thinned(m).count(), survivors[m]) << m;
  BitPlane eroded(9, 7);
  for (int i = 2; i <= 4; ++i) eroded.set({i, 3});
  EXPECT_EQ(worked_example().thinned(8), eroded);
  const BitPlane three = worked_example().thinned(3);
  EXPECT_TRUE(three.at({6, 3}));
  EXPECT_EQ(three.thinned(3).count(), 16);
  EXPECT_EQ(three.thinned(3).thinned(3).count(), 16);
}

TEST(BitPlane, OpeningAndClosing) {
  BitPlane plane(140, 20);  // a bar across two words with a hole of one cell, and a hair on it
  for (int j = 5; j < 12; ++j)
    for (int i = 50; i < 100; ++i) plane.set({i, j}, i != 64 || j != 8);
  const std::int64_t bar = plane.count() + 1;
  for (int j = 12; j < 18; ++j) plane.set({70, j});
  EXPECT_EQ(plane.closed().count(), bar + 6);
  EXPECT_TRUE(plane.closed().at({64, 8}));
  EXPECT_FALSE(plane.opened().at({70, 15}));
  BitPlane full(65, 3);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 65; ++i) full.set({i, j});
  EXPECT_EQ(full.closed(), full) << "closing never takes a cell away, at the border neither";
}

RC_GTEST_PROP(BitPlaneProperty, EqualsTheSlowForms, (std::uint64_t seed)) {
  Rng rng(seed);
  const BitPlane plane = random_plane(rng);
  BitPlane previous = plane;
  for (int m = 0; m <= 8; ++m) {
    const BitPlane thinned = plane.thinned(m);
    RC_ASSERT(thinned == slow_thinned(plane, m));
    RC_ASSERT(slow(thinned, [](bool set, int) { return set; }).count() <= previous.count());
    previous = thinned;
  }
  RC_ASSERT(plane.dilated() == slow_dilated(plane));
  RC_ASSERT(plane.eroded() == slow_thinned(plane, 8));
  RC_ASSERT(plane.opened() == slow_dilated(slow_thinned(plane, 8)));
}

RC_GTEST_PROP(TiledBitsProperty, EqualTheDensePlane, (std::uint64_t seed)) {
  Rng rng(seed);
  TiledGrid<std::uint16_t> grid({.cell_m = 0.1}, std::size_t{64} << 20);
  const double share = rng.uniform();
  BitPlane plane(200, 100);
  const Cell shift{-70, -40};  // tiles on all sides of the origin; some stay empty
  for (std::int32_t j = 0; j < plane.height(); ++j)
    for (std::int32_t i = 0; i < plane.width(); ++i) {
      if (rng.uniform() >= share || (i > 60 && i < 140)) continue;
      const Cell c{i + shift.i, j + shift.j};
      ASSERT_TRUE(grid.ensure(grid.tile_of(c)));
      grid.at(c) = 1;
      plane.set({i, j});
    }
  const TiledBits bits(grid, [](std::uint16_t n) { return n != 0; });
  RC_ASSERT(bits.count() == plane.count());
  for (const int m : {0, 1, 3, 5, 7, 8}) {
    const TiledBits tiled = bits.thinned(m);
    const BitPlane dense = plane.thinned(m);
    RC_ASSERT(tiled.count() == dense.count());
    bool equal = true;
    for (std::int32_t j = 0; j < plane.height(); ++j)
      for (std::int32_t i = 0; i < plane.width(); ++i)
        equal = equal && tiled.at({i + shift.i, j + shift.j}) == dense.at({i, j});
    RC_ASSERT(equal);
  }
}

TEST(BitKernels, SameCellsFromEveryInstructionSet) {
  std::vector<const kernels::BitKernels*> list(8);
  list.resize(kernels::available_bit_kernels(list.data(), list.size()));
  Rng rng(3);
  std::vector<std::uint64_t> words(1000);
  for (std::uint64_t& word : words) word = rng.below(~std::uint64_t{0});
  const std::uint64_t* const first = words.data() + 101;
  const kernels::BitRows rows{first - 1, first, first + 1, 100};
  for (int m = 0; m <= 8; ++m) {
    std::vector<std::uint64_t> expected(777);
    list.front()->thin(rows, expected.size(), m, expected.data());
    for (const auto* kernels : list) {
      std::vector<std::uint64_t> out(777);
      kernels->thin(rows, out.size(), m, out.data());
      EXPECT_EQ(out, expected) << kernels->instruction_set;
    }
  }
}

}  // namespace
}  // namespace echoarc
