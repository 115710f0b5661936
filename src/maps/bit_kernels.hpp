// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loops of `BitPlane` and `TiledBits`, compiled once per instruction set (cmake/EchoarcKernels.cmake). This
// header and the kernel source include nothing that holds inline functions: two copies of one, compiled with different
// flags, must never meet in the linker.

#include <cstddef>
#include <cstdint>

namespace echoarc::kernels {

/// Words of 64 cells, the lowest bit leftmost. Word n has its neighbours in west[n] and east[n] beside it, and all
/// three have theirs `row` words before (below) and after (above).
struct BitRows {
  const std::uint64_t* west;
  const std::uint64_t* here;
  const std::uint64_t* east;
  std::ptrdiff_t row;
};

struct BitKernels {
  const char* instruction_set;
  /// Keeps the set cells with at least `neighbours` (0 to 8) set cells among their eight neighbours.
  void (*thin)(const BitRows& rows, std::size_t count, int neighbours, std::uint64_t* out);
  /// Sets the cells that are set or have a set neighbour.
  void (*dilate)(const BitRows& rows, std::size_t count, std::uint64_t* out);
};

/// The kernels for this processor, chosen once. All of them give the same cells.
const BitKernels& bit_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_bit_kernels(const BitKernels** list, std::size_t room);

}  // namespace echoarc::kernels
