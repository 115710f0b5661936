// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/score_report.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "points.hpp"

namespace echoarc {
namespace {

using test::point_set;
using test::reference_of;

double value_of(const std::vector<ScoreRow>& table, const std::string& name) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const ScoreRow& r) { return r.name == name; });
  if (row == table.end()) {
    ADD_FAILURE() << "no row " << name;
    return -1.0;
  }
  return row->value;
}

TEST(ScoreReport, HasARowForEveryMeasurement) {
  ScoreRequest request;
  request.path = point_set({{0.5, 0.0}});
  request.directions = column_directions({1.0, {0.0, 0.0}}, 4, 4);
  const Reference wall = reference_of({{0.5, 1.0}, {1.5, 1.0}});
  const PointSet map = point_set({{0.5, 1.08}, {3.5, 1.0}});
  auto report = score(map, wall, request);
  ASSERT_TRUE(report) << report.error().message;
  report->timing = summarise(std::vector<Timing>{{0.5, 0.5, 1000}});
  const std::vector<ScoreRow> table = rows(*report);

  EXPECT_EQ(value_of(table, "reference_points"), 2.0);
  EXPECT_EQ(value_of(table, "points"), 2.0);
  EXPECT_NEAR(value_of(table, "mae"), 1.04, 1e-12);
  EXPECT_EQ(value_of(table, "accuracy_5cm"), 0.0);
  EXPECT_EQ(value_of(table, "accuracy_10cm"), 0.5);
  EXPECT_EQ(value_of(table, "coverage"), 0.5);
  EXPECT_EQ(value_of(table, "thinned_points"), 2.0);
  EXPECT_EQ(value_of(table, "cdr_full"), 0.5);
  EXPECT_EQ(value_of(table, "cdr_empty"), 0.5);
  EXPECT_EQ(value_of(table, "cdr_overall"), 0.5);
  EXPECT_NEAR(value_of(table, "cpu_per_reading"), 0.001, 1e-15);
  std::set<std::string> names;
  for (const ScoreRow& row : table) EXPECT_TRUE(names.insert(row.name).second) << row.name << " twice";
}

TEST(ScoreReport, LeavesOutWhatWasNotMeasured) {
  const auto report = score(point_set({{0.0, 0.0}}), reference_of({{0.0, 0.0}}), {});
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->correct_detection);
  for (const ScoreRow& row : rows(*report)) {
    EXPECT_NE(row.name.substr(0, 4), "cdr_");
    EXPECT_NE(row.name.substr(0, 4), "cpu_");
  }
}

TEST(ScoreReport, AsksDirectionsOfTheCellsAMapIsDrawnWith) {
  ScoreRequest request;
  request.directions = column_directions({1.0, {0.0, 0.0}}, 4, 4);
  const Reference wall = reference_of({{0.5, 1.0}, {1.5, 1.0}, {2.5, 1.0}, {3.5, 1.0}});
  const PointSet points = point_set({{0.5, 1.0}, {3.5, 1.5}});
  // What lies outside of the region, the fifth cell, has no part in the mean.
  const PointSet cells = point_set({{0.5, 1.0}, {1.5, 1.25}, {2.5, 1.25}, {3.5, 1.5}, {9.5, 1.0}});
  const auto report = score(points, wall, request, &cells);
  ASSERT_TRUE(report);
  EXPECT_EQ(value_of(rows(*report), "points"), 2.0);
  EXPECT_EQ(value_of(rows(*report), "mae"), 0.25);
  EXPECT_EQ(value_of(rows(*report), "cells_mae"), 0.25);
  EXPECT_EQ(value_of(rows(*report), "cdr_full"), 1.0);
  const auto points_alone = score(points, wall, request);
  ASSERT_TRUE(points_alone);
  EXPECT_EQ(value_of(rows(*points_alone), "cdr_full"), 0.5);
}

TEST(ScoreReport, SaysWhenATolerancePreventsComparison) {
  ScoreRequest request;
  request.directions = column_directions({1.0, {0.0, 0.0}}, 4, 4);
  request.detection_tolerance_m = 0.25;
  const auto report = score(point_set({{0.5, 0.5}}), reference_of({{0.5, 0.5}}), request);
  ASSERT_TRUE(report);
  for (const ScoreRow& row : rows(*report))
    if (row.name == "cdr_full") {
      EXPECT_NE(row.note.find("tolerance"), std::string::npos) << row.note;
    }
  request.detection_tolerance_m = -1.0;
  EXPECT_FALSE(score({}, reference_of({{0.5, 0.5}}), request));
}

TEST(ScoreReport, RefusesOptionsOutOfRange) {
  ScoreRequest request;
  request.wall_distance.thin_cell_m = 0.0;
  const auto report = score({}, reference_of({{0.5, 0.5}}), request);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().where, "thin_cell_m");
}

}  // namespace
}  // namespace echoarc
