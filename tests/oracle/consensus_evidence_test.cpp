// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The grid form of tangent consensus against its plain form: the oracle's posteriors, every cell of the world asked for
// its distance and bearing, no raster, no table of sines, no window.

#include "echoarc/mapping/consensus_evidence.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "oracle/consensus_oracle.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

double log_odds_of(double p) {
  return std::log(p / (1.0 - p));
}

/// What a believed arc adds to the log-odds of a place.
double evidence_of(const oracle::ConsensusOracle::Belief& belief, const ConsensusEvidenceOptions& o, Vec2 place,
                   double near_m) {
  const Vec2 d = place - belief.arc.s;
  const double step = o.step.rad();
  const double theta = oracle::wrapped(bearing(d).rad() - belief.arc.phi);
  const int k = int(std::floor(theta / step + 0.5));
  if (std::abs(k) > belief.half) return 0.0;
  double mass = 0.0;
  for (int m = -belief.half; m <= belief.half; ++m)
    if (std::abs(m - k) * step * belief.arc.r <= o.spread_m) mass += belief.w[std::size_t(m + belief.half)];
  const double e = norm(d) - belief.arc.r;
  if (std::abs(e) <= 2.0 * o.band_sigma_m)
    return log_odds_of(0.5 + (o.occupied_peak - 0.5) * mass * oracle::bell(e, o.band_sigma_m));
  if (e >= -o.free_margin_m || norm(d) < near_m) return 0.0;
  return log_odds_of(0.5 - (0.5 - o.free_floor) * mass);
}

void expect_oracle(const ConsensusEvidenceOptions& options, const std::vector<Reading>& readings) {
  ConsensusEvidence method(options);
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);

  oracle::ConsensusOracle oracle(options, readings);
  (void)oracle.map();
  const auto beliefs = oracle.beliefs();
  int believed = 0;
  for (const auto& belief : beliefs) believed += belief.kept ? 1 : 0;
  EXPECT_EQ(method.tallies()[0].count, std::uint64_t(believed));
  ASSERT_GT(believed, 10);

  const GridGeometry& geometry = method.map().geometry();
  double worst = 0.0;
  int told = 0;
  for (Cell cell{-100, -100}; cell.j < 100; ++cell.j)
    for (cell.i = -100; cell.i < 100; ++cell.i) {
      double expected = 0.0;
      for (const auto& belief : beliefs)
        if (belief.kept) expected += evidence_of(belief, options, geometry.centre(cell), readings[0].range_min_m);
      told += expected != 0.0 ? 1 : 0;
      if (std::abs(expected) > 7.9) continue;  // at the clamp the order counts
      worst = std::max(worst, std::abs(expected - method.cell_log_odds(cell)));
    }
  EXPECT_GT(told, 500);
  // A posterior in floats is a thousandth off; hundreds of arcs add up.
  EXPECT_LT(worst, 0.02);
}

TEST(ConsensusEvidenceOracle, AgreesOnAWall) {
  Rng rng(3);
  expect_oracle({}, test::wall_drive(rng, 20));
}

TEST(ConsensusEvidenceOracle, AgreesWithOtherOptions) {
  Rng rng(4);
  ConsensusEvidenceOptions options;
  options.cell_m = 0.03;
  options.spread_m = 0.04;
  options.band_sigma_m = 0.03;
  options.free_margin_m = 0.2;
  options.occupied_peak = 0.7;
  options.free_floor = 0.4;
  options.step = degrees(2.0);
  expect_oracle(options, test::wall_drive(rng, 15));
}

}  // namespace
}  // namespace echoarc
