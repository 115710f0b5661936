// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. A plain loop that compilers turn into vector
// code; every operation is exact or correctly rounded in all instruction sets, so that all give the same columns.

#include "maps/raster_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

inline double larger(double a, double b) {
  return a > b ? a : b;
}
inline double smaller(double a, double b) {
  return a < b ? a : b;
}

}  // namespace

void sector_rows(const SectorShape& shape, std::int32_t j_first, std::size_t count, std::int32_t* __restrict i_begin,
                 std::int32_t* __restrict i_end) {
  const SectorShape s = shape;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(count); ++k) {
    const double dy = static_cast<double>(j_first + k) - s.apex_j;
    const double squared = s.half_squared - dy * dy * s.narrowing;
    const double half = __builtin_sqrt(larger(squared, 0.0));
    const double middle = s.shear * dy;
    double low = larger(s.low_offset[0] + s.low_slope[0] * dy, s.low_offset[1] + s.low_slope[1] * dy);
    double high = smaller(s.high_offset[0] + s.high_slope[0] * dy, s.high_offset[1] + s.high_slope[1] * dy);
    low = smaller(larger(low, middle - half), s.outside);  // an almost level edge crosses the row miles away
    high = larger(smaller(high, middle + half), -s.outside);
    high = squared < 0.0 ? -s.outside : high;
    i_begin[k] = s.i_above - static_cast<std::int32_t>(s.apex_from_above - low);
    i_end[k] = s.i_below + static_cast<std::int32_t>(s.apex_from_below + high) + 1;
  }
}

}  // namespace echoarc::kernels::ECHOARC_ISA
