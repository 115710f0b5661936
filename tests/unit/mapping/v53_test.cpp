// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "echoarc/mapping/centerline.hpp"
#include "echoarc/mapping/directional_maximum.hpp"
#include "echoarc/mapping/morphological_processing.hpp"
#include "echoarc/mapping/voting.hpp"
#include "support/v53_scene.hpp"

// The integration example V5.3 of the method specification: cells per method and threshold.
namespace echoarc {
namespace {

template <class Method>
std::size_t occupied_cells(typename Method::Options options) {
  Method method(test::with_v53_grid(options));
  InlineExecutor executor;
  method.insert(test::v53_readings(), executor);
  method.finish(executor);
  const Result<MapExport> map = method.export_map();
  return std::size_t(std::ranges::count(map->states.values(), CellState::occupied));
}

TEST(V53, ArcMap) {
  Voting voting(test::with_v53_grid<VotingOptions>());
  InlineExecutor executor;
  voting.insert(test::v53_readings(), executor);
  const CellBox region = test::v53_region();
  int nonzero = 0;
  int sum = 0;
  int largest = 0;
  voting.map().for_each_nonzero([&](Cell c, std::uint16_t count) {
    EXPECT_TRUE(region.contains(c));
    ++nonzero;
    sum += count;
    largest = std::max<int>(largest, count);
  });
  EXPECT_EQ(nonzero, 251);
  EXPECT_EQ(sum, 539);
  EXPECT_EQ(largest, 5);
  const int row_100[] = {0, 0, 1, 3, 5, 5, 5, 5, 3, 1, 0, 0, 0};
  for (int k = 0; k <= 12; ++k) EXPECT_EQ(voting.map().value({10 * k, 100}), row_100[k]) << "column " << 10 * k;
  EXPECT_EQ(voting.map().value({30, 98}), 1);
  EXPECT_EQ(voting.map().value({30, 99}), 2);
  EXPECT_EQ(voting.map().value({30, 100}), 3);
}

TEST(V53, PointMarking) {
  EXPECT_EQ(occupied_cells<Centerline>({}), 11U);
}

TEST(V53, VotingAndThresholding) {
  EXPECT_EQ(occupied_cells<Voting>({.threshold = 1}), 251U);
  EXPECT_EQ(occupied_cells<Voting>({.threshold = 2}), 151U);
  EXPECT_EQ(occupied_cells<Voting>({.threshold = 4}), 46U);
}

TEST(V53, DirectionalMaximumAlongColumns) {
  const auto columns = [](int threshold) {
    return DirectionalMaximumOptions{.threshold = threshold, .doi = DirectionOfInterest::axis, .axis = degrees(90.0)};
  };
  EXPECT_EQ(occupied_cells<DirectionalMaximum>(columns(1)), 95U);
  EXPECT_EQ(occupied_cells<DirectionalMaximum>(columns(2)), 73U);
  EXPECT_EQ(occupied_cells<DirectionalMaximum>(columns(4)), 41U);
}

TEST(V53, MorphologicalProcessing) {
  EXPECT_EQ(occupied_cells<MorphologicalProcessing>({.neighbours = 0}), 251U);
  EXPECT_EQ(occupied_cells<MorphologicalProcessing>({.neighbours = 4}), 241U);
  EXPECT_EQ(occupied_cells<MorphologicalProcessing>({.neighbours = 7}), 71U);
  EXPECT_EQ(occupied_cells<MorphologicalProcessing>({.neighbours = 8}), 69U);
}

}  // namespace
}  // namespace echoarc
