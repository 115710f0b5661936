// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "server/plan_message.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "unit/server/json_schema.hpp"

namespace echoarc::server::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Value good(const std::string& text) {
  const Value message = Value::parse(text, nullptr, false);
  EXPECT_EQ(message_schema().message_fault("FromServer", message), "") << text.substr(0, 600);
  return message;
}

Vec2 place_of(const Value& place) {
  return {place[0].get<double>(), place[1].get<double>()};
}

/// A line that wanders, a point every 5 cm.
std::vector<Vec2> wandering(std::size_t points, double phase) {
  std::vector<Vec2> line;
  for (std::size_t k = 0; k < points; ++k) {
    const double x = 0.05 * static_cast<double>(k);
    line.push_back({x, 2.0 * std::sin(0.7 * x + phase)});
  }
  return line;
}

double distance_to_line_m(Vec2 place, const Value& line) {
  double least = infinite;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 a = place_of(line[k]);
    const Vec2 along = place_of(line[k + 1]) - a;
    const double share = std::clamp(dot(place - a, along) / squared_norm(along), 0.0, 1.0);
    least = std::min(least, norm(place - (a + share * along)));
  }
  return least;
}

TEST(PlanMessage, NothingIsPlanned) {
  const Value message = good(no_plan_message());
  EXPECT_EQ(message["strategy"], "");
  for (const char* list : {"nodes", "edges", "path"}) EXPECT_TRUE(message[list].empty()) << list;
  EXPECT_TRUE(message["estimate"].is_null());
}

TEST(PlanMessage, SaysWhatIsInMind) {
  nav::Sketch sketch;
  sketch.nodes = {{{1.00049, -2.0}, "meet"}, {{3.0, 4.0}, "goal"}};
  sketch.edges = {{{0.0, 0.0}, {1.0, 0.0}}, {{1.0, 0.0}, {1.0, 1.0}, {2.0, 1.0}}};
  sketch.path = {{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}, {1.0, 2.0}};
  sketch.estimate = nav::Sketch::Spread{{{1.0, 2.0}, radians(0.5)}, {0.3, 0.1}};
  const Value message = good(plan_message("gvg", sketch));
  EXPECT_EQ(message["strategy"], "gvg");
  EXPECT_EQ(message["nodes"][0], Value::parse(R"({"at":[1.0,-2.0],"kind":"meet"})")) << "in millimetres";
  EXPECT_EQ(message["edges"].size(), 2U);
  EXPECT_EQ(message["edges"][1].size(), 3U) << "corners stay";
  EXPECT_EQ(message["path"], Value::parse("[[0.0,0.0],[1.0,0.0],[1.0,2.0]]")) << "what lies on the line is left out";
  EXPECT_EQ(message["estimate"]["deviation_m"], Value::array({0.3, 0.1}));
  EXPECT_EQ(message["left_out"], 0);
}

TEST(PlanMessage, CoarserLinesStayWhereTheyWere) {
  nav::Sketch sketch;
  sketch.edges = {wandering(800, 0.0)};
  const Value message = good(plan_message("gvg", sketch));
  const Value& line = message["edges"][0];
  EXPECT_LT(line.size(), 400U);
  EXPECT_EQ(place_of(line.front()), sketch.edges[0].front());
  EXPECT_LT(norm(place_of(line.back()) - sketch.edges[0].back()), 0.001);
  for (const Vec2 place : sketch.edges[0]) EXPECT_LT(distance_to_line_m(place, line), 0.012);
}

TEST(PlanMessage, GraphOfAWholeTownFits) {
  nav::Sketch sketch;
  for (std::size_t k = 0; k < 300; ++k) sketch.edges.push_back(wandering(400, 0.1 * static_cast<double>(k)));
  for (std::size_t k = 0; k < 3000; ++k) sketch.nodes.push_back({{static_cast<double>(k), 0.0}, "meet"});
  sketch.path = wandering(20'000, 0.0);
  const std::string text = plan_message("gvg", sketch);
  const Value message = good(text);
  std::size_t points = 0;
  for (const Value& line : message["edges"]) points += line.size();
  EXPECT_LE(points, most_plan_points);
  EXPECT_GT(points, most_plan_points / 4);
  EXPECT_EQ(message["edges"].size(), 300U) << "coarser, but whole";
  EXPECT_LE(message["path"].size(), most_plan_points);
  EXPECT_EQ(message["nodes"].size(), most_plan_nodes);
  EXPECT_EQ(message["left_out"], 3000 - most_plan_nodes);
  EXPECT_LT(text.size(), 250'000U);
}

TEST(PlanMessage, WhatDoesNotFitIsCounted) {
  nav::Sketch sketch;
  for (std::size_t k = 0; k < 5000; ++k) {
    const double y = static_cast<double>(k);
    sketch.edges.push_back({{0.0, y}, {1.0, y}});
  }
  const Value message = good(plan_message("gvg", sketch));
  EXPECT_GT(message["edges"].size(), 0U);
  EXPECT_LE(2 * message["edges"].size(), most_plan_points);
  EXPECT_EQ(message["edges"].size() + message["left_out"].get<std::size_t>(), 5000U);
}

TEST(PlanMessage, WhatIsNoPlaceIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  nav::Sketch sketch;
  sketch.nodes = {{{nan, 0.0}, "meet"}, {{1.0, infinite}, "goal"}};
  sketch.edges = {{{0.0, 0.0}, {nan, 1.0}}, {{0.0, 0.0}, {infinite, 1.0}, {1.0, 1.0}}, {}};
  sketch.path = {{nan, nan}};
  sketch.estimate = nav::Sketch::Spread{{{nan, 0.0}, {}}, {0.1, 0.1}};
  const Value message = good(plan_message("a\xff", sketch));
  EXPECT_TRUE(message["nodes"].empty());
  EXPECT_EQ(message["edges"], Value::parse("[[[0.0,0.0],[1.0,1.0]]]"));
  EXPECT_TRUE(message["path"].empty());
  EXPECT_TRUE(message["estimate"].is_null());
  EXPECT_EQ(message["left_out"], 2);
}

}  // namespace
}  // namespace echoarc::server::test
