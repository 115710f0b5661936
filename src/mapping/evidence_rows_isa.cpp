// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Plain loops that compilers turn into vector code;
// every operation is exact or correctly rounded in all instruction sets, so that all give the same columns.

#include "mapping/evidence_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

inline double smaller(double a, double b) {
  return a < b ? a : b;
}
inline std::int32_t clamped(std::int32_t x, std::int32_t low, std::int32_t high) {
  x = x < high ? x : high;
  return x > low ? x : low;
}

/// Half the chord that a row cuts from a circle. Rows that miss it get a chord so negative that it begins right of
/// everything.
inline double half_chord(double radius_squared, double dy, double outside) {
  const double squared = radius_squared - dy * dy;
  const double half = smaller(__builtin_sqrt(squared > 0.0 ? squared : 0.0), outside);
  return squared > 0.0 ? half : -outside;
}

/// The compiler trusts that arrays do not overlap when they are parameters; as locals it would check every pair.
void split_columns(const SplitShape s, std::int32_t j_first, std::int32_t count, const std::int32_t* __restrict begin,
                   const std::int32_t* __restrict end, std::int32_t* __restrict begin_out,
                   std::int32_t* __restrict free_begin, std::int32_t* __restrict near_begin,
                   std::int32_t* __restrict near_end, std::int32_t* __restrict free_end,
                   std::int32_t* __restrict end_out) {
  const auto first_from = [s](double half) { return s.i_above - static_cast<std::int32_t>(s.apex_from_above + half); };
  const auto first_after = [s](double half) {
    return s.i_below + static_cast<std::int32_t>(s.apex_from_below + half) + 1;
  };
  for (std::int32_t k = 0; k < count; ++k) {
    const double dy = static_cast<double>(j_first + k) - s.apex_j;
    const double free_half = half_chord(s.free_squared, dy, s.outside);
    const double near_half = half_chord(s.near_squared, dy, s.outside);
    const std::int32_t last = end[k] > begin[k] ? end[k] : begin[k];
    const std::int32_t from = clamped(first_from(free_half), begin[k], last);
    const std::int32_t to = clamped(first_after(free_half), from, last);
    const std::int32_t near_from = clamped(first_from(near_half), from, to);
    begin_out[k] = begin[k];
    free_begin[k] = from;
    near_begin[k] = near_from;
    near_end[k] = clamped(first_after(near_half), near_from, to);
    free_end[k] = to;
    end_out[k] = last;
  }
}

}  // namespace

void split_rows(const SplitShape& shape, const Runs& sector, const RowEdges& edges) {
  split_columns(shape, sector.j_first, sector.count, sector.begin, sector.end, edges.begin, edges.free_begin,
                edges.near_begin, edges.near_end, edges.free_end, edges.end);
}

}  // namespace echoarc::kernels::ECHOARC_ISA
