// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/eval/reference.hpp"

namespace echoarc {

/// The distances up to which a map point is counted as right, metres.
inline constexpr std::array<double, 3> accuracy_distances_m = {0.05, 0.10, 0.20};

struct WallDistanceOptions {
  double coverage_distance_m = 0.10;
  double path_distance_m = 2.5;
  double thin_cell_m = 0.05;

  static constexpr auto fields() {
    return std::tuple{
        field(
            "coverage_distance_m", &WallDistanceOptions::coverage_distance_m,
            {.unit = "m", .min = 0.0, .max = 100.0, .doc = "a reference point with a map point this near is covered"}),
        field("path_distance_m", &WallDistanceOptions::path_distance_m,
              {.unit = "m", .min = 0.0, .max = 1000.0, .doc = "reference points further from every pose are left out"}),
        field("thin_cell_m", &WallDistanceOptions::thin_cell_m,
              {.unit = "m", .min = 0.001, .max = 10.0, .doc = "cells that keep one map point each"})};
  }
};

/// Two-way distance of map and reference. Shares are in 0..1 and NaN where there is nothing to divide by, as are the
/// distances of an empty map. A distance that exceeds a limit by rounding alone (`eps_length_m`) does not exceed it:
/// the centres of aligned cells are whole cells apart.
struct WallDistance {
  std::uint64_t points = 0;            ///< of the map
  std::array<double, 3> accuracy{};    ///< share of them within `accuracy_distances_m` of the reference
  double mean_m = 0.0;                 ///< of their distances to the reference
  double median_m = 0.0;               ///< see `median`
  double p95_m = 0.0;                  ///< see `percentile`
  std::uint64_t reference_points = 0;  ///< near the path
  std::uint64_t covered_points = 0;    ///< of those, with a map point near
  double coverage = 0.0;               ///< covered_points / reference_points
};

/// Once with every map point and once with one point per cell of `thin_cell_m`: dense clusters flatter the first.
struct TwoWayWallDistance {
  WallDistance all;
  WallDistance one_per_cell;
};

/// `path` holds the robot's positions; without any, no reference point is near the path and coverage is NaN. Requires
/// valid options (`validate`).
[[nodiscard]] TwoWayWallDistance wall_distance(const PointSet& map, const Reference& reference, const PointSet& path,
                                               const WallDistanceOptions& options = {});

}  // namespace echoarc
