// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::test {

/// A map as it is drawn in a test, top row first: '#' occupied, '.' free, '?' unknown.
inline DenseGrid<CellState> drawn(std::initializer_list<std::string_view> rows, GridGeometry geometry = {}) {
  const auto height = static_cast<std::int32_t>(rows.size());
  DenseGrid<CellState> grid(geometry, static_cast<std::int32_t>(rows.begin()->size()), height);
  std::int32_t j = height;
  for (const std::string_view row : rows) {
    --j;
    for (std::int32_t i = 0; i < grid.width(); ++i) {
      const char c = row[static_cast<std::size_t>(i)];
      grid.at({i, j}) = c == '#' ? CellState::occupied : c == '.' ? CellState::free : CellState::unknown;
    }
  }
  return grid;
}

/// The reverse, for messages that show the map.
inline std::vector<std::string> drawing(const DenseGrid<CellState>& grid) {
  std::vector<std::string> rows;
  for (std::int32_t j = grid.height() - 1; j >= 0; --j) {
    std::string& row = rows.emplace_back();
    for (const CellState state : grid.row(j))
      row += state == CellState::occupied ? '#' : state == CellState::free ? '.' : '?';
  }
  return rows;
}

}  // namespace echoarc::test
