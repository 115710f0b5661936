// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/features/feature.hpp"

namespace echoarc {

/// Lines through clusters of points, after MacKenzie and Dudek ([Silver04] 2.C names the idea alone; the steps are
/// those of docs/features.md).
struct ClusterLineOptions {
  double link_m = 0.20;
  int points_min = 5;
  double split_m = 0.08;
  double length_min_m = 0.15;
  Angle merge_angle = degrees(8.0);
  double merge_offset_m = 0.05;
  double merge_gap_m = 0.30;

  static constexpr auto fields() {
    using O = ClusterLineOptions;
    return std::tuple{
        field("link_m", &O::link_m,
              {.unit = "m", .min = 1e-3, .max = 100.0, .doc = "points this close belong to one cluster"}),
        field("points_min", &O::points_min,
              {.unit = "points", .min = 2, .max = 1000000, .doc = "fewer points make no line"}),
        field("split_m", &O::split_m,
              {.unit = "m", .min = 0.0, .max = 100.0, .doc = "a line with a point farther off is split there"}),
        field("length_min_m", &O::length_min_m,
              {.unit = "m", .min = 0.0, .max = 1000.0, .doc = "shorter lines are dropped"}),
        field("merge_angle_deg", &O::merge_angle,
              {.unit = "deg", .min = 0.0, .max = 90.0, .doc = "lines are joined that differ by less in direction"}),
        field("merge_offset_m", &O::merge_offset_m,
              {.unit = "m", .min = 0.0, .max = 100.0, .doc = "and by less beside each other"}),
        field("merge_gap_m", &O::merge_gap_m,
              {.unit = "m", .min = 0.0, .max = 100.0, .doc = "and by less between their ends"})};
  }
};

/// Number of the single-link cluster of every point: two points are in one when a chain of steps of at most \p link_m
/// joins them. Clusters are numbered in the order of their first points.
[[nodiscard]] std::vector<std::size_t> single_link_clusters(std::span<const Vec2> points, double link_m);

/// Cluster, fit by total least squares, split, drop, merge. Points that are not finite are left out.
[[nodiscard]] std::vector<Feature> cluster_lines(std::span<const Vec2> points, const ClusterLineOptions& options = {});

}  // namespace echoarc
