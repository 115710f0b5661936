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
constexpr std::int32_t lanes = 16;  // cells handled together; the ends of a run are masked, not peeled
constexpr std::int16_t ceiling = 32767;

/// Calls `block(cells, i, begin, end)` for every aligned block of `lanes` cells that a run meets: `cells` points to the
/// block, `i` is its first column, and the lanes begin <= l < end belong to the run.
template <class Block>
inline void for_each_block(const TileRow& row, const Run& run, Block&& block) {
  const std::int32_t row_offset = (run.j & (tile_size - 1)) * tile_size;
  for (std::int32_t i = run.i_begin & ~(lanes - 1); i < run.i_end; i += lanes) {
    std::int16_t* tile = row.tiles[(i >> tile_shift) - row.first_column];
    const std::int32_t begin = run.i_begin - i;
    const std::int32_t end = run.i_end - i;
    block(tile + row_offset + (i & (tile_size - 1)), i, static_cast<std::int16_t>(begin < 0 ? 0 : begin),
          static_cast<std::int16_t>(end > lanes ? lanes : end));
  }
}

/// Rounds to the nearest whole number, ties to even, for |x| < 2^22: adding 1.5 * 2^23 leaves the integer in the low
/// bits.
inline std::int32_t round_to_int(float x) {
  return __builtin_bit_cast(std::int32_t, x + 12582912.0F) - 0x4b400000;
}

inline std::int16_t saturated(std::int32_t sum) {
  sum = sum > ceiling ? ceiling : sum;
  return static_cast<std::int16_t>(sum < -ceiling ? -ceiling : sum);
}

template <int terms>
inline float evaluate(const float* c, float x) {
  float sum = c[terms - 1];
  for (int k = terms - 2; k >= 0; --k) sum = sum * x + c[k];
  return sum;
}

void add_constant(const TileRow& row, const Run* runs, std::size_t count, std::int16_t increment) {
  // Clamping before the sum keeps it within 16 bits: sixteen lanes to a 256-bit register.
  const std::int16_t high = increment > 0 ? static_cast<std::int16_t>(ceiling - increment) : ceiling;
  const std::int16_t low =
      increment < 0 ? static_cast<std::int16_t>(-ceiling - increment) : static_cast<std::int16_t>(-ceiling);
  for (std::size_t k = 0; k < count; ++k) {
    for_each_block(row, runs[k], [&](std::int16_t* cells, std::int32_t, std::int16_t begin, std::int16_t end) {
      for (std::int16_t l = 0; l < lanes; ++l) {
        std::int16_t value = cells[l];
        std::int16_t clamped = value > high ? high : value;
        clamped = clamped < low ? low : clamped;
        const auto sum = static_cast<std::int16_t>(clamped + increment);
        cells[l] = (l >= begin) & (l < end) ? sum : value;
      }
    });
  }
}

/// Adds `increment(dx, dy)` to the cells of the runs, dx and dy in metres from the apex.
template <class Increment>
inline void add_cells(const TileRow& row, const Run* runs, std::size_t count, const BeamFrame& beam,
                      Increment&& increment) {
  for (std::size_t k = 0; k < count; ++k) {
    const float dy = beam.offset_y_m + static_cast<float>(runs[k].j - beam.apex_j) * beam.cell_m;
    for_each_block(row, runs[k], [&](std::int16_t* cells, std::int32_t i, std::int32_t begin, std::int32_t end) {
      const std::int32_t first = i - beam.apex_i;
#pragma GCC unroll 1  // unrolled early, the loop would be out of reach of the vectoriser
      for (std::int32_t l = 0; l < lanes; ++l) {
        const float dx = beam.offset_x_m + static_cast<float>(first + l) * beam.cell_m;
        const std::int32_t change = round_to_int(increment(dx, dy));
        const std::int32_t inside = -static_cast<std::int32_t>((l >= begin) & (l < end));  // all bits, or none
        cells[l] = saturated(cells[l] + (change & inside));
      }
    });
  }
}

template <int terms>
void add_angular_terms(const TileRow& row, const Run* runs, std::size_t count, const BeamFrame& beam, const float* c) {
  float own[terms];
  for (int k = 0; k < terms; ++k) own[k] = c[k];
  add_cells(row, runs, count, beam, [&](float dx, float dy) {
    const float across = beam.axis_x * dy - beam.axis_y * dx;
    return evaluate<terms>(own, across * across / (dx * dx + dy * dy));  // of sin^2 theta
  });
}

void add_angular(const TileRow& row, const Run* runs, std::size_t count, const BeamFrame& beam,
                 const Polynomial& increment) {
  if (increment.terms <= 4)
    add_angular_terms<4>(row, runs, count, beam, increment.c);
  else if (increment.terms <= 6)
    add_angular_terms<6>(row, runs, count, beam, increment.c);
  else if (increment.terms <= 8)
    add_angular_terms<8>(row, runs, count, beam, increment.c);
  else
    add_angular_terms<max_terms>(row, runs, count, beam, increment.c);
}

void add_band(const TileRow& row, const Run* runs, std::size_t count, const BeamFrame& beam, const BandModel& band) {
  const BandModel own = band;
  add_cells(row, runs, count, beam, [&](float dx, float dy) {
    const float squared = dx * dx + dy * dy;
    const float across = beam.axis_x * dy - beam.axis_y * dx;
    const float error = __builtin_sqrtf(squared) - own.range_m;
    const float height = evaluate<max_terms>(own.angular.c, across * across / squared) *
                         evaluate<max_terms>(own.radial.c, error * error);
    return evaluate<max_terms>(own.logit.c, height);
  });
}

}  // namespace

extern const EvidenceKernels table;
const EvidenceKernels table{ECHOARC_TEXT(ECHOARC_ISA), add_constant, add_angular, add_band};

}  // namespace echoarc::kernels::ECHOARC_ISA
