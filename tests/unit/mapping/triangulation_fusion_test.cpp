// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/mapping/triangulation_fusion.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "mapping/triangulation_hypotheses.hpp"
#include "support/v53_scene.hpp"

namespace echoarc {
namespace {

using test::monostatic_reading;

/// A sonar at `x` on the x axis that looks at the edge of V3.24.
Reading at_edge(double x, double range_m, PingId ping) {
  Reading reading = monostatic_reading({{x, 0.0}, bearing(Vec2{0.3, 1.5} - Vec2{x, 0.0})}, Echo{range_m});
  reading.ping = ping;
  reading.time_s = 0.1 * double(ping);
  return reading;
}

/// V3.24: oldest first.
std::vector<Reading> v324_readings() {
  return {at_edge(0.00, 1.530, 0), at_edge(0.20, 1.503, 1), at_edge(0.40, 1.503, 2), at_edge(0.45, 1.507, 3),
          at_edge(0.50, 1.513, 4)};
}

TriangulationFusion mapped(std::span<const Reading> readings, TriangulationOptions options = {}) {
  TriangulationFusion method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  return method;
}

TEST(TriangulationFusion, V323CirclesMeetInClosedForm) {
  const Reading a = monostatic_reading({{0.0, 0.0}, degrees(65.0)}, Echo{1.2});
  const Reading b = monostatic_reading({{0.25, 0.0}, degrees(70.0)}, Echo{1.1});
  const ArcMeetings met = meetings_of(WindowArc::of(a, 1.2), WindowArc::of(b, 1.1), 0.02);
  ASSERT_EQ(met.count, 1);
  EXPECT_NEAR(met.points[0].x, 0.5850, 1e-8);
  EXPECT_NEAR(met.points[0].y, 1.04774758, 5e-9);
  EXPECT_NEAR(bearing(met.points[0]).deg(), 60.823604, 5e-7);
  EXPECT_NEAR(bearing(met.points[0] - Vec2{0.25, 0.0}).deg(), 72.269181, 5e-7);
}

TEST(TriangulationFusion, V324FourTriangulationsMakeAnEdge) {
  const std::vector<Reading> readings = v324_readings();
  const TriangulationFusion before = mapped(std::span(readings).first(4));
  const auto found = before.triangulate(readings[4]);
  ASSERT_TRUE(found);
  constexpr std::array<Vec2, 4> expected{
      {{0.293800, 1.498883}, {0.299200, 1.499616}, {0.299733, 1.499687}, {0.301731, 1.499953}}};
  ASSERT_EQ(found->meetings.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(found->meetings[k].x, expected[k].x, 5e-7);
    EXPECT_NEAR(found->meetings[k].y, expected[k].y, 5e-7);
  }
  EXPECT_NEAR(found->position.x, 0.298616, 5e-7);
  EXPECT_NEAR(found->position.y, 1.499535, 5e-7);
  EXPECT_EQ(found->successes, 4);
  EXPECT_NEAR(found->max_deviation_m, 0.004860, 5e-7);
  EXPECT_TRUE(found->edge);
  EXPECT_EQ(found->support, (std::vector<PingId>{3, 2, 1, 0}));
}

TEST(TriangulationFusion, APointKnowsItsPingsLabelAndBound) {
  const std::vector<Reading> readings = v324_readings();
  const TriangulationFusion method = mapped(readings, {.threshold = 4});
  ASSERT_EQ(method.map().size(), 1U);
  const MapPoint& point = method.map().points()[0];
  EXPECT_EQ(point.label, PointLabel::edge);
  EXPECT_EQ(point.ping, 4U);
  const auto support = method.map().support(point);
  EXPECT_EQ(std::vector(support.begin(), support.end()), (std::vector<PingId>{4, 3, 2, 1, 0}));
  EXPECT_GE(point.bound_m, norm(point.position - Vec2{0.3, 1.5}));
  EXPECT_NEAR(point.bound_m, 2.0 * 1.513 * std::sin(degrees(6.25).rad()), 0.01);  // the whole arc lies within
  for (const Reading& reading : readings) EXPECT_TRUE(method.supports(reading, point.position));
  EXPECT_FALSE(method.supports(readings[0], {1.3, 1.5}));
}

TEST(TriangulationFusion, AWallIsTriangulatedButNoEdge) {
  std::vector<Reading> readings;
  for (int k = 0; k < 10; ++k) {
    readings.push_back(monostatic_reading({{0.06 * k, 0.0}, degrees(90.0)}, Echo{1.5}));
    readings.back().ping = PingId(k);
  }
  const TriangulationFusion all = mapped(readings, {.threshold = 8});
  ASSERT_EQ(all.map().size(), 2U);
  EXPECT_EQ(all.map().points()[1].label, PointLabel::triangulated);
  EXPECT_EQ(all.counters().used, 10U);
  EXPECT_TRUE(mapped(readings, {.threshold = 8, .show = TriangulationShow::edges}).map().empty());
  EXPECT_EQ(mapped(readings, {.threshold = 8, .edge_m = 0.2}).map().points()[1].label, PointLabel::edge);
}

TEST(TriangulationFusion, TheWindowForgets) {
  std::vector<Reading> readings = v324_readings();
  EXPECT_EQ(mapped(readings, {.threshold = 1, .columns = 1}).map().size(), 0U);
  const auto two = mapped(readings, {.threshold = 1, .columns = 2, .column_m = 0.01});
  ASSERT_EQ(two.map().size(), 4U);
  EXPECT_EQ(two.map().points()[3].support_count, 2U);
}

TEST(TriangulationFusion, MedianAndRefinementStayAtTheEdge) {
  const std::vector<Reading> readings = v324_readings();
  for (const TriangulationOptions& options :
       {TriangulationOptions{.threshold = 4, .position = TriangulationPosition::median},
        TriangulationOptions{.threshold = 4, .refine = true}}) {
    const TriangulationFusion method = mapped(readings, options);
    ASSERT_EQ(method.map().size(), 1U);
    EXPECT_LT(norm(method.map().points()[0].position - Vec2{0.3, 1.5}), 0.005);
  }
}

TEST(TriangulationFusion, SecondHypothesisCanWin) {
  TriangulationHypotheses hypotheses(0.25, 3);
  const WindowArc other = WindowArc::of(v324_readings()[0], 1.53);
  EXPECT_EQ(hypotheses.best(), nullptr);
  hypotheses.add({0.0, 0.0}, other);
  for (const double x : {1.0, 1.1, 1.2}) hypotheses.add({x, 0.0}, other);
  hypotheses.add({2.0, 0.0}, other);
  hypotheses.add({3.0, 0.0}, other);  // no room for a fourth
  ASSERT_NE(hypotheses.best(), nullptr);
  EXPECT_EQ(hypotheses.best()->meetings.size(), 3U);
  EXPECT_NEAR(hypotheses.best()->mean().x, 1.1, 1e-12);
  EXPECT_NEAR(hypotheses.best()->max_deviation_m(), 0.1, 1e-12);
}

TEST(TriangulationFusion, TiesGoToTheSharperThenTheOlder) {
  const WindowArc other = WindowArc::of(v324_readings()[0], 1.53);
  TriangulationHypotheses sharper(0.25, 3);
  for (const double x : {0.0, 0.2, 1.0, 1.1}) sharper.add({x, 0.0}, other);
  EXPECT_NEAR(sharper.best()->mean().x, 1.05, 1e-12);
  TriangulationHypotheses older(0.25, 3);
  for (const double x : {0.0, 0.125, 1.0, 1.125}) older.add({x, 0.0}, other);
  EXPECT_NEAR(older.best()->mean().x, 0.0625, 1e-12);
}

TEST(TriangulationFusion, OfTwoMeetingsTheOneNearerTheAxesOrTheHypothesis) {
  const WindowArc a = WindowArc::of(monostatic_reading({{0.0, 0.0}, degrees(91.0)}, Echo{1.0}, degrees(60.0)), 1.0);
  const WindowArc b = WindowArc::of(monostatic_reading({{0.0, 0.5}, degrees(91.0)}, Echo{0.55}, degrees(120.0)), 0.55);
  const ArcMeetings met = meetings_of(a, b, 0.02);  // V3.10, the pair that meets twice
  ASSERT_EQ(met.count, 2);
  TriangulationHypotheses hypotheses(0.25, 3);
  EXPECT_NEAR(hypotheses.choose(met, a, b).x, -0.31975577, 5e-9);
  hypotheses.add({0.5, 0.9}, a);
  EXPECT_NEAR(hypotheses.choose(met, a, b).x, 0.31975577, 5e-9);
}

TEST(TriangulationFusion, BistaticFarAndRepeatedReadingsAreCounted) {
  std::vector<Reading> readings = v324_readings();
  readings.push_back(readings.back());  // the robot stands still
  readings.push_back(readings.back());
  readings.back().rx = 1;
  readings.push_back(at_edge(0.6, 5.1, 7));
  readings.push_back(at_edge(0.6, 1.0, 8));
  readings.back().outcome = NoEcho{};
  const TriangulationFusion method = mapped(readings);
  EXPECT_EQ(method.counters(), (InsertCounters{.used = 5, .no_information = 1, .bistatic = 1, .passed_over = 2}));
}

TEST(TriangulationFusion, HostileReadingsAreCountedOutInBoundedMemory) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Reading> readings;
  for (const double range_m : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()})
    readings.push_back(at_edge(0.0, range_m, 0));
  for (const double beam_deg : {0.0, 180.0, 1e9}) {
    readings.push_back(at_edge(0.0, 1.0, 0));
    readings.back().beam_width = degrees(beam_deg);
  }
  readings.push_back(at_edge(0.0, 1.0, 0));
  readings.back().T_world_tx.position.x = infinity;
  const TriangulationFusion method = mapped(readings, {.threshold = 1});
  EXPECT_EQ(method.counters().no_arc, readings.size());
  EXPECT_TRUE(method.map().empty());
}

TEST(TriangulationFusion, StandingStillConcentricArcsAndJumpsGiveNothing) {
  const std::vector<Reading> still(100000, at_edge(0.5, 1.5, 0));
  const TriangulationFusion one = mapped(still, {.threshold = 1});
  EXPECT_EQ(one.counters().used, 1U);
  EXPECT_TRUE(one.map().empty());
  std::vector<Reading> turning;  // concentric
  for (int k = 0; k < 1000; ++k) turning.push_back(monostatic_reading({{1.0, 1.0}, degrees(6.0 * k)}, Echo{1.5}));
  EXPECT_TRUE(mapped(turning, {.threshold = 1}).map().empty());
  std::vector<Reading> jumping;
  for (int k = 0; k < 1000; ++k) jumping.push_back(monostatic_reading({{100.0 * k, 0.0}, degrees(90.0)}, Echo{4.9}));
  EXPECT_TRUE(mapped(jumping, {.threshold = 1}).map().empty());
  EXPECT_EQ(mapped(jumping).counters().used, 1000U);
}

TEST(TriangulationFusion, TouchingCirclesDoNotMeet) {
  const WindowArc a = WindowArc::of(monostatic_reading({{0.0, 0.0}, {}}, Echo{1.0}), 1.0);
  const WindowArc inside = WindowArc::of(monostatic_reading({{0.5, 0.0}, {}}, Echo{0.5}), 0.5);
  const WindowArc against = WindowArc::of(monostatic_reading({{2.0, 0.0}, degrees(180.0)}, Echo{1.0}), 1.0);
  EXPECT_EQ(meetings_of(a, inside, 0.02).count, 0);
  EXPECT_EQ(meetings_of(a, against, 0.02).count, 0);
  EXPECT_EQ(meetings_of(a, a, 0.0).count, 0);
}

TEST(TriangulationFusion, DamagedStatesAreRefused) {
  const std::vector<std::byte> good = mapped(v324_readings(), {.threshold = 1}).save();
  ASSERT_TRUE(TriangulationFusion::restore(good));
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_FALSE(TriangulationFusion::restore(std::span(good).first(length))) << length;
  for (std::size_t k = 0; k < good.size(); ++k) {
    std::vector<std::byte> bad = good;
    bad[k] = std::byte{0xff};
    (void)TriangulationFusion::restore(bad);  // refused or not, it must not read or allocate beyond the bytes
  }
}

}  // namespace
}  // namespace echoarc
