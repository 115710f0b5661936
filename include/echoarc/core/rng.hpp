// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace echoarc {

/// Seeded generator xoshiro256** (Blackman, Vigna 2018), its state filled by SplitMix64. The standard distributions
/// differ between library vendors; these do not, so a seed means the same log everywhere. Always passed in, never
/// global.
class Rng {
 public:
  explicit Rng(std::uint64_t seed);

  [[nodiscard]] std::uint64_t next();
  /// Uniform in [0, 1), 53 random bits.
  [[nodiscard]] double uniform();
  /// Uniform in [low, high).
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in {0, ..., count - 1}; count > 0.
  [[nodiscard]] std::uint64_t below(std::uint64_t count);
  /// Normal by the polar method (Marsaglia, Bray 1964).
  [[nodiscard]] double normal(double mean, double standard_deviation);

 private:
  std::uint64_t state_[4];
};

}  // namespace echoarc
