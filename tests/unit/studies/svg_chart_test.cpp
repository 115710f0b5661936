// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/svg_chart.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

constexpr double nan_m = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Chart simple() {
  return {.title = "errors",
          .x = {.title = "threshold (arcs)"},
          .y = {.title = "MAE (cm)"},
          .series = {{.name = "vt", .x = {1, 2, 3}, .y = {14.8, 7.0, 4.6}},
                     {.name = "dm", .x = {1, 2, 3}, .y = {5.6, 3.1, 2.8}, .mark = ChartMark::both}}};
}

TEST(SvgChart, NamesAxesSeriesAndTitle) {
  const std::string text = svg(simple());
  for (const char* part : {"threshold (arcs)", "MAE (cm)", ">vt<", ">dm<", ">errors<", "</svg>\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(text.rfind("<svg ", 0), 0U);
}

TEST(SvgChart, PlacesValuesBetweenMarkedEnds) {
  // The y axis runs from 2 or less to 15 or more: 0 and 15 are marked.
  const std::string text = svg(simple());
  EXPECT_NE(text.find(">15.0<"), std::string::npos);
  EXPECT_NE(text.find(">2.5<"), std::string::npos);
  EXPECT_EQ(count(text, "<circle") + count(text, "<rect"), 1U + 4U);  // background; three markers and the legend's
}

TEST(SvgChart, LeavesAGapWhereAValueIsMissing) {
  Chart chart = simple();
  chart.series = {{.name = "a", .x = {0, 1, 2, 3}, .y = {1, nan_m, 2, 3}}};
  const std::string text = svg(chart);
  const std::size_t path = text.find("<path d=\"");
  const std::string line = text.substr(path, text.find("fill", path) - path);
  EXPECT_EQ(count(line, "M"), 2U);
  EXPECT_EQ(count(line, "L"), 1U);
}

TEST(SvgChart, EscapesText) {
  Chart chart = simple();
  chart.title = "a < b & \"c\"\n";
  EXPECT_NE(svg(chart).find(">a &lt; b &amp; &quot;c&quot;<"), std::string::npos);
}

TEST(SvgChart, SaysWhenThereIsNothing) {
  Chart chart = simple();
  chart.series.clear();
  EXPECT_NE(svg(chart).find("no values"), std::string::npos);
  chart.series = {{.name = "a", .x = {1}, .y = {nan_m}}};
  EXPECT_NE(svg(chart).find("no values"), std::string::npos);
}

TEST(SvgChart, StaysSmallOnHostileValues) {
  Chart chart = simple();
  chart.series = {{.name = "a", .x = {-1e308, 1e308}, .y = {1e300, -1e300}}, {.name = "b", .x = {1e-300}, .y = {5}}};
  EXPECT_LT(svg(chart).size(), 20'000U);
  chart.y.logarithmic = true;
  chart.x.logarithmic = true;
  EXPECT_LT(svg(chart).size(), 20'000U);
  chart.y = {.title = "", .low = 3.0, .high = 1.0};
  EXPECT_LT(svg(chart).size(), 20'000U);
}

TEST(SvgChart, BarsStandOnZeroSideBySide) {
  Chart chart = simple();
  chart.categories = {"curve", "room"};
  chart.series = {{.name = "paper", .x = {0, 1}, .y = {1, 2}, .mark = ChartMark::bar},
                  {.name = "ours", .x = {0, 1}, .y = {2, 4}, .low = {1, 3}, .high = {3, 5}, .mark = ChartMark::bar}};
  const std::string text = svg(chart);
  EXPECT_EQ(count(text, "<rect"), 1U + 4U + 2U);  // background, bars, legend
  EXPECT_NE(text.find(">curve<"), std::string::npos);
  EXPECT_NE(text.find(">0<"), std::string::npos);
}

}  // namespace
}  // namespace echoarc::studies
