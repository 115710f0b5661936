// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name.

#include "mapping/vote_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

// Most rows of an arc hold one to five cells. Counting a block that never straddles a tile or a cache line under a mask
// costs no branch that depends on their number. Indices are unsigned: they are never negative, and need no extension.
constexpr std::uint32_t block = 16;
constexpr std::uint32_t tile_shift = 6;
constexpr std::uint32_t tile_size = 1 << tile_shift;

/// steps[block - n + l] is 1 for l >= n, else 0.
alignas(32) constexpr std::uint16_t steps[2 * block] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                                        1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

/// Counts the cells of a block from the one `before_end` from its end on, but for the last `left`.
inline void count_block(std::uint16_t* __restrict counts, std::uint32_t before_end, std::uint32_t left) {
  const std::uint16_t* const from_begin = steps + before_end;
  const std::uint16_t* const from_end = steps + left;
#pragma GCC unroll 1  // unrolled early, the loop would be out of reach of the vectoriser
  for (std::uint32_t l = 0; l < block; ++l) {
    const std::uint16_t before = counts[l];
    const auto one = static_cast<std::uint16_t>(from_begin[l] - from_end[l]);
    counts[l] = static_cast<std::uint16_t>(before + (before != 0xffff ? one : 0));
  }
}

/// Where the block of column i, counted from the first tile, lies in a tile.
inline std::uint32_t offset_of(std::uint32_t row, std::uint32_t i) {
  return (row << tile_shift) + (i & (tile_size - block));
}

/// Counts the cells i <= ... < end, counted from the first tile, of a row: what a run has beyond its first block.
void count_rest(const CountRows& rows, std::uint32_t row, std::uint32_t i, std::uint32_t end) {
  for (; i < end; i += block)
    count_block(rows.tiles[i >> tile_shift] + offset_of(row, i), block, end - i < block ? block - (end - i) : 0);
}

}  // namespace

void find_blocks(const CountRows& rows, std::uint16_t** __restrict blocks) {
  const CountRows r = rows;
  for (std::uint32_t k = 0; k < r.count; ++k) {
    // A row without cells may begin one column past the last tile; any block will do for it.
    const std::uint32_t i = r.i_begin[k] < r.i_end[k] ? static_cast<std::uint32_t>(r.i_begin[k]) - r.tiles_begin : 0;
    blocks[k] = r.tiles[i >> tile_shift] + offset_of(r.row + k, i);
    __builtin_prefetch(blocks[k], 1);
  }
}

void count(const CountRows& rows, std::uint16_t* const* blocks) {
  const CountRows r = rows;
  for (std::uint32_t k = 0; k < r.count; ++k) {
    if (r.i_end[k] <= r.i_begin[k]) continue;
    const std::uint32_t begin = static_cast<std::uint32_t>(r.i_begin[k]) - r.tiles_begin;
    const std::uint32_t end = static_cast<std::uint32_t>(r.i_end[k]) - r.tiles_begin;
    const std::uint32_t next_block = (begin | (block - 1)) + 1;
    if (end <= next_block) {
      count_block(blocks[k], next_block - begin, next_block - end);
    } else {
      count_block(blocks[k], next_block - begin, 0);
      count_rest(r, r.row + k, next_block, end);
    }
  }
}

}  // namespace echoarc::kernels::ECHOARC_ISA
