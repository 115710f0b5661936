// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/mapping/bayes_update.hpp"
#include "echoarc/mapping/directional_maximum.hpp"
#include "echoarc/mapping/voting.hpp"
#include "oracle/mapping_oracles.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

constexpr double cell_m = 0.1;
constexpr CellBox region{-70, -70, 70, 70};  // 7 m to all sides: holds every random reading

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options) {
  Method method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

oracle::Counts counts_of(const VoteGrid::Counts& grid) {
  oracle::Counts counts;
  grid.for_each_nonzero([&](Cell c, std::uint16_t count) { counts[c] = count; });
  return counts;
}

RC_GTEST_PROP(VotingOracle, CountsAreEqual, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 20);
  const Voting method = mapped<Voting>(readings, {.cell_m = cell_m});
  RC_ASSERT(counts_of(method.map()) == oracle::votes(readings, method.map().geometry()));
}

/// Full rows or columns of the region, ordered along an axis of the grid.
std::vector<std::vector<Cell>> grid_lines(Angle axis) {
  const auto step = Cell{std::int32_t(std::lround(cos(axis))), std::int32_t(std::lround(sin(axis)))};
  std::vector<std::vector<Cell>> lines;
  for (std::int32_t k = region.i_begin; k < region.i_end; ++k) {
    std::vector<Cell> line;
    for (std::int32_t s = region.i_begin; s < region.i_end; ++s)
      line.push_back(step.i != 0 ? Cell{step.i * s, k} : Cell{k, step.j * s});
    lines.push_back(line);
  }
  return lines;
}

std::vector<Cell> survivors_of(const std::vector<std::vector<Cell>>& lines, const oracle::Counts& counts,
                               int threshold) {
  std::set<Cell> survivors;
  for (const auto& line : lines)
    if (const auto cell = oracle::line_survivor(line, counts, threshold)) survivors.insert(*cell);
  return {survivors.begin(), survivors.end()};
}

RC_GTEST_PROP(DirectionalMaximumOracle, RowsAndColumnsAreEqual, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 40);
  for (const double axis_deg : {90.0, -90.0, 0.0, 180.0}) {
    const int threshold = 1 + int(rng.below(4));
    const auto method = mapped<DirectionalMaximum>(
        readings,
        {.cell_m = cell_m, .threshold = threshold, .doi = DirectionOfInterest::axis, .axis = degrees(axis_deg)});
    const auto counts = oracle::votes(readings, method.map().votes.counts().geometry());
    RC_ASSERT(method.map().survivors == survivors_of(grid_lines(degrees(axis_deg)), counts, threshold));
  }
}

RC_GTEST_PROP(DirectionalMaximumOracle, LinesOfSightAreEqual, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 8);
  const int threshold = 1 + int(rng.below(2));
  const auto method =
      mapped<DirectionalMaximum>(readings, {.cell_m = cell_m, .threshold = threshold, .doi = DirectionOfInterest::los});
  const GridGeometry geometry = method.map().votes.counts().geometry();
  std::vector<std::vector<Cell>> lines;
  for (const Reading& reading : readings)
    if (const auto arc = arc_of(reading))
      lines.push_back(oracle::crossed_cells(arc->centre(), unit(arc->axis()), reading.range_max_m, region, geometry));
  RC_ASSERT(method.map().survivors == survivors_of(lines, oracle::votes(readings, geometry), threshold));
}

RC_GTEST_PROP(BayesUpdateOracle, CellsAgree, (std::uint64_t seed)) {
  Rng rng(seed);
  const std::vector<Reading> readings = test::random_readings(rng, 6);
  const BayesUpdateOptions options{.cell_m = cell_m, .range_error_m = rng.uniform(0.02, 0.2)};
  const auto method = mapped<BayesUpdate>(readings, options);
  const auto expected = oracle::bayes(readings, region, options);
  double worst = 0.0;
  RC_ASSERT(region.contains({method.map().bounds().i_begin, method.map().bounds().j_begin}));
  for (std::int32_t j = region.j_begin; j < region.j_end; ++j)
    for (std::int32_t i = region.i_begin; i < region.i_end; ++i) {
      const BayesCell cell = method.map().value({i, j});
      const auto found = expected.find({i, j});
      const BayesCell wanted = found != expected.end() ? found->second : BayesCell{};
      worst = std::max({worst, std::abs(cell.empty - wanted.empty), std::abs(cell.occupied - wanted.occupied)});
    }
  RC_ASSERT(worst < 1e-10);
}

RC_GTEST_PROP(BayesUpdateProperty, OrderOfReadingsDoesNotMatter, (std::uint64_t seed)) {
  Rng rng(seed);
  std::vector<Reading> readings = test::random_readings(rng, 10);
  const auto forward = mapped<BayesUpdate>(readings, {.cell_m = cell_m});
  std::ranges::reverse(readings);
  const auto backward = mapped<BayesUpdate>(readings, {.cell_m = cell_m});
  forward.map().for_each_nonzero([&](Cell c, const BayesCell& cell) {
    RC_ASSERT(std::abs(cell.empty - backward.map().value(c).empty) < 1e-12);
    RC_ASSERT(std::abs(cell.occupied - backward.map().value(c).occupied) < 1e-12);
  });
}

}  // namespace
}  // namespace echoarc
