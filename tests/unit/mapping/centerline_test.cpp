// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/centerline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

TEST(Centerline, MarksTheLineOfSightAtTheRange) {
  Centerline method;
  InlineExecutor executor;
  Reading reading = test::monostatic_reading({{1.0, 2.0}, degrees(90.0)}, Echo{1.5});
  reading.ping = 42;
  reading.time_s = 3.5;
  reading.tx = reading.rx = 7;
  method.insert(std::span(&reading, 1), executor);
  ASSERT_EQ(method.map().size(), 1U);
  const MapPoint& point = method.map().points()[0];
  EXPECT_NEAR(point.position.x, 1.0, 1e-12);
  EXPECT_NEAR(point.position.y, 3.5, 1e-12);
  EXPECT_NEAR(point.bound_m, 2.0 * 1.5 * std::sin(degrees(25.0 / 4.0).rad()), 1e-12);  // [Silver04] E_s
  EXPECT_EQ(point.label, PointLabel::centerline);
  EXPECT_EQ(point.time_s, 3.5);
  EXPECT_EQ(point.sensor, 7U);
  ASSERT_EQ(method.map().support(point).size(), 1U);
  EXPECT_EQ(method.map().support(point)[0], 42U);
  EXPECT_TRUE(method.supports(reading, {1.0, 3.5}));
  EXPECT_FALSE(method.supports(reading, {1.0, 3.49}));
}

TEST(Centerline, MarksTheMiddleOfABistaticArc) {
  Reading reading = test::monostatic_reading({{0.0, 0.0}, degrees(90.0)}, Echo{1.0});
  reading.rx = 1;
  reading.T_world_rx.position = {0.09, 0.0};
  const Trace trace = Centerline().trace(reading);
  ASSERT_EQ(trace.points.size(), 1U);  // V1.7
  EXPECT_NEAR(trace.points[0].x, 0.045, 1e-12);
  EXPECT_NEAR(trace.points[0].y, 0.998987, 5e-7);
}

TEST(Centerline, ExportHoldsPointsAndTheirCells) {
  Centerline method(test::with_v53_grid<CenterlineOptions>());
  InlineExecutor executor;
  method.insert(test::v53_readings(), executor);
  const Result<MapExport> map = method.export_map();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->points.size(), 11U);
  EXPECT_EQ(map->states.height(), 1);
  EXPECT_EQ(map->states.width(), 51);
  EXPECT_EQ(map->states.at({0, 0}), CellState::occupied);
  EXPECT_EQ(map->states.at({1, 0}), CellState::unknown);
  EXPECT_NEAR(map->states.geometry().origin.y, 1.0, 1e-12);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(map->values));
}

TEST(Centerline, MemoryLimitIsCounted) {
  Centerline method({.max_memory_mib = 1});
  InlineExecutor executor;
  const std::vector<Reading> many(20000, test::monostatic_reading({}, Echo{1.0}));
  method.insert(many, executor);
  EXPECT_GT(method.counters().memory_limit, 0U);
  EXPECT_EQ(method.counters().used + method.counters().memory_limit, many.size());
  EXPECT_EQ(method.map().size(), method.counters().used);
}

}  // namespace
}  // namespace echoarc
