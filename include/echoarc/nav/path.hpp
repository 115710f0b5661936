// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/core/vec2.hpp"
#include "echoarc/maps/dense_grid.hpp"

/// Ways as lines of points in the world, m, and what they cost on a grid of cost per metre (CostMap), where 0 is a cell
/// in which the robot cannot be. Cells off the grid are such cells.
namespace echoarc::nav {

[[nodiscard]] double length_m(std::span<const Vec2> path);

/// Whether nothing occupied and nothing off the map lies on the straight way from `a` to `b`.
[[nodiscard]] bool in_sight(const DenseGrid<CellState>& map, Vec2 a, Vec2 b);

/// Cost of the straight way from `a` to `b`, each cell by the length within it; none if it touches a blocked cell. A
/// way through a corner of cells touches all four.
[[nodiscard]] std::optional<double> straight_cost(const DenseGrid<float>& cost_per_m, Vec2 a, Vec2 b);
/// Of all legs of a path.
[[nodiscard]] std::optional<double> path_cost(const DenseGrid<float>& cost_per_m, std::span<const Vec2> path);

/// Fewer points, by line of sight: what lies between two points goes if the straight way is clear and no dearer. Never
/// longer, never dearer than before. Looks at the most 8 m ahead of a point, so that the work grows with length alone.
[[nodiscard]] std::vector<Vec2> shortcut(const DenseGrid<float>& cost_per_m, std::span<const Vec2> path);

/// A place on a path.
struct PathPlace {
  std::size_t leg = 0;   ///< from point `leg` to the next
  double along_m = 0.0;  ///< from the path's start
  Vec2 place;
  double distance_m = 0.0;  ///< of the point that was asked for
};

/// The nearest place to `p` on the stretch of the path from `begin_m` to `end_m`; none for an empty path.
[[nodiscard]] std::optional<PathPlace> nearest_place(std::span<const Vec2> path, Vec2 p, double begin_m, double end_m);
/// So far from the path's start, held to the path; the path has a point.
[[nodiscard]] Vec2 point_at(std::span<const Vec2> path, double along_m);

}  // namespace echoarc::nav
