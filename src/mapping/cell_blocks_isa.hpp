// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// Blocks of 16 cells, for kernels that are compiled once per instruction set with ECHOARC_ISA set to its name. Only
// what compilers do not find by themselves is written for an instruction set; beside it stands the portable form, which
// gives the same bytes.

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "mapping/evidence_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

constexpr std::int32_t tile_shift = 6;
constexpr std::int32_t tile_size = 1 << tile_shift;
constexpr std::int32_t block_size = 16;

/// 16 cells, or changes of cells.
using Block = std::int16_t __attribute__((vector_size(32)));
/// Half a block in single precision.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));

template <class Vector, class T>
inline Vector load(const T* from) {
  Vector vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}
template <class Vector, class T>
inline void store(const Vector& vector, T* to) {
  __builtin_memcpy(to, &vector, sizeof vector);
}

inline Block repeated(std::int16_t value) {
  return Block{} + value;
}
inline Floats repeated(float value) {
  return value - Floats{};
}

#ifdef __AVX2__

/// a + b, kept within 16 bits.
inline Block saturating_sum(const Block& a, const Block& b) {
  return reinterpret_cast<Block>(_mm256_adds_epi16(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
}
/// a b 2^-15, rounded to the nearest whole number, halves upwards: the product of numbers with 15 binary places.
inline Block fixed_product(const Block& a, const Block& b) {
  return reinterpret_cast<Block>(_mm256_mulhrs_epi16(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
}
/// Both halves rounded to the nearest whole numbers, ties to even; meant for |x| < 2^15.
inline Block rounded(const Floats& low, const Floats& high) {
  const __m256i packed = _mm256_packs_epi32(_mm256_cvtps_epi32(low), _mm256_cvtps_epi32(high));
  constexpr int in_order = 0b11'01'10'00;  // packing works within 128 bits
  return reinterpret_cast<Block>(_mm256_permute4x64_epi64(packed, in_order));
}
inline Floats square_root(const Floats& x) {
  return _mm256_sqrt_ps(x);
}

#else

inline Block saturating_sum(const Block& a, const Block& b) {
  const Block sum = a + b;
  const Block left = (a ^ sum) & (b ^ sum);  // negative where the sum has left 16 bits
  return left < 0 ? (a < 0 ? repeated(std::int16_t{-32768}) : repeated(std::int16_t{32767})) : sum;
}
inline Block fixed_product(const Block& a, const Block& b) {
  using Wide = std::int32_t __attribute__((vector_size(64)));
  const Wide product = __builtin_convertvector(a, Wide) * __builtin_convertvector(b, Wide);
  return __builtin_convertvector((product + (1 << 14)) >> 15, Block);
}
inline Block rounded(const Floats& low, const Floats& high) {
  // Adding 1.5 * 2^23 leaves the nearest whole number in the low 16 bits.
  using Words = std::int16_t __attribute__((vector_size(64)));
  struct Halves {
    Floats low, high;
  };
  const auto words = __builtin_bit_cast(Words, Halves{low + 12582912.0F, high + 12582912.0F});
  return __builtin_shufflevector(words, words, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
}
inline Floats square_root(const Floats& x) {
  Floats root;
  for (int l = 0; l < 8; ++l) root[l] = __builtin_sqrtf(x[l]);
  return root;
}

#endif

/// As many zeros as a tile's row has cells, then as many -1 (all bits), then as many zeros: from 64 - k on, the cells
/// l >= k of a row; from 128 - k on, the cells l < k.
struct Steps {
  alignas(32) std::int16_t values[3 * tile_size]{};

  constexpr Steps() {
    for (std::int32_t k = tile_size; k < 2 * tile_size; ++k) values[k] = -1;
  }
};
constexpr Steps steps;

/// The cells begin <= l < end of a tile's row as bit masks, read from memory instead of compared for.
class Inside {
 public:
  Inside(std::int32_t begin, std::int32_t end)
      : from_begin_(steps.values + tile_size - begin), before_end_(steps.values + tile_size + (tile_size - end)) {}
  /// Of the cells l ... l + 15.
  [[nodiscard]] Block block(std::int32_t l) const {
    return load<Block>(before_end_ + l) & load<Block>(from_begin_ + l);
  }

 private:
  const std::int16_t* from_begin_;
  const std::int16_t* before_end_;
};

/// Calls `segment(cells, i, j, begin, end)` for every tile that a run meets: `cells` points to the tile's part of the
/// row j, `i` is its first column, and the cells begin <= l < end of it belong to the run.
template <class Segment>
inline void for_each_segment(const TileRow& row, const Runs& runs, Segment&& segment) {
  for (std::int32_t k = 0; k < runs.count; ++k) {
    if (runs.begin[k] >= runs.end[k]) continue;
    const std::int32_t j = runs.j_first + k;
    const std::int32_t row_offset = (j & (tile_size - 1)) * tile_size;
    std::int32_t i = runs.begin[k] & ~(tile_size - 1);
    std::int16_t* const* tile = row.tiles + ((i >> tile_shift) - row.first_column);
    std::int32_t begin = runs.begin[k] - i;
    for (; runs.end[k] - i > tile_size; i += tile_size, begin = 0)
      segment(*tile++ + row_offset, i, j, begin, tile_size);
    segment(*tile + row_offset, i, j, begin, runs.end[k] - i);
  }
}

/// Adds `change(l)`, the changes of the cells l ... l + 15, to the cells begin <= l < end of a tile's row. Blocks start
/// where the run does, or so far before that none reaches beyond the tile: a run has no more blocks than it needs.
template <class Change>
inline void add_blocks(std::int16_t* cells, std::int32_t begin, std::int32_t end, Change&& change) {
  const Inside inside(begin, end);
  const std::int32_t length = (end - begin + block_size - 1) & ~(block_size - 1);
  for (std::int32_t l = begin < tile_size - length ? begin : tile_size - length; l < end; l += block_size)
    store(saturating_sum(load<Block>(cells + l), change(l) & inside.block(l)), cells + l);
}

}  // namespace
}  // namespace echoarc::kernels::ECHOARC_ISA
