// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "echoarc/maps/grid_geometry.hpp"

namespace echoarc::nav {

/// A step to one of the 8 neighbours of a cell.
struct GridStep {
  std::int32_t di = 0;
  std::int32_t dj = 0;
  double length_cells = 1.0;
};

/// First those along rows and columns, then those across corners: step k >= 4 passes between the cells that the steps
/// `beside(k)` lead to.
inline constexpr std::array<GridStep, 8> grid_steps{{{1, 0, 1.0},
                                                     {0, 1, 1.0},
                                                     {-1, 0, 1.0},
                                                     {0, -1, 1.0},
                                                     {1, 1, std::numbers::sqrt2},
                                                     {-1, 1, std::numbers::sqrt2},
                                                     {-1, -1, std::numbers::sqrt2},
                                                     {1, -1, std::numbers::sqrt2}}};

[[nodiscard]] constexpr std::array<std::size_t, 2> beside(std::size_t k) {
  return {k - 4, (k - 3) % 4};
}

[[nodiscard]] constexpr Cell operator+(Cell c, const GridStep& step) {
  return {c.i + step.di, c.j + step.dj};
}

}  // namespace echoarc::nav
