// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/vote_kernels.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc::kernels {
namespace {

std::vector<const VoteKernels*> all_kernels() {
  std::vector<const VoteKernels*> list(8);
  list.resize(available_vote_kernels(list.data(), list.size()));
  return list;
}

constexpr std::size_t tiles_across = 3;
constexpr std::uint32_t columns_begin = 0U - 64U;  // column -64
using Tile = std::array<std::uint16_t, 64 * 64>;
using Tiles = std::array<Tile, tiles_across>;

/// Runs of all lengths, empty ones among them.
struct Runs {
  std::vector<std::int32_t> begin;
  std::vector<std::int32_t> end;
};

Runs random_runs(Rng& rng, std::size_t count) {
  Runs runs;
  for (std::size_t k = 0; k < count; ++k) {
    const auto begin = std::int32_t(rng.below(64 * tiles_across)) - 64;
    const auto longest = std::uint64_t(64 * (tiles_across - 1) - begin);
    runs.begin.push_back(begin);
    runs.end.push_back(begin + std::int32_t(rng.below(std::min<std::uint64_t>(longest, k % 3 == 0 ? 130 : 6) + 1)));
  }
  return runs;
}

void count(const VoteKernels& kernels, Tiles& tiles, std::uint32_t row, const Runs& runs) {
  std::array<std::uint16_t*, tiles_across> pointers{};
  for (std::size_t n = 0; n < tiles_across; ++n) pointers[n] = tiles[n].data();
  const CountRows rows{pointers.data(),   columns_begin,  row, std::uint32_t(runs.begin.size()),
                       runs.begin.data(), runs.end.data()};
  std::vector<std::uint16_t*> blocks(runs.begin.size());
  kernels.find_blocks(rows, blocks.data());
  kernels.count(rows, blocks.data());
}

TEST(CountRows, EveryInstructionSetCountsTheCellsOfTheRuns) {
  Rng rng(11);
  for (int n = 0; n < 50; ++n) {
    const auto row = std::uint32_t(rng.below(40));
    const Runs runs = random_runs(rng, 1 + rng.below(24));
    Tiles expected{};
    for (std::size_t k = 0; k < runs.begin.size(); ++k)
      for (std::int32_t i = runs.begin[k] + 64; i < runs.end[k] + 64; ++i)
        ++expected[std::size_t(i / 64)][(row + k) * 64 + std::size_t(i % 64)];
    for (const auto* kernels : all_kernels()) {
      Tiles tiles{};
      count(*kernels, tiles, row, runs);
      ASSERT_EQ(tiles, expected) << kernels->instruction_set;
    }
  }
}

TEST(CountRows, ARowWithoutCellsMayBeginPastTheLastTile) {
  Tile tile{};
  std::uint16_t* const pointers[] = {tile.data(), nullptr};
  const std::int32_t begin[] = {64};
  const CountRows rows{pointers, 0, 5, 1, begin, begin};
  for (const auto* kernels : all_kernels()) {
    std::uint16_t* block = nullptr;
    kernels->find_blocks(rows, &block);
    EXPECT_TRUE(block >= tile.data() && block < tile.data() + tile.size()) << kernels->instruction_set;
    kernels->count(rows, &block);
    EXPECT_EQ(tile, Tile{}) << kernels->instruction_set;
  }
}

TEST(CountRows, FullCountsStay) {
  const Runs runs{{3}, {6}};
  for (const auto* kernels : all_kernels()) {
    Tiles tiles{};
    tiles[1][4] = 65535;
    tiles[1][5] = 65534;
    for (int n = 0; n < 3; ++n) count(*kernels, tiles, 0, runs);
    EXPECT_EQ(tiles[1][3], 3) << kernels->instruction_set;
    EXPECT_EQ(tiles[1][4], 65535) << kernels->instruction_set;
    EXPECT_EQ(tiles[1][5], 65535) << kernels->instruction_set;
    EXPECT_EQ(tiles[1][2], 0) << kernels->instruction_set;
    EXPECT_EQ(tiles[1][6], 0) << kernels->instruction_set;
  }
}

}  // namespace
}  // namespace echoarc::kernels
