// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// V5.3 of the method specification: pixel counts, MAE and CDR of simple maps of eleven arcs. The maps are made here by
// the definitions alone (every cell a densely sampled arc enters; sets of counts), so that a wrong score cannot hide
// behind a wrong method.

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/correct_detection.hpp"
#include "echoarc/eval/mean_absolute_error.hpp"
#include "points.hpp"
#include "support/v53_scene.hpp"

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

void expect_row(const char* method, const std::vector<Cell>& cells, std::size_t pixels, double mae_cm, double cdr_full,
                double cdr_empty, double cdr_overall) {
  const GridGeometry geometry = test::v53_geometry();
  std::vector<Vec2> centres;
  for (const Cell cell : cells) centres.push_back(geometry.centre(cell));
  const PointSet map = test::point_set(centres, geometry.cell_m);
  const Reference reference = test::reference_of(test::v53_reference());
  const DirectionSet columns = column_directions(geometry, test::v53_region().i_end, test::v53_region().j_end);
  const auto score = correct_detection(map, reference, columns);
  ASSERT_TRUE(score);
  EXPECT_EQ(map.size(), pixels) << method;
  EXPECT_EQ(score->full, 53U);
  EXPECT_EQ(score->empty, 68U);
  EXPECT_NEAR(100.0 * mean_absolute_error_m(map, reference), mae_cm, std::max(1e-4 * mae_cm, 0.5e-4)) << method;
  EXPECT_NEAR(score->full_ratio(), cdr_full, 1e-4) << method;
  EXPECT_NEAR(score->empty_ratio(), cdr_empty, 1e-4) << method;
  EXPECT_NEAR(score->overall_ratio(), cdr_overall, 1e-4) << method;
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
  expect_row("PM", centerline(), 11, 0.1000, 0.2075, 1.0000, 0.6529);
  expect_row("VT1", voted(counts, 1), 251, 4.0048, 1.0000, 0.3824, 0.6529);
  expect_row("DM1", directional_maximum(counts, 1), 95, 4.9956, 1.0000, 0.3824, 0.6529);
  expect_row("VT2", voted(counts, 2), 151, 1.8726, 1.0000, 0.7059, 0.8347);
  expect_row("DM2", directional_maximum(counts, 2), 73, 1.9735, 1.0000, 0.7059, 0.8347);
  expect_row("VT4", voted(counts, 4), 46, 0.1984, 0.7736, 1.0000, 0.9008);
  expect_row("DM4", directional_maximum(counts, 4), 41, 0.1000, 0.7736, 1.0000, 0.9008);
}

}  // namespace
}  // namespace echoarc
