// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name. Plain loops that compilers turn into vector code;
// every operation is exact or correctly rounded in all instruction sets, so that all give the same bytes.

#include "mapping/evidence_kernels.hpp"

#define ECHOARC_TEXT_OF(x) #x
#define ECHOARC_TEXT(x) ECHOARC_TEXT_OF(x)

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

constexpr std::int32_t tile_shift = 6;
constexpr std::int32_t tile_size = 1 << tile_shift;
constexpr std::int32_t highest = 32767;
constexpr std::int32_t lowest = -32768;

/// Calls `segment(cells, i, begin, end)` for every tile that a run meets: `cells` points to the tile's part of the row,
/// `i` is its first column, and the cells begin <= l < end of it belong to the run.
template <class Segment>
inline void for_each_segment(const TileRow& row, const Runs& runs, std::size_t k, Segment&& segment) {
  const std::int32_t run_begin = runs.begin[k];
  const std::int32_t run_end = runs.end[k];
  if (run_end <= run_begin) return;
  const std::int32_t row_offset = (runs.j[k] & (tile_size - 1)) * tile_size;
  for (std::int32_t i = run_begin & ~(tile_size - 1); i < run_end; i += tile_size) {
    std::int16_t* tile = row.tiles[(i >> tile_shift) - row.first_column];
    segment(tile + row_offset, i, run_begin > i ? run_begin - i : 0, run_end - i < tile_size ? run_end - i : tile_size);
  }
}

/// Rounds to the nearest whole number, ties to even, for |x| < 2^15: adding 1.5 * 2^23 leaves the integer in the low 16
/// bits.
inline std::uint32_t rounded_bits(float x) {
  return __builtin_bit_cast(std::uint32_t, x + 12582912.0F);
}

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
void split_columns(const SplitShape s, std::int32_t count, const std::int32_t* __restrict j,
                   const std::int32_t* __restrict begin, const std::int32_t* __restrict end,
                   std::int32_t* __restrict free_begin, std::int32_t* __restrict near_begin,
                   std::int32_t* __restrict near_end, std::int32_t* __restrict free_end) {
  const auto first_from = [s](double half) { return s.i_above - static_cast<std::int32_t>(s.apex_from_above + half); };
  const auto first_after = [s](double half) {
    return s.i_below + static_cast<std::int32_t>(s.apex_from_below + half) + 1;
  };
  for (std::int32_t k = 0; k < count; ++k) {
    const double dy = static_cast<double>(j[k]) - s.apex_j;
    const double free_half = half_chord(s.free_squared, dy, s.outside);
    const double near_half = half_chord(s.near_squared, dy, s.outside);
    const std::int32_t from = clamped(first_from(free_half), begin[k], end[k]);
    const std::int32_t to = clamped(first_after(free_half), from, end[k]);
    const std::int32_t near_from = clamped(first_from(near_half), from, to);
    free_begin[k] = from;
    near_begin[k] = near_from;
    near_end[k] = clamped(first_after(near_half), near_from, to);
    free_end[k] = to;
  }
}

void split_rows(const SplitShape& shape, const Runs& sector, const RowEdges& edges) {
  split_columns(shape, static_cast<std::int32_t>(sector.count), sector.j, sector.begin, sector.end, edges.free_begin,
                edges.near_begin, edges.near_end, edges.free_end);
}

/// A polynomial with every coefficient repeated for each lane. Loaded like any other array, the coefficients need
/// neither registers across the loops nor broadcasts inside them.
template <int terms, int lanes>
struct SpreadPolynomial {
  alignas(32) float c[terms][lanes];

  explicit SpreadPolynomial(const Polynomial& polynomial) {
    for (int k = 0; k < terms; ++k)
      for (int l = 0; l < lanes; ++l) c[k][l] = polynomial.c[k];
  }
  /// Halves at a time (Estrin's scheme): the chain of dependent operations is a third of Horner's.
  [[nodiscard]] float at(float x, std::int32_t l) const {
    const float x2 = x * x;
    return part<0, terms>(x, x2, x2 * x2, l);
  }

 private:
  template <int first, int count>
  [[nodiscard]] float part(float x, float x2, float x4, std::int32_t l) const {
    if constexpr (count == 1)
      return c[first][l];
    else if constexpr (count == 2)
      return c[first][l] + c[first + 1][l] * x;
    else if constexpr (count <= 4)
      return part<first, 2>(x, x2, x4, l) + part<first + 2, count - 2>(x, x2, x4, l) * x2;
    else if constexpr (count <= 8)
      return part<first, 4>(x, x2, x4, l) + part<first + 4, count - 4>(x, x2, x4, l) * x4;
    else
      return part<first, 8>(x, x2, x4, l) + part<first + 8, count - 8>(x, x2, x4, l) * (x4 * x4);
  }
};

/// Which way a kernel can move a cell: saturation then needs looking at on one side only, and fits into 16 bits.
enum class Sign { falling, rising };

/// value + change, kept within 16 bits without leaving them: a sum that wrapped lies on the wrong side of the value.
template <Sign sign>
inline std::int16_t saturating_sum(std::int16_t value, std::int16_t change) {
  const auto sum = static_cast<std::int16_t>(value + change);
  if constexpr (sign == Sign::falling)
    return sum > value ? static_cast<std::int16_t>(lowest) : sum;
  else
    return sum < value ? static_cast<std::int16_t>(highest) : sum;
}

/// As many zeros as a tile's row has cells, then as many -1 (all bits): from 64 - k on, the cells l >= k of a row.
struct Steps {
  alignas(32) std::int16_t values[2 * tile_size];

  constexpr Steps() : values{} {
    for (std::int32_t k = tile_size; k < 2 * tile_size; ++k) values[k] = -1;
  }
};
constexpr Steps steps;

/// The cells begin <= l < end of a tile's row as bit masks, read from memory instead of compared for.
struct Inside {
  const std::int16_t* from_begin;
  const std::int16_t* from_end;

  Inside(std::int32_t begin, std::int32_t end)
      : from_begin(steps.values + tile_size - begin), from_end(steps.values + tile_size - end) {}
  [[nodiscard]] std::int16_t keep(std::int16_t change, std::int32_t l) const {
    return static_cast<std::int16_t>(change & from_begin[l] & ~from_end[l]);
  }
};

template <Sign sign>
void add_constant_signed(const TileRow& row, const Runs& runs, std::int16_t increment) {
  // A segment is handled as the whole row of its tile: four vectors of 16 cells, and no branch to mispredict.
  for (std::size_t k = 0; k < runs.count; ++k) {
    for_each_segment(row, runs, k, [&](std::int16_t* cells, std::int32_t, std::int32_t begin, std::int32_t end) {
      const Inside inside(begin, end);
      for (std::int32_t l = 0; l < tile_size; ++l) cells[l] = saturating_sum<sign>(cells[l], inside.keep(increment, l));
    });
  }
}

void add_constant(const TileRow& row, const Runs& runs, std::int16_t increment) {
  if (increment < 0)
    add_constant_signed<Sign::falling>(row, runs, increment);
  else
    add_constant_signed<Sign::rising>(row, runs, increment);
}

/// 0, 1, 2, ... as the columns of a tile's row.
struct Count {
  alignas(32) float values[tile_size];

  constexpr Count() : values{} {
    for (std::int32_t l = 0; l < tile_size; ++l) values[l] = static_cast<float>(l);
  }
};
constexpr Count column;

/// Adds `increment(squared, across, lane)` to the cells of the runs, of the squared distance from the apex and the
/// distance from the beam's axis, both in cells, `lanes` cells at a time; the ends of a run are masked, not peeled.
///
/// In cells, the distances of columns and rows from the apex are one offset and a whole number each: exact until they
/// meet. So a cell's change does not depend on where in its tile it lies, and turning the grid by 90 degrees gives the
/// same bits.
template <int lanes, Sign sign, class Increment>
inline void add_cells(const TileRow& row, const Runs& runs, const BeamFrame& frame, Increment&& increment) {
  const BeamFrame beam = frame;
  const float offset_x = beam.offset_x_m / beam.cell_m;
  const float offset_y = beam.offset_y_m / beam.cell_m;
  for (std::size_t k = 0; k < runs.count; ++k) {
    const float dy = offset_y + static_cast<float>(runs.j[k] - beam.apex_j);
    const float dy_squared = dy * dy;
    const float row_across = beam.axis_x * dy;
    for_each_segment(row, runs, k, [&](std::int16_t* cells, std::int32_t i, std::int32_t begin, std::int32_t end) {
      const auto first_column = static_cast<float>(i - beam.apex_i);
      const Inside inside(begin, end);
      for (std::int32_t block = begin & ~(lanes - 1); block < end; block += lanes) {
        // Two loops, so that each is vectorised at the full width of its type. Unrolled early, they would be out of
        // reach of the vectoriser.
        std::uint32_t change[lanes];
#pragma GCC unroll 1
        for (std::int32_t l = 0; l < lanes; ++l) {
          const float dx = offset_x + (first_column + column.values[block + l]);
          const float across = row_across - beam.axis_y * dx;
          change[l] = rounded_bits(increment(dx * dx + dy_squared, across, l));
        }
#pragma GCC unroll 1
#pragma GCC ivdep  // the masks are no cells
        for (std::int32_t l = 0; l < lanes; ++l) {
          const auto rounded = static_cast<std::int16_t>(change[l]);
          cells[block + l] = saturating_sum<sign>(cells[block + l], inside.keep(rounded, block + l));
        }
      }
    });
  }
}

template <int terms>
void add_angular_terms(const TileRow& row, const Runs& runs, const BeamFrame& beam, const Polynomial& increment) {
  constexpr int lanes = 16;
  const SpreadPolynomial<terms, lanes> angular(increment);
  const float bend = increment.bend;
  add_cells<lanes, Sign::falling>(row, runs, beam, [&](float squared, float across, std::int32_t l) {
    const float across_squared = across * across;
    return angular.at(across_squared / (squared + bend * across_squared), l);
  });
}

void add_angular(const TileRow& row, const Runs& runs, const BeamFrame& beam, const Polynomial& increment) {
  if (increment.terms <= 5)  // the default beam
    add_angular_terms<5>(row, runs, beam, increment);
  else if (increment.terms <= 8)
    add_angular_terms<8>(row, runs, beam, increment);
  else
    add_angular_terms<max_terms>(row, runs, beam, increment);
}

template <int angular_terms, int radial_terms, int logit_terms>
void add_band_terms(const TileRow& row, const Runs& runs, const BeamFrame& beam, const BandModel& band) {
  constexpr int lanes = 8;  // the band is a few cells deep
  const SpreadPolynomial<angular_terms, lanes> angular(band.angular);
  const SpreadPolynomial<radial_terms, lanes> radial(band.radial);
  const SpreadPolynomial<logit_terms, lanes> logit(band.logit);
  const float range_m = band.range_m;
  const float cell_m = beam.cell_m;
  const float bend = band.angular.bend;
  add_cells<lanes, Sign::rising>(row, runs, beam, [&](float squared, float across, std::int32_t l) {
    const float error = __builtin_sqrtf(squared) * cell_m - range_m;
    const float across_squared = across * across;
    const float height =
        angular.at(across_squared / (squared + bend * across_squared), l) * radial.at(error * error, l);
    return height * logit.at(height * height, l);
  });
}

void add_band(const TileRow& row, const Runs& runs, const BeamFrame& beam, const BandModel& band) {
  const bool usual = band.radial.terms <= 7 && band.logit.terms <= 5;  // up to the default certainty
  if (usual && band.angular.terms == 1)
    add_band_terms<1, 7, 5>(row, runs, beam, band);
  else if (usual && band.angular.terms <= 6)
    add_band_terms<6, 7, 5>(row, runs, beam, band);
  else
    add_band_terms<max_terms, max_terms, max_terms>(row, runs, beam, band);
}

}  // namespace

extern const EvidenceKernels table;
const EvidenceKernels table{ECHOARC_TEXT(ECHOARC_ISA), split_rows, add_constant, add_angular, add_band};

}  // namespace echoarc::kernels::ECHOARC_ISA
