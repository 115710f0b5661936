// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The inner loops of step B of `Consensus`, compiled once per instruction set (cmake/EchoarcKernels.cmake). This header
// and the kernel source include nothing that holds inline functions: two copies of one, compiled with different flags,
// must never meet in the linker.

#include <cstdint>

namespace echoarc::kernels {

/// Bins of an arc fill whole blocks of this many.
inline constexpr int bin_block = 8;
inline constexpr int max_bins = 368;  ///< of one arc, in whole blocks: 45 degrees to either side in steps of a quarter

/// Another circular arc, seen from the arc in question: in a frame at its sensor whose x axis is its axis.
struct CirclePair {
  float x_m, y_m;   ///< the other sensor
  float shorter_m;  ///< own range less the other's
  float range_m;    ///< of the other
  float turn_rad;   ///< own axis less the other's
  float cos_turn, sin_turn;
  float over_two_variance;    ///< 1/(2 sigma_b^2) of the other's beam, 1/rad^2
  std::int32_t shift;         ///< the other's bin of the same direction is bin + shift
  std::int32_t half;          ///< the other's middle bin: it has 2 half + 1
  const float* wall_weight;   ///< q kappa u of the other's bins under the wall hypothesis; beyond both ends zeros
  const float* point_weight;  ///< the same under the point hypothesis
};

/// Constants of a map and of the arc in question.
struct PosteriorTerms {
  float over_two_length;  ///< 1/(2 l^2), 1/m^2
  float over_two_range;   ///< 1/(2 sigma^2), 1/m^2
  float no_support;       ///< exp of this times the largest weight is lost beside 1: what lies there is passed over
  float facing;           ///< nu
  float facing_rad;
  float free_margin_m;
  float over_step;      ///< bins per radian
  float range_m;        ///< of the arc in question
  std::int32_t blocks;  ///< of its bins
  const float* t_rad;   ///< its bins, in whole blocks
  const float* cos_t;
  const float* sin_t;
};

/// Sums of logarithms by bin, in whole blocks: what the neighbours say for a hypothesis, and against it.
struct PosteriorSums {
  float* support;
  float* free;
};

struct PosteriorKernels {
  const char* instruction_set;
  /// Adds what the neighbours `pairs[0 ... count)` say of walls.
  void (*add_walls)(const PosteriorTerms& terms, const CirclePair* pairs, std::int32_t count,
                    const PosteriorSums& sums);
  /// Adds what they say of points.
  void (*add_points)(const PosteriorTerms& terms, const CirclePair* pairs, std::int32_t count,
                     const PosteriorSums& sums);
  /// Replaces the `count` log-weights by weights that sum to 1, relative to `top`; the sum of exp(l - top).
  float (*normalise)(float* log_weights, std::int32_t count, float top);
};

/// The kernels for this processor, chosen once. All of them give the same bits.
const PosteriorKernels& posterior_kernels();
/// Every set of kernels this processor can run; the first is the plain one.
int available_posterior_kernels(const PosteriorKernels** list, int room);

}  // namespace echoarc::kernels
