// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// V5.3 of the method specification: pixel counts, MAE and CDR of simple maps of eleven arcs. The maps are made here by
// the definitions alone (every cell a densely sampled arc enters; sets of counts), so that a wrong score cannot hide
// behind a wrong method.

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "points.hpp"
#include "support/v53_scene.hpp"
#include "support/v53_scores.hpp"

namespace echoarc {
namespace {

using Counts = std::map<Cell, int>;

/// Number of arcs through each cell; arcs sampled every 0.01 mm.
Counts arc_map() {
  Counts counts;
  for (const Reading& reading : test::v53_readings()) {
    const Arc arc = *arc_of(reading);
    std::set<Cell> cells;
    constexpr int steps = 50'000;
    for (int k = 0; k <= steps; ++k)
      cells.insert(test::v53_geometry().cell_of(
          arc.point_at(arc.t_begin() + (arc.t_end() - arc.t_begin()) * (double(k) / steps))));
    for (const Cell cell : cells) ++counts[cell];
  }
  return counts;
}

std::vector<Cell> voted(const Counts& counts, int threshold) {
  std::vector<Cell> cells;
  for (const auto& [cell, count] : counts)
    if (count >= threshold) cells.push_back(cell);
  return cells;
}

/// Of each column the cells with its largest count; of several the lower middle one.
std::vector<Cell> directional_maximum(const Counts& counts, int threshold) {
  std::vector<Cell> cells;
  for (int i = 0; i < test::v53_region().i_end; ++i) {
    int largest = threshold;
    std::vector<Cell> maxima;
    for (const auto& [cell, count] : counts) {
      if (cell.i != i || count < largest) continue;
      if (count > largest) maxima.clear();
      largest = count;
      maxima.push_back(cell);
    }
    if (!maxima.empty()) cells.push_back(maxima[(maxima.size() - 1) / 2]);
  }
  return cells;
}

std::vector<Cell> centerline() {
  std::vector<Cell> cells;
  for (const Reading& reading : test::v53_readings())
    cells.push_back(test::v53_geometry().cell_of(arc_of(reading)->midpoint()));
  return cells;
}

PointSet centres(const std::vector<Cell>& cells) {
  const GridGeometry geometry = test::v53_geometry();
  std::vector<Vec2> points;
  for (const Cell cell : cells) points.push_back(geometry.centre(cell));
  return test::point_set(points, geometry.cell_m);
}

TEST(WorkedIntegration, TheArcMapIsAsStated) {
  const Counts counts = arc_map();
  int sum = 0;
  int largest = 0;
  for (const auto& [cell, count] : counts) {
    sum += count;
    largest = std::max(largest, count);
  }
  EXPECT_EQ(counts.size(), 251U);
  EXPECT_EQ(sum, 539);
  EXPECT_EQ(largest, 5);
  const auto at = [&](Cell cell) { return counts.contains(cell) ? counts.at(cell) : 0; };
  const std::vector<int> row_100 = {0, 0, 1, 3, 5, 5, 5, 5, 3, 1, 0, 0, 0};
  for (int k = 0; k <= 12; ++k) EXPECT_EQ(at({10 * k, 100}), row_100[std::size_t(k)]) << 10 * k;
  for (int k = 0; k < 3; ++k) EXPECT_EQ(at({30, 98 + k}), k + 1);
}

TEST(WorkedIntegration, ScoresOfEveryMethod) {
  const Counts counts = arc_map();
  test::expect_v53_scores(centres(centerline()), test::v53_pm);
  test::expect_v53_scores(centres(voted(counts, 1)), test::v53_vt1);
  test::expect_v53_scores(centres(voted(counts, 2)), test::v53_vt2);
  test::expect_v53_scores(centres(voted(counts, 4)), test::v53_vt4);
  test::expect_v53_scores(centres(directional_maximum(counts, 1)), test::v53_dm1);
  test::expect_v53_scores(centres(directional_maximum(counts, 2)), test::v53_dm2);
  test::expect_v53_scores(centres(directional_maximum(counts, 4)), test::v53_dm4);
}

}  // namespace
}  // namespace echoarc
