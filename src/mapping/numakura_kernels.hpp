// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loop of the accumulation grid, compiled once per instruction set (cmake/EchoarcKernels.cmake). This header
// and the kernel source include nothing that holds inline functions: two copies of one, compiled with different flags,
// must never meet in the linker.

#include <cstddef>
#include <cstdint>

namespace echoarc::kernels {

/// The cells begin <= l < end of one row of a tile; `row` points to the row's 64 cells.
struct TileRun {
  std::int32_t* row;
  std::int32_t begin;
  std::int32_t end;
};

struct AccumulationKernels {
  const char* instruction_set;
  /// value = min(value + step, ceiling) for the cells of the runs. No cell of the rows exceeds the ceiling, and
  /// ceiling + step fits into 32 bits.
  void (*raise)(const TileRun* runs, std::size_t count, std::int32_t step, std::int32_t ceiling);
};

/// The kernels for this processor, chosen once. All of them give the same cells.
const AccumulationKernels& accumulation_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_accumulation_kernels(const AccumulationKernels** list, std::size_t room);

}  // namespace echoarc::kernels
