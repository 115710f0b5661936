// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/flight_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

using M = FlightTimeMethod;
constexpr M all_methods[] = {M::simple, M::adaptive, M::variable, M::double_threshold, M::curve_fit};

struct Pulse {
  double t0_s = 5e-3;
  double period_s = 1e-6;
  double rise_s = 1e-3;  ///< the edge rises so long, then falls as it rose
  double gain = 4e6;
  double noise = 0.0;
  std::size_t count = 12000;
};

/// e(t) = a (t - t0)^2, then its mirror image; noise of this RMS on top, without outliers: at 4 or 5 sigma those are
/// false alarms.
std::vector<double> envelope_of(const Pulse& pulse, std::uint64_t seed = 1) {
  Rng rng(seed);
  std::vector<double> samples;
  for (std::size_t k = 0; k < pulse.count; ++k) {
    const double t = double(k) * pulse.period_s - pulse.t0_s;
    const double edge = std::clamp(std::min(t, 2.0 * pulse.rise_s - t), 0.0, pulse.rise_s);
    samples.push_back(pulse.gain * edge * edge + pulse.noise * rng.uniform(0.0, std::sqrt(3.0)));
  }
  return samples;
}

std::optional<double> estimate(const std::vector<double>& samples, const FlightTimeOptions& options,
                               double period_s = 1e-6) {
  const auto result = flight_time_s({.samples = samples, .period_s = period_s}, options);
  EXPECT_TRUE(result);
  return result ? *result : std::nullopt;
}

TEST(FlightTime, V12AParabolicEdge) {
  const std::vector<double> samples = envelope_of({});
  EXPECT_NEAR(*estimate(samples, {.method = M::simple, .threshold = 1.0}), 5.5000e-3, 1e-9);
  EXPECT_NEAR(*estimate(samples, {.method = M::double_threshold, .threshold = 1.0}), 5.2929e-3, 5e-8);
  EXPECT_NEAR(*estimate(samples, {.method = M::double_threshold, .threshold = 1.0}),
              2.0 * 5.5e-3 - (5e-3 + std::sqrt(0.5) * 1e-3), 1e-8);
  EXPECT_NEAR(*estimate(samples, {.method = M::curve_fit, .threshold = 1.0}), 5.0000e-3, 1e-9);
}

TEST(FlightTime, CurveFitIsExactBetweenSamples) {
  for (const double t0_s : {4.0001234e-3, 5.00777e-3, 6.9e-3}) {
    const std::vector<double> samples = envelope_of({.t0_s = t0_s, .period_s = 20e-6, .count = 600});
    EXPECT_NEAR(*estimate(samples, {.method = M::curve_fit, .threshold = 0.5}, 20e-6), t0_s, 1e-9);
  }
}

TEST(FlightTime, NoisyEchoesAreFoundByAllMethods) {
  for (const M method : all_methods)
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      const std::vector<double> samples =
          envelope_of({.period_s = 10e-6, .gain = 100e6, .noise = 0.5, .count = 1200}, seed);
      const auto time_s = estimate(samples, {.method = method}, 10e-6);
      ASSERT_TRUE(time_s) << int(method);
      const double late_s =
          method == M::variable ? 1e-3 : 0.5e-3;  // its level is high at first, so that noise stays below
      EXPECT_NEAR(*time_s, 5e-3, late_s) << int(method) << " seed " << seed;
    }
}

TEST(FlightTime, TheVariableLevelFallsWithTheRange) {
  std::vector<double> samples(3000, 0.0);
  samples[291] = 0.9;  // 0.5 m: below the level there
  samples[1000] = 0.5;
  const FlightTimeOptions options{.method = M::variable, .threshold = 1.0};
  EXPECT_NEAR(*estimate(samples, options, 10e-6), 1000 * 10e-6, 10e-6);
  samples[291] = 1.1;
  EXPECT_NEAR(*estimate(samples, options, 10e-6), 291 * 10e-6, 10e-6);
  // g(4 t_ref) = 1/4 10^(-1.6 * 3 m / 20), path 3 m beyond the reference of 1 m
  std::vector<double> late(3000, 0.0);
  const std::size_t at = std::size_t(std::round(4.0 * flight_time_of_range_s(0.5, 293.0) / 10e-6));
  const double level = 0.25 * std::pow(10.0, -1.6 * 3.0 / 20.0);
  late[at] = 1.01 * level;
  EXPECT_TRUE(estimate(late, options, 10e-6));
  late[at] = 0.99 * level;
  EXPECT_FALSE(estimate(late, options, 10e-6));
}

TEST(FlightTime, TheAdaptiveLevelFollowsClutter) {
  std::vector<double> samples(4000);
  Rng rng(3);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double clutter = k < 2000 ? 10.0 : 1.0;  // strong at first, then weak
    samples[k] = clutter * (1.0 + 0.05 * rng.uniform(-1.0, 1.0));
  }
  for (std::size_t k = 3000; k < 3040; ++k) samples[k] += 0.1 * double(k - 2999);
  const auto time_s = estimate(samples, {.method = M::adaptive}, 10e-6);
  ASSERT_TRUE(time_s);
  EXPECT_NEAR(*time_s, 30.02e-3, 0.05e-3);  // a constant level would hear the clutter at once
  EXPECT_LT(*estimate(samples, {.method = M::simple, .threshold = 3.0}, 10e-6), 1e-3);
}

TEST(FlightTime, DoubleThresholdPassesOverSlowEdges) {
  std::vector<double> samples(6000, 0.0);
  for (std::size_t k = 1000; k < 1400; ++k) samples[k] = 1.5;                       // never doubles
  for (std::size_t k = 2000; k < 2400; ++k) samples[k] = double(k - 2000) / 100.0;  // doubles in 1 ms
  for (std::size_t k = 4000; k < 4100; ++k) samples[k] = double(k - 4000) / 10.0;
  EXPECT_NEAR(*estimate(samples, {.method = M::double_threshold, .threshold = 1.0}, 10e-6), 40e-3, 1e-9);
  samples.resize(3000);
  EXPECT_FALSE(estimate(samples, {.method = M::double_threshold, .threshold = 1.0}, 10e-6));
}

TEST(FlightTime, CurveFitFallsBackToTheCrossing) {
  std::vector<double> samples(1000, 0.0);
  samples[500] = 2.0;  // too few samples for a fit
  EXPECT_NEAR(*estimate(samples, {.method = M::curve_fit, .threshold = 1.0}, 10e-6), 4.995e-3, 1e-9);
}

TEST(FlightTime, BlankingHidesTheTransmission) {
  std::vector<double> samples(2000, 0.0);
  for (std::size_t k = 0; k < 30; ++k) samples[k] = 100.0;  // 0.3 ms of ring-down
  samples[600] = 2.0;
  EXPECT_NEAR(*estimate(samples, {.threshold = 1.0}, 10e-6), 5.995e-3, 1e-9);
  EXPECT_EQ(*estimate(samples, {.threshold = 1.0, .range_min_m = 0.0}, 10e-6), 0.0);
  EXPECT_FALSE(estimate(samples, {.threshold = 1.0, .range_min_m = 900.0}, 10e-6));
}

TEST(FlightTime, SilenceIsNoEcho) {
  for (const M method : all_methods) {
    EXPECT_FALSE(estimate({}, {.method = method}));
    EXPECT_FALSE(estimate(std::vector<double>(5000, 0.0), {.method = method}));
    EXPECT_FALSE(estimate(std::vector<double>(5000, -1.0), {.method = method}));
    EXPECT_FALSE(estimate(envelope_of({}), {.method = method, .threshold = 1e300, .threshold_sigmas = 1e6}));
  }
  EXPECT_FALSE(estimate(std::vector<double>(5000, 3.0), {.method = M::adaptive})) << "a constant hum is no echo";
}

TEST(FlightTime, WhatIsNoEnvelopeIsAnError) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<double> samples(100, 0.0);
    samples[42] = bad;
    const auto result = flight_time_s({.samples = samples, .period_s = 1e-6});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().where, "sample 42");
    EXPECT_FALSE(flight_time_s({.samples = {}, .period_s = bad}));
    EXPECT_FALSE(flight_time_s({.samples = {}, .period_s = 1e-6, .start_s = bad}));
  }
  EXPECT_FALSE(flight_time_s({.samples = {}, .period_s = 0.0}));
  EXPECT_FALSE(flight_time_s({.samples = {}, .period_s = -1.0}));
}

RC_GTEST_PROP(FlightTimeProperty, AnyNumbersGiveATimeInsideTheEnvelope, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<double> samples(rng.below(3000));
  for (double& e : samples) e = rng.uniform(-1.0, 1.0) * std::pow(10.0, rng.uniform(-300, 308));
  const double period_s = std::pow(10.0, rng.uniform(-9, 2));
  const double start_s = rng.uniform(0.0, 1e-3);
  for (const M method : all_methods) {
    const FlightTimeOptions options{.method = method,
                                    .threshold_sigmas = rng.uniform(0, 10),
                                    .window = 2 + int(rng.below(200)),
                                    .guard = int(rng.below(50))};
    const auto result = flight_time_s({.samples = samples, .period_s = period_s, .start_s = start_s}, options);
    RC_ASSERT(result.has_value());
    if (!*result) continue;
    RC_ASSERT(std::isfinite(**result));
    RC_ASSERT(**result <= start_s + double(samples.size()) * period_s);
  }
}

RC_GTEST_PROP(FlightTimeProperty, LouderEnvelopesGiveTheSameTime, (std::uint64_t seed)) {
  std::vector<double> samples = envelope_of({.period_s = 10e-6, .gain = 100e6, .noise = 0.5, .count = 1200}, seed);
  std::vector<double> louder = samples;
  for (double& e : louder) e *= 1024.0;
  for (const M method : all_methods) {
    const auto quiet_s = estimate(samples, {.method = method}, 10e-6);
    const auto loud_s = estimate(louder, {.method = method}, 10e-6);
    RC_ASSERT(quiet_s.has_value() && loud_s.has_value());
    RC_ASSERT(std::abs(*quiet_s - *loud_s) < 1e-12);
  }
}

}  // namespace
}  // namespace echoarc
