// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

#include "echoarc/core/rng.hpp"

namespace echoarc::sim {

/// What random numbers are drawn for. Every use has streams of its own, so that drawing more or fewer numbers for one
/// leaves the others as they were.
enum class Draw : std::uint64_t { ping = 1, floor, pitch, odometry, laser };

/// The finaliser of SplitMix64: every bit of the result depends on every bit of `x`.
[[nodiscard]] constexpr std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// The stream number (`index`, `part`) of a use.
[[nodiscard]] inline Rng stream(std::uint64_t seed, Draw draw, std::uint64_t index, std::uint64_t part = 0) {
  std::uint64_t state = scrambled(seed);
  for (const std::uint64_t word : {static_cast<std::uint64_t>(draw), index, part}) state = scrambled(state ^ word);
  return Rng(state);
}

}  // namespace echoarc::sim
