// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/frontiers.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

/// The obvious way: looks at every cell, joins by repeating labels until nothing changes.
std::vector<Frontier> slow_frontiers(const DenseGrid<CellState>& map, std::size_t least_cells) {
  std::vector<Cell> cells;
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i) {
      if (map.at({i, j}) != CellState::free) continue;
      bool at_unknown = false;
      for (std::int32_t y = j - 1; y <= j + 1; ++y)
        for (std::int32_t x = i - 1; x <= i + 1; ++x)
          at_unknown = at_unknown || !map.box().contains({x, y}) || map.at({x, y}) == CellState::unknown;
      if (at_unknown) cells.push_back({i, j});
    }
  std::vector<std::size_t> label(cells.size());
  for (std::size_t k = 0; k < label.size(); ++k) label[k] = k;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t a = 0; a < cells.size(); ++a)
      for (std::size_t b = 0; b < cells.size(); ++b)
        if (label[b] < label[a] && std::abs(cells[a].i - cells[b].i) <= 1 && std::abs(cells[a].j - cells[b].j) <= 1) {
          label[a] = label[b];
          changed = true;
        }
  }
  std::vector<Frontier> frontiers;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    Frontier frontier;
    double x = 0.0;
    double y = 0.0;
    for (std::size_t n = 0; n < cells.size(); ++n)
      if (label[n] == k) {
        frontier.cells.push_back(cells[n]);
        x += cells[n].i;
        y += cells[n].j;
      }
    if (frontier.cells.empty() || frontier.cells.size() < least_cells) continue;
    const auto n = double(frontier.cells.size());
    double best = std::numeric_limits<double>::infinity();
    for (const Cell c : frontier.cells)
      if (const double squared = std::pow(c.i * n - x, 2) + std::pow(c.j * n - y, 2); squared < best) {
        best = squared;
        frontier.target = c;
      }
    frontiers.push_back(frontier);
  }
  return frontiers;
}

bool equal(const std::vector<Frontier>& a, const std::vector<Frontier>& b) {
  return std::ranges::equal(
      a, b, [](const Frontier& x, const Frontier& y) { return x.cells == y.cells && x.target == y.target; });
}

/// V7.3: rows from the top UUUUU / UOOOU / UOOO# / UOOO# / #####.
TEST(Frontiers, WorkedExample) {
  const DenseGrid<CellState> map = drawn_map({"?????", "?   ?", "?   #", "?   #", "#####"});
  const auto frontiers = find_frontiers(map, 1);
  ASSERT_EQ(frontiers.size(), 1U);
  // (row, column) from the top: (3,1) | (2,1) (2,3) | (1,1) (1,2) (1,3)
  EXPECT_EQ(frontiers[0].cells, (std::vector<Cell>{{1, 1}, {1, 2}, {3, 2}, {1, 3}, {2, 3}, {3, 3}}));
  EXPECT_EQ(frontiers[0].target, (Cell{2, 3})) << "centroid at column 11/6, 7/3 rows from below";
  EXPECT_EQ(find_frontiers(map, 6).size(), 1U);
  EXPECT_TRUE(find_frontiers(map, 7).empty());
}

TEST(Frontiers, RegionsJoinOverCorners) {
  EXPECT_EQ(find_frontiers(drawn_map({"#####", "# # #", "## ##", "#####"}), 1).size(), 0U) << "all is known";
  EXPECT_EQ(find_frontiers(drawn_map({"?????", "? # ?", "?# #?", "?????"}), 1).size(), 1U);
  const auto apart = find_frontiers(drawn_map({"?????", "? # ?", "?###?", "?????"}), 1);
  ASSERT_EQ(apart.size(), 2U);
  EXPECT_EQ(apart[0].target, (Cell{1, 2}));
  EXPECT_EQ(apart[1].target, (Cell{3, 2}));
}

TEST(Frontiers, BeyondTheMapIsUnknown) {
  EXPECT_EQ(find_frontiers(free_map(5, 4), 1).front().cells.size(), 14U);
  EXPECT_TRUE(find_frontiers(DenseGrid<CellState>{}, 1).empty());
  EXPECT_TRUE(find_frontiers(drawn_map({"###", "#?#", "###"}), 1).empty());
}

RC_GTEST_PROP(FrontiersProperty, EqualTheSlowForm, (std::uint64_t seed)) {
  Rng rng(seed);
  const DenseGrid<CellState> map = random_map(rng, 24);
  const auto least_cells = std::size_t(1 + rng.below(6));
  RC_ASSERT(equal(find_frontiers(map, least_cells), slow_frontiers(map, least_cells)));
}

RC_GTEST_PROP(FrontiersProperty, LookingAtWhatChangedIsEnough, (std::uint64_t seed)) {
  Rng rng(seed);
  DenseGrid<CellState> map = random_map(rng, 24);
  FrontierFinder finder(2);
  finder.update(map, map.box());
  for (int k = 0; k < 8; ++k) {
    finder.update(map, change_at_random(rng, map));
    RC_ASSERT(equal(finder.frontiers(), find_frontiers(map, 2)));
  }
  RC_ASSERT(equal(finder.frontiers(), slow_frontiers(map, 2)));
}

}  // namespace
}  // namespace echoarc::nav
