// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Plain loops that compilers turn into vector code;
// every operation is exact or correctly rounded in all instruction sets, so that all give the same cells.

#include "maps/raster_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

template <bool circular>
void sample(const ArcShape& shape, std::size_t count, std::uint64_t* __restrict cells) {
  const ArcShape s = shape;
  double base_x = s.first_x;
  double base_y = s.first_y;
  for (std::size_t k = 0; k < count; k += arc_lanes) {
#pragma GCC unroll 1  // unrolled early, the loop would be out of reach of the vectoriser
    for (std::size_t l = 0; l < arc_lanes; ++l) {
      const double x = base_x * s.lane_x[l] - base_y * s.lane_y[l];
      const double y = base_x * s.lane_y[l] + base_y * s.lane_x[l];
      double radius = s.semi_major;  // NOLINT(misc-const-correctness): changed for an ellipse
      if constexpr (!circular) {
        const double along = s.semi_minor * (x * s.focal_x + y * s.focal_y);
        const double across = s.semi_major * (s.focal_x * y - s.focal_y * x);
        radius = s.semi_major * s.semi_minor / __builtin_sqrt(along * along + across * across);
      }
      const auto i = static_cast<std::uint32_t>(s.i_base + static_cast<std::int32_t>(s.centre_x + radius * x));
      const auto j = static_cast<std::uint32_t>(s.j_base + static_cast<std::int32_t>(s.centre_y + radius * y));
      cells[k + l] = static_cast<std::uint64_t>(j) << 32 | i;
    }
    const double turned_x = base_x * s.turn_x - base_y * s.turn_y;
    base_y = base_x * s.turn_y + base_y * s.turn_x;
    base_x = turned_x;
  }
}

/// Bit k % 64 of word k / 64 tells whether cells[k + 1] differs from cells[k].
void mark_changes(const std::uint64_t* __restrict cells, std::size_t count, std::uint64_t* __restrict changes) {
  for (std::size_t k = 0; k < count; k += arc_lanes) {
    std::uint64_t bits = 0;
#pragma GCC unroll 1
    for (std::uint64_t l = 0; l < arc_lanes; ++l)
      bits |= (cells[k + l + 1] != cells[k + l] ? std::uint64_t{1} : std::uint64_t{0}) << l;
    std::uint64_t& word = changes[k / 64];
    word = (k % 64 == 0 ? 0 : word) | bits << (k % 64);
  }
}

}  // namespace

void arc_samples(const ArcShape& shape, std::size_t count, std::uint64_t* __restrict cells,
                 std::uint64_t* __restrict changes) {
  if (shape.circular)
    sample<true>(shape, count, cells + 1);
  else
    sample<false>(shape, count, cells + 1);
  cells[0] = ~cells[1];
  mark_changes(cells, count, changes);
}

}  // namespace echoarc::kernels::ECHOARC_ISA
