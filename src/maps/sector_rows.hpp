// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loop of `SectorRaster`, compiled once per instruction set (cmake/EchoarcKernels.cmake). This header and the
// kernel source include nothing that holds inline functions: two copies of one, compiled with different flags, must
// never meet in the linker.

#include <cstddef>
#include <cstdint>

namespace echoarc::kernels {

/// A sector in units of cells, cell centres at whole numbers, dx and dy counted from the apex. In the row at dy
///
///     the rim admits    |dx - shear dy| <= sqrt(half_squared - narrowing dy^2),
///     the edges admit   low_offset[k] + low_slope[k] dy <= dx <= high_offset[k] + high_slope[k] dy,
///
/// where an edge that does not bound one side has the slope 0 there and an offset outside the rim.
struct SectorShape {
  double apex_j;
  double half_squared;
  double narrowing;
  double shear;
  double low_slope[2];
  double low_offset[2];
  double high_slope[2];
  double high_offset[2];
  double outside;          ///< no cell of the sector is as far from the apex, in columns
  std::int32_t i_below;    ///< a column left of all of them; columns are counted from it, so that truncation is floor
  std::int32_t i_above;    ///< a column right of all of them; counted down from it, truncation is ceil
  double apex_from_below;  ///< apex_i - i_below
  double apex_from_above;  ///< i_above - apex_i
};

struct SectorRowKernels {
  const char* instruction_set;
  /// The columns i_begin[k] <= i < i_end[k] of row j_first + k, for 0 <= k < count; i_end <= i_begin where there are
  /// none.
  void (*columns)(const SectorShape& shape, std::int32_t j_first, std::size_t count, std::int32_t* i_begin,
                  std::int32_t* i_end);
};

/// The kernels for this processor, chosen once. All of them give the same columns.
const SectorRowKernels& sector_row_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_sector_row_kernels(const SectorRowKernels** list, std::size_t room);

}  // namespace echoarc::kernels
