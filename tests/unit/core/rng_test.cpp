// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/rng.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

TEST(Rng, SeedZeroMatchesTheReferenceAlgorithm) {
  // SplitMix64 of seed 0 starts with e220a8397b1dcdaf, 6e789e6aa1b965f4, 06c45d188009454f, f88bb8a8724c81ec (reference
  // C code of S. Vigna); xoshiro256** then gives rotl(s1 * 5, 7) * 9.
  const std::uint64_t s1 = 0x6e789e6aa1b965f4ULL * 5;
  EXPECT_EQ(Rng(0).next(), ((s1 << 7) | (s1 >> 57)) * 9);
}

TEST(Rng, SameSeedSameNumbers) {
  Rng a(42);
  Rng b(42);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(a.next(), b.next());
  EXPECT_NE(Rng(1).next(), Rng(2).next());
}

TEST(Rng, MomentsOfUniformAndNormal) {
  Rng rng(7);
  double sum = 0.0;
  double sum_squares = 0.0;
  double sum_uniform = 0.0;
  constexpr int count = 100000;
  for (int k = 0; k < count; ++k) {
    const double x = rng.normal(2.0, 3.0);
    sum += x;
    sum_squares += x * x;
    const double u = rng.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum_uniform += u;
  }
  const double mean = sum / count;
  EXPECT_NEAR(mean, 2.0, 0.05);
  EXPECT_NEAR(std::sqrt(sum_squares / count - mean * mean), 3.0, 0.05);
  EXPECT_NEAR(sum_uniform / count, 0.5, 0.01);
}

TEST(Rng, BelowCoversItsRangeAlone) {
  Rng rng(3);
  int seen[5] = {};
  for (int k = 0; k < 5000; ++k) ++seen[rng.below(5)];
  for (const int n : seen) EXPECT_NEAR(n, 1000, 150);
}

}  // namespace
}  // namespace echoarc
