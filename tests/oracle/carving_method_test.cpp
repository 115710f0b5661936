// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/arc_carving.hpp"
#include "echoarc/mapping/carve.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

/// [Silver04] 5.A word by word: every previous arc in the history is checked against the new one. Newest first, to show
/// that the order in which arcs are stored does not matter.
std::vector<Vec2> carved_points(std::span<const Reading> readings, std::size_t history, double guard_m) {
  std::deque<std::optional<Arc>> ring;  // no value: removed
  std::vector<Vec2> points;
  const auto add = [&](const std::optional<Arc>& arc) {
    if (arc) points.push_back(arc->point_at(0.5 * (arc->t_begin() + arc->t_end())));
  };
  for (const Reading& reading : readings) {
    const auto newer = arc_of(reading);
    if (!newer) continue;
    if (ring.size() == history) {
      add(ring.front());
      ring.pop_front();
    }
    for (auto older = ring.rbegin(); older != ring.rend(); ++older) {
      if (!*older) continue;
      const Carving carving = carve(**older, FreeSector(*newer, guard_m));
      if (carving.outcome == CarveOutcome::carved) (*older)->set_limits(carving.t_begin, carving.t_end);
      if (carving.outcome > CarveOutcome::carved) older->reset();
    }
    ring.emplace_back(newer);
  }
  for (const auto& arc : ring) add(arc);
  return points;
}

RC_GTEST_PROP(CarveOracle, PointsAreThoseOfThePlainLoop, (std::uint64_t seed)) {
  Rng rng(seed);
  const bool hashed = rng.below(8) == 0;  // a ring this long is looked up by hash
  std::vector<Reading> readings = test::wall_drive(rng, hashed ? 100 : 20);
  for (int k = 0; k < (hashed ? 150 : 60); ++k) readings.push_back(test::random_reading(rng, readings.size()));
  constexpr int histories[] = {1, 7, 60, 250};
  const int history = hashed ? 600 : histories[rng.below(4)];
  const double guard_m = rng.below(2) == 0 ? 0.0 : 0.02;
  Carve method({.history = history, .guard_m = guard_m});
  InlineExecutor here;
  method.insert(readings, here);
  method.finish(here);
  const std::vector<Vec2> expected = carved_points(readings, std::size_t(history), guard_m);
  RC_ASSERT(method.map().size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) RC_ASSERT(method.map().points()[k].position == expected[k]);
}

RC_GTEST_PROP(CarveProperty, CarvingOnlyEverNarrows, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 60);
  Carve method({.history = 1'000});
  InlineExecutor here;
  std::map<PingId, double> bound_m;  // of the points of every echo so far
  for (const Reading& reading : readings) {
    method.insert(std::span(&reading, 1), here);
    method.finish(here);
    for (const MapPoint& point : method.map().points()) {
      const PingId echo = method.map().support(point)[0];
      const auto [known, first] = bound_m.try_emplace(echo, point.bound_m);
      RC_ASSERT(point.bound_m <= known->second + 1e-12);
      known->second = point.bound_m;
      if (point.label != PointLabel::centerline) continue;
      RC_ASSERT(point.position == arc_of(readings[echo])->midpoint());
    }
  }
}

}  // namespace
}  // namespace echoarc
