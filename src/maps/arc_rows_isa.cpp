// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Plain loops that compilers turn into vector code;
// every operation is exact or correctly rounded in all instruction sets, so that all give the same cells.

#include "maps/raster_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

/// The columns at the lower edges of rows 1 ... count.
void cross_rows(const ArcRowShape& shape, std::size_t count, std::int32_t* __restrict columns) {
  const ArcRowShape s = shape;
  for (std::size_t k = 0; k < count; k += arc_lanes) {
    const auto first = static_cast<std::int32_t>(k);
#pragma GCC unroll 1  // unrolled early, the loop would be out of reach of the vectoriser
    for (std::int32_t l = 0; l < static_cast<std::int32_t>(arc_lanes); ++l) {
      const double dy = s.first_dy + (first + l);
      const double squared = s.half_squared - s.narrowing * dy * dy;
      const double half = __builtin_sqrt(squared > 0.0 ? squared : 0.0);
      const std::int32_t i = s.i_base + static_cast<std::int32_t>(s.centre_x + s.shear * dy + s.side * half);
      columns[k + static_cast<std::size_t>(l)] = i < s.i_last ? i : s.i_last;
    }
  }
}

void span_rows(const std::int32_t* __restrict crossing, std::size_t count, std::int32_t* __restrict i_begin,
               std::int32_t* __restrict i_end) {
  for (std::size_t k = 0; k < count; k += arc_lanes) {
#pragma GCC unroll 1
    for (std::size_t l = 0; l < arc_lanes; ++l) {
      const std::int32_t below = crossing[k + l];
      const std::int32_t above = crossing[k + l + 1];
      i_begin[k + l] = below < above ? below : above;
      i_end[k + l] = (below < above ? above : below) + 1;
    }
  }
}

}  // namespace

void arc_rows(const ArcRowShape& shape, std::size_t count, std::int32_t* crossing, std::int32_t* i_begin,
              std::int32_t* i_end) {
  cross_rows(shape, count, crossing + 1);
  crossing[0] = shape.i_low;
  crossing[count] = shape.i_high;
  span_rows(crossing, count, i_begin, i_end);
}

}  // namespace echoarc::kernels::ECHOARC_ISA
