// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/speed_of_sound.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/range_quantum.hpp"

namespace echoarc {
namespace {

// V1.1
TEST(SpeedOfSound, WorkedNumbers) {
  EXPECT_NEAR(speed_of_sound_m_s(273.0), 331.4000, 5e-5);
  EXPECT_NEAR(speed_of_sound_m_s(288.15), 340.4713, 5e-5);
  EXPECT_NEAR(speed_of_sound_m_s(293.0), 343.3247, 5e-5);
  EXPECT_NEAR(speed_of_sound_m_s(298.15), 346.3288, 5e-5);
  EXPECT_NEAR(speed_of_sound_m_s(303.0), 349.1343, 5e-5);
}

// V1.1
TEST(SpeedOfSound, RangeOfFlightTime) {
  EXPECT_NEAR(range_of_flight_time_m(5.8253e-3, 293.0), 0.99998455, 5e-9);
  EXPECT_NEAR(range_of_flight_time_m(10e-3, 293.0), 1.716623, 5e-7);
  EXPECT_NEAR(flight_time_of_range_s(3.81, 293.0), 22.1947e-3, 5e-8);
}

// V1.6: the cross-talk-free interval at 10.7 m, and how far 40 ms reach.
TEST(SpeedOfSound, FiringIntervals) {
  EXPECT_NEAR(flight_time_of_range_s(10.7, 293.0), 62.3317e-3, 5e-8);
  EXPECT_NEAR(range_of_flight_time_m(40e-3, 293.0), 6.866493, 5e-7);
}

RC_GTEST_PROP(SpeedOfSound, ReRangingEqualsComputingAnew, ()) {
  const double recorded_k = *rc::gen::inRange(250, 320);
  const double actual_k = *rc::gen::inRange(250, 320);
  const double time_s = *rc::gen::inRange(1, 80) * 1e-3;
  const double reranged = range_of_flight_time_m(time_s, recorded_k) * rerange_factor(recorded_k, actual_k);
  RC_ASSERT(std::abs(reranged - range_of_flight_time_m(time_s, actual_k)) < 1e-12);
}

// V1.4
TEST(RangeQuantum, WorkedNumbers) {
  const auto rounded = [](double r) { return quantise(r, inch_m); };
  const auto truncated = [](double r) { return quantise(r, inch_m, Quantisation::truncate); };
  EXPECT_NEAR(rounded(1.000), 0.9906, 1e-12);
  EXPECT_NEAR(rounded(1.013), 1.0160, 1e-12);
  EXPECT_NEAR(truncated(1.013), 0.9906, 1e-12);
  EXPECT_NEAR(rounded(1.0287), 1.0414, 1e-12) << "40.5 steps: half away from zero";
  EXPECT_NEAR(truncated(1.0287), 1.0160, 1e-12);
  EXPECT_NEAR(rounded(2.500), 2.4892, 1e-12);
  EXPECT_NEAR(rounded(3.050), 3.0480, 1e-12);
}

TEST(RangeQuantum, AReadingOnAStepStaysThere) {
  for (int k = 0; k <= 421; ++k) {
    const double on_step = k * inch_m;
    EXPECT_EQ(quantise(on_step, inch_m), on_step) << k;
    EXPECT_EQ(quantise(on_step, inch_m, Quantisation::truncate), on_step) << k;
  }
}

RC_GTEST_PROP(RangeQuantum, StaysInItsBand, ()) {
  const double range_m = *rc::gen::inRange(0, 1'070'000) * 1e-5;
  RC_ASSERT(std::abs(quantise(range_m, inch_m) - range_m) <= inch_m / 2 + 1e-9);
  const double cut = range_m - quantise(range_m, inch_m, Quantisation::truncate);
  RC_ASSERT(cut > -1e-9 && cut < inch_m + 1e-9);
}

}  // namespace
}  // namespace echoarc
