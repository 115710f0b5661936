// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>
#include <vector>

#include "echoarc/core/rng.hpp"
#include "echoarc/maps/dense_grid.hpp"

namespace echoarc::nav {

/// A map as it is drawn, the top row first: '#' occupied, ' ' or '.' free, '?' unknown.
inline DenseGrid<CellState> drawn_map(const std::vector<std::string_view>& rows, double cell_m = 0.1,
                                      Vec2 origin = {}) {
  const auto height = std::int32_t(rows.size());
  DenseGrid<CellState> map({cell_m, origin}, std::int32_t(rows.front().size()), height);
  for (std::int32_t j = 0; j < height; ++j)
    for (std::int32_t i = 0; i < map.width(); ++i) {
      const char c = rows[std::size_t(height - 1 - j)][std::size_t(i)];
      map.at({i, j}) = c == '#' ? CellState::occupied : c == '?' ? CellState::unknown : CellState::free;
    }
  return map;
}

inline DenseGrid<CellState> free_map(std::int32_t width, std::int32_t height, double cell_m = 0.1, Vec2 origin = {}) {
  return {{cell_m, origin}, width, height, CellState::free};
}

/// Occupied cells within the box of world coordinates.
inline void occupy(DenseGrid<CellState>& map, const Box& box, CellState state = CellState::occupied) {
  for (std::int32_t j = 0; j < map.height(); ++j)
    for (std::int32_t i = 0; i < map.width(); ++i)
      if (const Vec2 p = map.geometry().centre({i, j});
          p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y)
        map.at({i, j}) = state;
}

/// Rooms, pillars and unknown patches at random, with noise.
inline DenseGrid<CellState> random_map(Rng& rng, std::int32_t largest = 50) {
  const auto width = std::int32_t(1 + rng.below(std::uint64_t(largest)));
  const auto height = std::int32_t(1 + rng.below(std::uint64_t(largest)));
  DenseGrid<CellState> map = free_map(width, height, 0.1, {rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0)});
  const Vec2 origin = map.geometry().origin;
  const auto boxes = rng.below(8);
  for (std::uint64_t k = 0; k < boxes; ++k) {
    const Vec2 low = origin + Vec2{rng.uniform(0.0, 0.1 * width), rng.uniform(0.0, 0.1 * height)};
    const bool wall = rng.uniform() < 0.6;
    const Vec2 size = wall ? (rng.uniform() < 0.5 ? Vec2{rng.uniform(0.0, 3.0), 0.1} : Vec2{0.1, rng.uniform(0.0, 3.0)})
                           : Vec2{rng.uniform(0.0, 1.5), rng.uniform(0.0, 1.5)};
    occupy(map, {low, low + size}, rng.uniform() < 0.75 ? CellState::occupied : CellState::unknown);
  }
  const double noise = rng.uniform() < 0.5 ? 0.0 : rng.uniform(0.0, 0.02);
  for (CellState& state : map.values())
    if (rng.uniform() < noise) state = CellState(rng.below(3));
  return map;
}

inline Vec2 random_place(Rng& rng, const DenseGrid<CellState>& map) {
  const double cell_m = map.geometry().cell_m;
  return map.geometry().origin +
         cell_m * Vec2{rng.uniform(0.0, double(map.width())), rng.uniform(0.0, double(map.height()))};
}

/// Some cells of a random box set anew; the box.
inline CellBox change_at_random(Rng& rng, DenseGrid<CellState>& map) {
  const auto i = std::int32_t(rng.below(std::uint64_t(map.width())));
  const auto j = std::int32_t(rng.below(std::uint64_t(map.height())));
  const CellBox box{i, j, std::min(map.width(), i + 1 + std::int32_t(rng.below(12))),
                    std::min(map.height(), j + 1 + std::int32_t(rng.below(12)))};
  for (std::int32_t y = box.j_begin; y < box.j_end; ++y)
    for (std::int32_t x = box.i_begin; x < box.i_end; ++x)
      if (rng.uniform() < 0.3) map.at({x, y}) = CellState(rng.below(3));
  return box;
}

}  // namespace echoarc::nav
