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

/// Columns of a circle's first and last cell in a row, of half its chord.
inline std::int32_t first_column(const SplitShape& s, double half) {
  return s.i_above - static_cast<std::int32_t>(s.apex_from_above + half);
}
inline std::int32_t column_after(const SplitShape& s, double half) {
  return s.i_below + static_cast<std::int32_t>(s.apex_from_below + half) + 1;
}

/// The compiler trusts that arrays do not overlap when they are parameters; as locals it would check every pair.
void split_free(const SplitShape s, std::int32_t j_first, std::int32_t count, const std::int32_t* __restrict begin,
                const std::int32_t* __restrict end, std::int32_t* __restrict begin_out,
                std::int32_t* __restrict free_begin, std::int32_t* __restrict near_begin,
                std::int32_t* __restrict near_end, std::int32_t* __restrict free_end,
                std::int32_t* __restrict end_out) {
  for (std::int32_t k = 0; k < count; ++k) {
    const double half = half_chord(s.free_squared, static_cast<double>(j_first + k) - s.apex_j, s.outside);
    const std::int32_t last = end[k] > begin[k] ? end[k] : begin[k];
    const std::int32_t from = clamped(first_column(s, half), begin[k], last);
    const std::int32_t to = clamped(column_after(s, half), from, last);
    begin_out[k] = begin[k];
    free_begin[k] = from;
    near_begin[k] = to;
    near_end[k] = to;
    free_end[k] = to;
    end_out[k] = last;
  }
}

void split_near(const SplitShape s, std::int32_t j_first, std::int32_t count, const std::int32_t* __restrict free_begin,
                const std::int32_t* __restrict free_end, std::int32_t* __restrict near_begin,
                std::int32_t* __restrict near_end) {
  for (std::int32_t k = 0; k < count; ++k) {
    const double half = half_chord(s.near_squared, static_cast<double>(j_first + k) - s.apex_j, s.outside);
    near_begin[k] = clamped(first_column(s, half), free_begin[k], free_end[k]);
    near_end[k] = clamped(column_after(s, half), near_begin[k], free_end[k]);
  }
}

}  // namespace

void split_rows(const SplitShape& shape, const Runs& sector, const RowEdges& edges) {
  split_free(shape, sector.j_first, sector.count, sector.begin, sector.end, edges.begin, edges.free_begin,
             edges.near_begin, edges.near_end, edges.free_end, edges.end);
  if (shape.near_squared <= 0.0) return;
  // Few rows meet the near circle; those that are looked at for nothing stay as they are.
  const double near = smaller(__builtin_sqrt(shape.near_squared), shape.outside);
  const double apex_row = shape.apex_j - sector.j_first;
  const std::int32_t first = clamped(static_cast<std::int32_t>(apex_row - near) - 1, 0, sector.count);
  const std::int32_t end = clamped(static_cast<std::int32_t>(apex_row + near) + 2, first, sector.count);
  split_near(shape, sector.j_first + first, end - first, edges.free_begin + first, edges.free_end + first,
             edges.near_begin + first, edges.near_end + first);
}

void bounds(const Runs& runs, std::int32_t* begin, std::int32_t* end) {
  std::int32_t least = 2147483647;
  std::int32_t greatest = -2147483647 - 1;
  for (std::int32_t k = 0; k < runs.count; ++k) {
    const bool empty = runs.end[k] <= runs.begin[k];
    const std::int32_t low = empty ? least : runs.begin[k];
    const std::int32_t high = empty ? greatest : runs.end[k];
    least = low < least ? low : least;
    greatest = high > greatest ? high : greatest;
  }
  *begin = least;
  *end = greatest;
}

}  // namespace echoarc::kernels::ECHOARC_ISA
