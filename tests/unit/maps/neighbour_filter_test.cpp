// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/maps/neighbour_filter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

PointMap map_of(std::span<const Vec2> positions) {
  PointMap map;
  for (const Vec2 position : positions) {
    MapPoint point;
    point.position = position;
    point.ping = PingId(map.size());
    map.add(point, std::span<const PingId>(&point.ping, 1));
  }
  return map;
}

TEST(NeighbourFilter, KeepsTheFirstThreeOfV43) {
  const std::vector<Vec2> positions{{0, 0}, {0.1, 0}, {0.15, 0.05}, {1, 1}, {1.1, 1}};
  const PointMap kept = with_neighbours(map_of(positions), {.min_neighbours = 2, .radius_m = 0.2});
  ASSERT_EQ(kept.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(kept.points()[k].position, positions[k]);
    EXPECT_EQ(kept.support(kept.points()[k])[0], PingId(k));
  }
  EXPECT_EQ(with_neighbours(map_of(positions), {.min_neighbours = 1}).size(), 5U);
  EXPECT_EQ(with_neighbours(map_of(positions), {.min_neighbours = 0}).size(), 5U);
}

RC_GTEST_PROP(NeighbourFilterProperty, AgreesWithAllPairs, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Vec2> positions;
  for (int k = 0; k < 60; ++k) positions.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1)});
  const int enough = 1 + int(rng.below(4));
  std::vector<Vec2> expected;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    int near = 0;
    for (std::size_t other = 0; other < positions.size(); ++other)
      near += other != k && norm(positions[other] - positions[k]) <= 0.2 ? 1 : 0;
    if (near >= enough) expected.push_back(positions[k]);
  }
  const PointMap kept = with_neighbours(map_of(positions), {.min_neighbours = enough, .radius_m = 0.2});
  RC_ASSERT(kept.size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) RC_ASSERT(kept.points()[k].position == expected[k]);
}

TEST(NeighbourFilter, SegmentsNeedPointsNearTheirMiddle) {
  const std::vector<Vec2> positions{{0, 0}, {0.2, 0}, {1, 1}, {1.2, 1}};
  PointMap map = map_of(std::span(positions).first(3));
  const MapSegment near{positions[0], positions[1], PointLabel::link};
  const MapSegment lonely{positions[2], positions[3], PointLabel::zone};
  map.add(near);
  map.add(lonely);
  const PointMap kept = with_neighbours(map, {.min_neighbours = 2, .radius_m = 0.2});
  EXPECT_EQ(std::vector(kept.segments().begin(), kept.segments().end()), std::vector{near});
  EXPECT_EQ(with_neighbours(map, {.min_neighbours = 0}).segments().size(), 2U);
}

TEST(NeighbourFilter, CrowdsAndFarPointsAreHandled) {
  std::vector<Vec2> positions(100000, Vec2{0.01, 0.01});
  for (int k = 0; k < 100000; ++k) positions.push_back({0.19, 0.19});
  positions.push_back({1e7, -1e7});
  EXPECT_EQ(with_neighbours(map_of(positions)).size(), 200000U);
}

}  // namespace
}  // namespace echoarc
