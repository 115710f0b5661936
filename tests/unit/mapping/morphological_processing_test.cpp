// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/morphological_processing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/mapping/voting.hpp"
#include "support/random_readings.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options) {
  Method method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

RC_GTEST_PROP(MorphologicalProperty, NoThinningKeepsTheArcMap, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 20);
  const auto voted = mapped<Voting>(readings, {.cell_m = 0.05, .threshold = 1}).export_map();
  const auto kept = mapped<MorphologicalProcessing>(readings, {.cell_m = 0.05, .neighbours = 0}).export_map();
  RC_ASSERT(kept->states.values().size() == voted->states.values().size());
  RC_ASSERT(std::ranges::equal(kept->states.values(), voted->states.values()));
}

RC_GTEST_PROP(MorphologicalProperty, KeepsFewerTheMoreNeighboursItAsksFor, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 30);
  auto previous = mapped<MorphologicalProcessing>(readings, {.cell_m = 0.05, .neighbours = 0});
  for (int m = 1; m <= 8; ++m) {
    auto method = mapped<MorphologicalProcessing>(readings, {.cell_m = 0.05, .neighbours = m});
    const Result<MapExport> map = method.export_map();
    for (const MapPoint& point : map->points.points())
      RC_ASSERT(previous.map().kept.at(previous.map().votes.counts().geometry().cell_of(point.position)));
    previous = std::move(method);
  }
}

TEST(MorphologicalProcessing, MorePassesKeepLessUntilNothingChanges) {
  Rng rng(4);
  const std::vector<Reading> readings = test::wall_drive(rng, 30);
  const auto once = mapped<MorphologicalProcessing>(readings, {.neighbours = 5});
  const auto twice = mapped<MorphologicalProcessing>(readings, {.neighbours = 5, .passes = 2});
  const auto for_ever = mapped<MorphologicalProcessing>(readings, {.neighbours = 5, .passes = 1000});
  EXPECT_LT(twice.map().kept.count(), once.map().kept.count());
  EXPECT_LE(for_ever.map().kept.count(), twice.map().kept.count());
  EXPECT_EQ(for_ever.map().kept.thinned(5), for_ever.map().kept);
}

TEST(MorphologicalProcessing, IdenticalArcsForEverLeaveOneArc) {
  const std::vector<Reading> hour(36'000, test::monostatic_reading({{0.003, 0.004}, degrees(33.0)}, Echo{1.0}));
  const auto once = mapped<MorphologicalProcessing>(std::span(hour).first(1), {.neighbours = 2});
  const auto always = mapped<MorphologicalProcessing>(hour, {.neighbours = 2});
  EXPECT_EQ(always.map().kept, once.map().kept);
  EXPECT_EQ(always.map().votes.counts().memory_bytes(), once.map().votes.counts().memory_bytes());
}

TEST(MorphologicalProcessing, RestoreRefusesDamagedBytes) {
  Rng rng(6);
  const auto method = mapped<MorphologicalProcessing>(test::random_readings(rng, 5), {.cell_m = 0.05});
  std::vector<std::byte> bytes = method.save();
  ASSERT_TRUE(MorphologicalProcessing::restore(bytes));
  EXPECT_EQ(MorphologicalProcessing::restore(bytes)->map().kept, method.map().kept);
  bytes.resize(bytes.size() - 3);
  EXPECT_FALSE(MorphologicalProcessing::restore(bytes));
}

}  // namespace
}  // namespace echoarc
