// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/free_cells.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

// Cells as drawn, the highest row first: # occupied, . free, ? unknown.
std::vector<std::string> drawn(const DenseGrid<CellState>& grid) {
  std::vector<std::string> rows;
  for (std::int32_t j = grid.height() - 1; j >= 0; --j) {
    std::string row;
    for (const CellState state : grid.row(j)) row += "?.#"[std::size_t(state)];
    rows.push_back(row);
  }
  return rows;
}

DenseGrid<CellState> grid_of(const std::vector<std::string_view>& rows, Vec2 origin = {}) {
  DenseGrid<CellState> grid({1.0, origin}, std::int32_t(rows.front().size()), std::int32_t(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t i = 0; i < rows[k].size(); ++i)
      grid.at({std::int32_t(i), std::int32_t(rows.size() - 1 - k)}) =
          CellState(std::string_view("?.#").find(rows[k][i]));
  return grid;
}

TEST(FreeCells, TruthIsWhatCanBeReached) {
  // A diagonal wall from the lower left to the upper right; steps of half a cell.
  std::vector<Vec2> wall;
  for (double x = 0.1; x < 4.0; x += 0.5) wall.push_back({x, x});
  EXPECT_EQ(drawn(true_states(wall, {1.0, {}}, 4, 4, {3.5, 0.5})),
            (std::vector<std::string>{"???#", "??#.", "?#..", "#..."}));
  EXPECT_EQ(drawn(true_states(wall, {1.0, {}}, 4, 4, {1.5, 1.5})),
            (std::vector<std::string>{"???#", "??#?", "?#??", "#???"}))
      << "starts on the wall";
}

TEST(FreeCells, CountsWhatIsWronglyFree) {
  const auto truth = grid_of({"####?", "#..#?", "#..#?", "####?"});
  const auto map = grid_of({".?##.", "#...?", "#..??", "####?"});
  const FreeCells count = count_free_cells(map, truth);
  EXPECT_EQ(count.free, 7U);
  EXPECT_EQ(count.true_free, 4U);
  EXPECT_EQ(count.on_surface, 2U);
  EXPECT_EQ(count.behind, 1U);
  EXPECT_EQ(count.false_free(), 3U);
  EXPECT_EQ(count.reachable, 4U);
  EXPECT_EQ(count.cell_area_m2, 1.0);
}

TEST(FreeCells, CellsOutsideTheTruthAreBehind) {
  const FreeCells count = count_free_cells(grid_of({".."}, {10.0, 0.0}), grid_of({".."}));
  EXPECT_EQ(count.behind, 2U);
  EXPECT_EQ(count_free_cells(DenseGrid<CellState>{}, grid_of({".."})).free, 0U);
}

}  // namespace
}  // namespace echoarc
