// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Compiled once per instruction set with ECHOARC_ISA set to its name.

#include "mapping/consensus/posterior_kernels.hpp"

namespace echoarc::kernels::ECHOARC_ISA {
namespace {

using Lanes = float __attribute__((vector_size(4 * bin_block)));
using Whole = std::int32_t __attribute__((vector_size(4 * bin_block)));

inline Lanes load(const float* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store(float* to, Lanes lanes) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}
inline Lanes lanes_of(Whole bits) {
  Lanes lanes;
  __builtin_memcpy(&lanes, &bits, sizeof lanes);
  return lanes;
}
inline Whole bits_of(Lanes lanes) {
  Whole bits;
  __builtin_memcpy(&bits, &lanes, sizeof bits);
  return bits;
}
inline Lanes all(float value) {
  return Lanes{} + value;
}
/// To the nearest whole number, for |x| < 2^22.
inline Lanes rounded(Lanes x) {
  constexpr float magic = 12582912.0F;  // 1.5 * 2^23: no digits behind the point are left
  return (x + magic) - magic;
}

/// exp(x) for x <= 88, 0 below -87; relative error 2e-7 (polynomial of Cephes' exp2f).
inline Lanes exponential(Lanes x) {
  Lanes y = x * 1.44269504F;
  y = y < -126.0F ? all(-126.0F) : y;
  const Lanes n = rounded(y);
  const Lanes f = y - n;
  Lanes p = f * 1.535336188e-4F + 1.339887440e-3F;
  p = p * f + 9.618437358e-3F;
  p = p * f + 5.550332471e-2F;
  p = p * f + 2.402264791e-1F;
  p = p * f + 6.931472029e-1F;
  p = p * f + 1.0F;
  const Whole exponent = (__builtin_convertvector(n, Whole) + 127) << 23;
  return p * lanes_of(exponent);
}

/// ln(x) for normal x > 0; absolute error 1e-7 near 1 (polynomial of Cephes' logf).
inline Lanes logarithm(Lanes x) {
  const Whole bits = bits_of(x);
  Lanes e = __builtin_convertvector((bits >> 23) - 126, Lanes);
  Lanes m = lanes_of((bits & 0x007fffff) | 0x3f000000);
  const auto low = m < 0.707106781F;
  e = low ? e - 1.0F : e;
  m = low ? m + m - 1.0F : m - 1.0F;
  const Lanes z = m * m;
  Lanes p = m * 7.0376836292e-2F - 1.1514610310e-1F;
  p = p * m + 1.1676998740e-1F;
  p = p * m - 1.2420140846e-1F;
  p = p * m + 1.4249322787e-1F;
  p = p * m - 1.6668057665e-1F;
  p = p * m + 2.0000714765e-1F;
  p = p * m - 2.4999993993e-1F;
  p = p * m + 3.3333331174e-1F;
  return p * m * z - 0.5F * z + m + 0.693147181F * e;
}

/// Whether a comparison holds in any lane.
inline bool any(Whole mask) {
#ifdef __AVX__
  return __builtin_ia32_movmskps256(lanes_of(mask)) != 0;
#else
  std::int64_t each[bin_block / 2];
  __builtin_memcpy(each, &mask, sizeof each);
  return (each[0] | each[1] | each[2] | each[3]) != 0;
#endif
}

inline Lanes root(Lanes x) {
  float each[bin_block];
  store(each, x);
  for (float& one : each) one = __builtin_sqrtf(one);
  return load(each);
}

inline Lanes looked_up(const float* table, Whole index) {
  std::int32_t each[bin_block];
  __builtin_memcpy(each, &index, sizeof each);
  float found[bin_block];
  for (int l = 0; l < bin_block; ++l) found[l] = table[each[l]];
  return load(found);
}

/// Twice atan(w), for a small enough |w|; error 2e-7 for |w| < 0.42, larger |w| give more than that of 0.42.
inline Lanes twice_arctangent(Lanes w) {
  const Lanes z = w * w;
  Lanes p = z * 8.05374449538e-2F - 1.38776856032e-1F;
  p = p * z + 1.99777106478e-1F;
  p = p * z - 3.33329491539e-1F;
  return 2.0F * (p * z * w + w);
}

/// Products over few enough neighbours not to overflow, then sums of their logarithms.
struct Tallied {
  Lanes support = all(1.0F);
  Lanes free = all(1.0F);
  Lanes support_sum{};
  Lanes free_sum{};

  void fold() {
    support_sum += logarithm(support);
    free_sum += logarithm(free);
    support = all(1.0F);
    free = all(1.0F);
  }
};

constexpr std::int32_t fold_every = 8;
constexpr float tie = 1e-4F;  // of a bin: bins half-way between two others go up, whatever the last digits

/// One block of bins of the arc in question.
struct Block {
  std::int32_t first;
  Lanes t, cos_t, sin_t;
};

/// Whether a wall tangent to the arc at t is tangent to the other arc, too, and whether the other looked through it.
inline void add_wall(const PosteriorTerms& terms, const CirclePair& pair, const Block& bins, Tallied& tally) {
  const Lanes e = pair.shorter_m - (pair.x_m * bins.cos_t + pair.y_m * bins.sin_t);
  const Lanes s = pair.y_m * bins.cos_t - pair.x_m * bins.sin_t;
  const Lanes a = bins.t + pair.turn_rad;
  const Lanes along = s * s * terms.over_two_length;
  const Lanes apart = -along - e * e * terms.over_two_range;
  if (any(apart > terms.no_support)) {
    const Lanes weight = load(pair.wall_weight + bins.first + pair.shift);
    tally.support *= 1.0F + weight * exponential(apart);
  }
  const auto through = (e < -terms.free_margin_m) & (a <= terms.facing_rad) & (a >= -terms.facing_rad);
  if (!any(through)) return;
  const Lanes miss = terms.facing * exponential(-2.0F * along - a * a * pair.over_two_variance);
  tally.free *= 1.0F - (through ? miss : Lanes{});
}

/// Whether the point at t lies on the other arc, and whether the other looked through it.
inline void add_point(const PosteriorTerms& terms, const CirclePair& pair, const Block& bins, Tallied& tally) {
  const Lanes x = terms.range_m * bins.cos_t - pair.x_m;
  const Lanes y = terms.range_m * bins.sin_t - pair.y_m;
  const Lanes d = root(x * x + y * y);
  const Lanes e = d - pair.range_m;
  const Lanes apart = -e * e * terms.over_two_range;
  const bool near = any(apart > terms.no_support);
  if (!near && !any(e < -terms.free_margin_m)) return;
  const Lanes ahead = x * pair.cos_turn - y * pair.sin_turn;
  const Lanes aside = x * pair.sin_turn + y * pair.cos_turn;
  const Lanes w = aside / (d + ahead + 1e-9F);
  const auto seen = (w < 0.5F) & (w > -0.5F);  // within 53 degrees of the other's axis
  const Lanes a = seen ? twice_arctangent(w) : all(3.0F);
  if (near) {
    Lanes k = rounded(a * terms.over_step + tie) + static_cast<float>(pair.half);
    k = k < -1.0F ? all(-1.0F) : k;
    const float beyond = static_cast<float>(2 * pair.half + 1);
    k = k > beyond ? all(beyond) : k;
    const Lanes weight = looked_up(pair.point_weight, __builtin_convertvector(k, Whole));
    tally.support *= 1.0F + weight * exponential(apart);
  }
  const auto through = (e < -terms.free_margin_m) & (a <= terms.facing_rad) & (a >= -terms.facing_rad);
  if (!any(through)) return;
  const Lanes miss = terms.facing * exponential(-a * a * pair.over_two_variance);
  tally.free *= 1.0F - (through ? miss : Lanes{});
}

using AddPair = void (*)(const PosteriorTerms&, const CirclePair&, const Block&, Tallied&);

template <AddPair add>
inline void add_all(const PosteriorTerms& terms, const CirclePair* pairs, std::int32_t count,
                    const PosteriorSums& sums) {
  for (std::int32_t b = 0; b < terms.blocks; ++b) {
    const std::int32_t first = b * bin_block;
    const Block bins{first, load(terms.t_rad + first), load(terms.cos_t + first), load(terms.sin_t + first)};
    Tallied tally;
    for (std::int32_t begin = 0; begin < count; begin += fold_every) {
      const std::int32_t end = begin + fold_every < count ? begin + fold_every : count;
      for (std::int32_t n = begin; n < end; ++n) add(terms, pairs[n], bins, tally);
      tally.fold();
    }
    store(sums.support + first, load(sums.support + first) + tally.support_sum);
    store(sums.free + first, load(sums.free + first) + tally.free_sum);
  }
}

}  // namespace

void add_walls(const PosteriorTerms& terms, const CirclePair* pairs, std::int32_t count, const PosteriorSums& sums) {
  add_all<add_wall>(terms, pairs, count, sums);
}

void add_points(const PosteriorTerms& terms, const CirclePair* pairs, std::int32_t count, const PosteriorSums& sums) {
  add_all<add_point>(terms, pairs, count, sums);
}

float normalise(float* log_weights, std::int32_t count, float top) {
  float sum = 0.0F;
  for (std::int32_t first = 0; first < count; first += bin_block) {
    store(log_weights + first, exponential(load(log_weights + first) - top));
    const std::int32_t end = first + bin_block < count ? first + bin_block : count;
    for (std::int32_t k = first; k < end; ++k) sum += log_weights[k];
  }
  for (std::int32_t k = 0; k < count; ++k) log_weights[k] /= sum;
  return sum;
}

}  // namespace echoarc::kernels::ECHOARC_ISA
