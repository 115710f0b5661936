// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loops of `SectorRaster` and `ArcRaster`, compiled once per instruction set (cmake/EchoarcKernels.cmake).
// This header and the kernel sources include nothing that holds inline functions: two copies of one, compiled with
// different flags, must never meet in the linker.

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

/// Samples on an arc in units of cells, counted from a cell left of and below all of them, so that truncation is floor.
///
/// The bearing of sample k from the arc's centre is that of `first` turned k times by one step. Directions are turned
/// `arc_lanes` at a time: `lane_x`, `lane_y` hold the turns by 0 ... arc_lanes - 1 steps, `turn_x`, `turn_y` the turn
/// by arc_lanes steps. An ellipse's direction u is stretched to the radius A B / hypot(B u.f, A f x u).
inline constexpr std::size_t arc_lanes = 8;
struct ArcShape {
  double first_x;
  double first_y;
  double lane_x[arc_lanes];
  double lane_y[arc_lanes];
  double turn_x;
  double turn_y;
  double centre_x;  ///< counted from the cell at (i_base, j_base)
  double centre_y;
  double semi_major;  ///< A, in cells; the radius of a circle
  double semi_minor;  ///< B
  double focal_x;     ///< f, unit vector along the major axis
  double focal_y;
  std::int32_t i_base;
  std::int32_t j_base;
  bool circular;
};

/// One branch of an arc, rising or falling all the way, in units of cells: at the height dy above the centre it lies at
///
///     x = centre_x + shear dy + side sqrt(half_squared - narrowing dy^2),
///
/// counted from a column left of it, so that truncation is floor.
struct ArcRowShape {
  double centre_x;
  double first_dy;  ///< of the lower edge of the second row
  double shear;
  double half_squared;
  double narrowing;
  double side;          ///< 1 right, -1 left
  std::int32_t i_base;  ///< the column from which x is counted
  std::int32_t i_last;  ///< the rightmost column the whole curve enters, not counted from it
  std::int32_t i_low;   ///< columns of the lower and the upper end of the branch
  std::int32_t i_high;
};

struct RasterKernels {
  const char* instruction_set;
  /// The columns i_begin[k] <= i < i_end[k] of row j_first + k, for 0 <= k < count; i_end <= i_begin where there are
  /// none.
  void (*sector_rows)(const SectorShape& shape, std::int32_t j_first, std::size_t count, std::int32_t* i_begin,
                      std::int32_t* i_end);
  /// The cell (i, j) of every sample 0 <= k < count as one number in cells[k + 1], j in the upper 32 bits, and in bit
  /// k % 64 of changes[k / 64] whether it differs from the one before; bit 0 is set. `count` is a multiple of
  /// `arc_lanes`; there is room for count + 1 cells.
  void (*arc_samples)(const ArcShape& shape, std::size_t count, std::uint64_t* cells, std::uint64_t* changes);
  /// Where a branch crosses `count` rows: crossing[k] is the column in which it meets the lower edge of row k
  /// (crossing[0] and crossing[count]: its ends), and between two edges it runs through i_begin[k] <= i < i_end[k].
  /// There is room for count + 1 crossings and count columns, rounded up to a multiple of `arc_lanes`, plus one.
  void (*arc_rows)(const ArcRowShape& shape, std::size_t count, std::int32_t* crossing, std::int32_t* i_begin,
                   std::int32_t* i_end);
};

/// The kernels for this processor, chosen once. All of them give the same cells.
const RasterKernels& raster_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
std::size_t available_raster_kernels(const RasterKernels** list, std::size_t room);

}  // namespace echoarc::kernels
