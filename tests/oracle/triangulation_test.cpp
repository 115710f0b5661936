// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracle/triangulation_oracle.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

/// The fast form agrees with the plain loop: the same points, positions to 1e-9 m.
void compare(const std::vector<Reading>& readings, const TriangulationOptions& options) {
  TriangulationFusion method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  const auto expected = oracle::fused_points(readings, options);
  RC_ASSERT(method.map().size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const MapPoint& point = method.map().points()[k];
    RC_ASSERT(norm(point.position - expected[k].position) < 1e-9);
    RC_ASSERT(int(point.support_count) == expected[k].successes + 1);
    RC_ASSERT((point.label == PointLabel::edge) == (expected[k].max_deviation_m <= options.edge_m));
    RC_ASSERT(point.bound_m > 0.0);
  }
}

RC_GTEST_PROP(TriangulationOracle, DrivesPastAWallAgree, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::wall_drive(rng, 40);
  compare(readings, {.threshold = 1 + int(rng.below(4)), .columns = 1 + int(rng.below(20))});
}

RC_GTEST_PROP(TriangulationOracle, ScatteredReadingsAgree, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Reading> readings = test::random_readings(rng, 150);
  for (Reading& reading : readings) reading.beam_width = degrees(rng.uniform(5, 175));  // pairs that meet twice
  compare(readings, {.threshold = 1,
                     .columns = 2 + int(rng.below(30)),
                     .column_m = rng.uniform(0.0, 1.5),
                     .column_turn = degrees(180.0),
                     .gate_m = rng.uniform(0.0, 1.0)});
}

}  // namespace
}  // namespace echoarc
