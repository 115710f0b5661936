// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/directional_maximum.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_readings.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

using Counts = std::vector<std::uint16_t>;

// V3.1 of the method specification.
TEST(DirectionalMaximumRule, WorkedLines) {
  EXPECT_EQ(directional_maximum(Counts{0, 2, 5, 5, 1, 5, 0, 4, 5}, 4), 3U);
  EXPECT_EQ(directional_maximum(Counts{0, 2, 5, 5, 1, 5, 0, 4, 5}, 6), std::nullopt);
  EXPECT_EQ(directional_maximum(Counts{4, 4, 4}, 4), 1U);
  EXPECT_EQ(directional_maximum(Counts{3, 4, 0, 4}, 4), 1U);
  EXPECT_EQ(directional_maximum(Counts{1, 2, 3}, 4), std::nullopt);
  EXPECT_EQ(directional_maximum(Counts{}, 1), std::nullopt);
}

TEST(DirectionalMaximumRule, EvenNumberOfMaxima) {
  const Counts line{5, 0, 5, 5, 1, 5};
  EXPECT_EQ(directional_maximum(line, 4, TieRule::near), 2U);
  EXPECT_EQ(directional_maximum(line, 4, TieRule::far), 3U);
  int farther = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const auto survivor = directional_maximum(line, 4, TieRule::hash, 7, k);
    ASSERT_TRUE(survivor == 2U || survivor == 3U);
    EXPECT_EQ(survivor, directional_maximum(line, 4, TieRule::hash, 7, k)) << "repeatable";
    farther += survivor == 3U ? 1 : 0;
  }
  EXPECT_GT(farther, 400);
  EXPECT_LT(farther, 600);
  EXPECT_EQ(directional_maximum(Counts{5, 5, 5}, 4, TieRule::far), 1U) << "an odd number has one middle";
}

DirectionalMaximum mapped(const std::vector<Reading>& readings, DirectionalMaximumOptions options) {
  DirectionalMaximum method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

constexpr DirectionOfInterest all_directions[] = {DirectionOfInterest::automatic,     DirectionOfInterest::axis,
                                                  DirectionOfInterest::los,           DirectionOfInterest::path_normal,
                                                  DirectionOfInterest::followed_wall, DirectionOfInterest::pca,
                                                  DirectionOfInterest::polar};

RC_GTEST_PROP(DirectionalMaximumProperty, SurvivorsAreAmongTheVotes, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::wall_drive(rng, 30);
  for (const DirectionOfInterest doi : all_directions) {
    DirectionalMaximumOptions options{.cell_m = 0.02, .threshold = 1 + int(rng.below(4)), .doi = doi};
    options.polar_step = degrees(1.0);
    const DirectionalMaximum method = mapped(readings, options);
    for (const Cell cell : method.map().survivors)
      RC_ASSERT(method.map().votes.counts().value(cell) >= options.threshold);
    RC_ASSERT(std::ranges::is_sorted(method.map().survivors, [](Cell a, Cell b) { return a < b; }));
    RC_ASSERT(std::ranges::adjacent_find(method.map().survivors) == method.map().survivors.end());

    options.unvisited = UnvisitedRule::keep;
    const DirectionalMaximum keeping = mapped(readings, options);
    RC_ASSERT(
        std::ranges::includes(keeping.map().survivors, method.map().survivors, [](Cell a, Cell b) { return a < b; }));
  }
}

RC_GTEST_PROP(DirectionalMaximumProperty, ColumnsAreFullWhereVotingIsFull, (std::uint64_t seed)) {
  Rng rng(seed);
  const int threshold = 1 + int(rng.below(5));
  const std::vector<Reading> readings = test::wall_drive(rng, 30);
  const DirectionalMaximum method =
      mapped(readings, {.cell_m = 0.02, .threshold = threshold, .doi = DirectionOfInterest::axis});
  std::set<std::int32_t> voted;
  method.map().votes.counts().for_each_nonzero([&](Cell c, std::uint16_t count) {
    if (count >= threshold) voted.insert(c.i);
  });
  std::set<std::int32_t> kept;
  for (const Cell c : method.map().survivors) RC_ASSERT(kept.insert(c.i).second);  // one per column
  RC_ASSERT(kept == voted);
}

double mean_distance_to_wall_m(std::span<const Cell> cells, const GridGeometry& geometry) {
  double sum = 0.0;
  for (const Cell cell : cells) sum += std::abs(geometry.centre(cell).y - test::wall_y_m);
  return sum / double(cells.size());
}

// [Barshan07] 4.2: at the same threshold the map is nearer to the truth than that of voting.
TEST(DirectionalMaximum, EveryDirectionIsNearerToTheWallThanVoting) {
  Rng rng(3);
  const std::vector<Reading> readings = test::wall_drive(rng, 60);
  for (const DirectionOfInterest doi : all_directions) {
    const DirectionalMaximum method = mapped(readings, {.cell_m = 0.02, .threshold = 4, .doi = doi});
    const auto& counts = method.map().votes.counts();
    std::vector<Cell> voted;
    counts.for_each_nonzero([&](Cell c, std::uint16_t count) {
      if (count >= 4) voted.push_back(c);
    });
    const auto& survivors = method.map().survivors;
    ASSERT_GT(survivors.size(), 50U) << int(doi);
    EXPECT_LT(mean_distance_to_wall_m(survivors, counts.geometry()), mean_distance_to_wall_m(voted, counts.geometry()))
        << int(doi);
  }
}

TEST(DirectionalMaximum, ExportDrawsSurvivorsAlone) {
  const DirectionalMaximum method =
      mapped(test::v53_readings(),
             test::with_v53_grid(DirectionalMaximumOptions{.threshold = 2, .doi = DirectionOfInterest::axis}));
  const auto map = method.export_map();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->points.size(), 73U);
  EXPECT_EQ(std::size_t(std::ranges::count(map->states.values(), CellState::occupied)), 73U);
  EXPECT_EQ(std::ranges::count(map->states.values(), CellState::free), 0);
  const auto& counts = std::get<DenseGrid<std::uint16_t>>(map->values);
  EXPECT_EQ(std::ranges::max(counts.values()), 5);
}

TEST(DirectionalMaximum, MoreReadingsMayFollowFinish) {
  const std::vector<Reading> readings = test::v53_readings();
  const auto options = test::with_v53_grid(DirectionalMaximumOptions{.doi = DirectionOfInterest::axis});
  InlineExecutor executor;
  DirectionalMaximum method(options);
  method.insert(std::span(readings).first(5), executor);
  method.finish(executor);
  EXPECT_EQ(method.map().survivors, mapped({readings.begin(), readings.begin() + 5}, options).map().survivors);
  EXPECT_FALSE(method.map().survivors.empty());
  method.insert(std::span(readings).subspan(5), executor);
  method.finish(executor);
  EXPECT_EQ(method.map().survivors, mapped(readings, options).map().survivors);
}

}  // namespace
}  // namespace echoarc
