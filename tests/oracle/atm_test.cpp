// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// The arc-transversal median against all pairs of arcs, each list sorted afresh.

#include "echoarc/mapping/atm.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "support/random_readings.hpp"

namespace echoarc {
namespace {

/// The points of [Barshan07] 3.6 for the newest `history` arcs, one per arc, in the order of time.
std::vector<Vec2> pairwise_medians(const std::vector<Reading>& readings, Angle theta_t, std::size_t history) {
  std::vector<Arc> arcs;
  for (const Reading& reading : readings)
    if (const auto arc = arc_of(reading)) arcs.push_back(*arc);
  if (arcs.size() > history) arcs.erase(arcs.begin(), arcs.end() - std::ptrdiff_t(history));
  std::vector<std::vector<double>> along(arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i)
    for (std::size_t j = i + 1; j < arcs.size(); ++j)
      for (const ArcCrossing& crossing : crossings(arcs[i], arcs[j])) {
        if (crossing.angle < theta_t - eps_angle) continue;
        along[i].push_back(crossing.t_a.rad());
        along[j].push_back(crossing.t_b.rad());
      }
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    std::vector<double>& t = along[i];
    if (t.empty()) continue;
    std::ranges::sort(t);
    const std::size_t n = t.size();
    points.push_back(arcs[i].point_at(radians(n % 2 == 1 ? t[n / 2] : 0.5 * (t[n / 2 - 1] + t[n / 2]))));
  }
  return points;
}

void expect_equal(HistoryScope scope, int history_arcs, int count) {
  Rng rng(std::uint64_t(count) + 1);
  const std::vector<Reading> readings = test::random_readings(rng, count);
  AtmMod::Options options;
  options.history = scope;
  options.history_arcs = history_arcs;
  options.archive = false;
  AtmMod method(options);
  InlineExecutor executor;
  for (const Reading& reading : readings) method.insert(std::span(&reading, 1), executor);
  method.finish(executor);
  const std::size_t kept = scope == HistoryScope::all ? readings.size() : std::size_t(history_arcs);
  const std::vector<Vec2> expected = pairwise_medians(readings, options.theta_t, kept);
  ASSERT_EQ(method.map().size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_EQ(method.map().points()[k].position, expected[k]) << "equal to the last bit";
}

TEST(AtmOracle, AllArcs) {
  expect_equal(HistoryScope::all, 1, 300);   // looked through one by one
  expect_equal(HistoryScope::all, 1, 1500);  // through the hash
}

TEST(AtmOracle, RingOfTheNewest) {
  expect_equal(HistoryScope::total, 100, 700);
  expect_equal(HistoryScope::total, 1, 100);
  expect_equal(HistoryScope::total, 1000000, 300);
}

}  // namespace
}  // namespace echoarc
