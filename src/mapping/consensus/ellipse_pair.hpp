// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

#include "mapping/consensus/arc_table.hpp"

namespace echoarc::consensus {

/// Sums of logarithms by bin: what neighbours say for either hypothesis and against it.
struct BinSums {
  float* wall_support;
  float* wall_free;
  float* point_support;
  float* point_free;
};

/// To a quarter of a micrometre or microradian: then no digit of a result depends on where the world's origin lies.
[[nodiscard]] inline double snapped(double value) {
  constexpr double magic = 1.5 * (1LL << (52 - 22));  // digits finer than 2^-22 fall off; requires |value| < 2^29
  return (value + magic) - magic;
}

/// Bins to the nearest whole number; half-way between two always up, whatever the last digits.
[[nodiscard]] inline int shifted_bins(double bins) {
  constexpr double tie = 1e-4;
  return int(std::floor(bins + 0.5 + tie));
}

/// What arc `j` says of the bins of arc `i`, whatever their shapes: the slow form of the kernels, for ellipses.
/// `wall_weight` and `point_weight` are j's rows of q kappa u.
void add_any_pair(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i, std::size_t j,
                  const float* wall_weight, const float* point_weight, const BinSums& sums);

}  // namespace echoarc::consensus
