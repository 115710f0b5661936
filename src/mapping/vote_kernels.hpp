// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loop of `VoteGrid`, compiled once per instruction set (cmake/EchoarcKernels.cmake). This header and the
// kernel source include nothing that holds inline functions: two copies of one, compiled with different flags, must
// never meet in the linker.

#include <cstddef>
#include <cstdint>

namespace echoarc::kernels {

/// Cells in a row of tiles of 64 x 64 counts, of which tiles[n] begins at column tiles_begin + 64 n: columns
/// i_begin[k] <= i < i_end[k] of row `row` + k of the tiles, for 0 <= k < count.
struct CountRows {
  std::uint16_t* const* tiles;
  std::uint32_t tiles_begin;
  std::uint32_t row;
  std::uint32_t count;
  const std::int32_t* i_begin;
  const std::int32_t* i_end;
};

struct VoteKernels {
  const char* instruction_set;
  /// Finds the block of counts in which each row's cells begin, and asks the memory for it.
  void (*find_blocks)(const CountRows& rows, std::uint16_t** blocks);
  /// Adds one to all counts below 65535, given their blocks.
  void (*count)(const CountRows& rows, std::uint16_t* const* blocks);
};

/// The kernels for this processor, chosen once. All of them give the same counts.
const VoteKernels& vote_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_vote_kernels(const VoteKernels** list, std::size_t room);

}  // namespace echoarc::kernels
