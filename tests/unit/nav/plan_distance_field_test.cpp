// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/distance_field.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

/// The obvious way: every cell against every occupied one.
DenseGrid<float> slow_distance_field(const DenseGrid<CellState>& map, double cap_m) {
  DenseGrid<float> distances_m(map.geometry(), map.width(), map.height());
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i) {
      double squared = std::numeric_limits<double>::infinity();
      for (std::int32_t y = 0; y < map.height(); ++y)
        for (std::int32_t x = 0; x < map.width(); ++x)
          if (map.at({x, y}) == CellState::occupied)
            squared = std::min(squared, double((x - i) * (x - i) + (y - j) * (y - j)));
      distances_m.at({i, j}) = float(std::min(map.geometry().cell_m * std::sqrt(squared), cap_m));
    }
  return distances_m;
}

bool equal(const DenseGrid<float>& a, const DenseGrid<float>& b) {
  return a.geometry() == b.geometry() && std::ranges::equal(a.values(), b.values());
}

TEST(DistanceField, WorkedNumbers) {
  const DenseGrid<float> field = distance_field(drawn_map({"?    ", "     ", "    #"}, 0.5));
  EXPECT_FLOAT_EQ(field.at({4, 0}), 0.0F);
  EXPECT_FLOAT_EQ(field.at({0, 0}), 2.0F);
  EXPECT_FLOAT_EQ(field.at({4, 2}), 1.0F);
  EXPECT_FLOAT_EQ(field.at({3, 1}), float(0.5 * std::sqrt(2.0)));
  EXPECT_FLOAT_EQ(field.at({0, 2}), float(0.5 * std::sqrt(20.0))) << "an unknown cell is no obstacle";
}

TEST(DistanceField, NothingOccupiedIsInfinitelyFar) {
  const DenseGrid<float> field = distance_field(free_map(7, 3));
  for (const float distance_m : field.values()) EXPECT_TRUE(std::isinf(distance_m));
  EXPECT_TRUE(distance_field(DenseGrid<CellState>{}).empty());
  CappedDistanceField capped(0.7);
  capped.reset(free_map(7, 3));
  for (const float distance_m : capped.distances_m().values()) EXPECT_FLOAT_EQ(distance_m, 0.7F);
}

TEST(DistanceField, AnUpdateReachesNoFurtherThanTheCap) {
  DenseGrid<CellState> map = free_map(60, 60);
  CappedDistanceField field(0.5);
  field.reset(map);
  map.at({30, 30}) = CellState::occupied;
  EXPECT_EQ(field.update(map, {30, 30, 31, 31}), (CellBox{25, 25, 36, 36}));
  EXPECT_FLOAT_EQ(field.distances_m().at({33, 34}), 0.5F);
  EXPECT_FLOAT_EQ(field.distances_m().at({33, 30}), 0.3F);
  EXPECT_TRUE(field.update(map, {}).empty());
}

RC_GTEST_PROP(DistanceFieldProperty, EqualsTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  const DenseGrid<CellState> map = random_map(rng, 30);
  RC_ASSERT(equal(distance_field(map), slow_distance_field(map, std::numeric_limits<double>::infinity())));
}

RC_GTEST_PROP(DistanceFieldProperty, UpdatedHereAndThereEqualsTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  DenseGrid<CellState> map = random_map(rng, 30);
  const double cap_m = rng.uniform(0.05, 1.5);
  CappedDistanceField field(cap_m);
  field.reset(map);
  for (int k = 0; k < 5; ++k) field.update(map, change_at_random(rng, map));
  RC_ASSERT(equal(field.distances_m(), slow_distance_field(map, cap_m)));
}

}  // namespace
}  // namespace echoarc::nav
