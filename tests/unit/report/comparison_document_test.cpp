// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/comparison_document.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/text_tables.hpp"

namespace echoarc::report {
namespace {

using Json = nlohmann::json;

/// One log, two methods, one of which claims something.
ComparisonDocument small_document() {
  studies::Comparison comparison;
  comparison.seeds = 1;
  comparison.methods = {{"a < b", "centerline", {}}, {std::string(studies::default_consensus), "consensus", {}}};
  studies::ComparedPlace place;
  place.name = "run 1";
  place.provenance = "laser & odometry";
  studies::ComparedMap map;
  map.distance.all.points = 3;
  map.distance.all.accuracy = {0.1, 0.5, 1.0};
  map.distance.all.coverage = std::nan("");
  place.maps = {{map}, {map}};
  place.maps[1].front().claims = {{PointLabel::wall, 0.8, 0.1, 0.05}};
  place.picture = studies::PictureFigure{"run-1", "two maps", {2, 1, {0, 0, 0, 255, 255, 255}}};
  comparison.places = {place};
  return {"1.0", "echoarc compare", comparison};
}

TEST(ComparisonDocument, FilesAreAllThere) {
  const auto files = comparison_files(small_document());
  ASSERT_TRUE(files);
  for (const char* path : {"comparison.json", "comparison.html", "tables/scores-run-1.md", "tables/command.md",
                           "tables/overview.md", "pictures/run-1.png", "pictures/calibration-p-consensus-balanced.svg"})
    EXPECT_NE(std::ranges::find(*files, path, &ReportFile::path), files->end()) << path;
}

TEST(ComparisonDocument, PageStandsAlone) {
  const auto page = comparison_page(small_document());
  ASSERT_TRUE(page);
  EXPECT_TRUE(page->starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page->find("a &lt; b"), std::string::npos);
  EXPECT_NE(page->find("laser &amp; odometry"), std::string::npos);
  EXPECT_NE(page->find("<svg"), std::string::npos);
  EXPECT_NE(page->find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(page->find("<script"), std::string::npos);
  EXPECT_EQ(page->find("src=\"http"), std::string::npos);
  EXPECT_EQ(page->find("nan"), std::string::npos);
}

TEST(ComparisonDocument, JsonHoldsScoresAndCalibration) {
  const Json json = Json::parse(comparison_json(small_document()));
  const Json& methods = json["places"][0]["methods"];
  EXPECT_EQ(methods["a < b"]["every_point"]["accuracy_10cm"], 0.5);
  EXPECT_TRUE(methods["a < b"]["every_point"]["coverage"].is_null());
  EXPECT_FALSE(methods["a < b"].contains("calibration"));
  EXPECT_EQ(methods["consensus balanced"]["calibration"]["labels"]["wall"]["bound_held"]["share"], 1.0);
  EXPECT_EQ(json["calibration"]["consensus balanced"]["logs"]["points"], 1);
}

TEST(TextTables, AreEscaped) {
  const studies::TextTable table{.id = "t", .title = "", .note = "n & m", .head = {"a", "b"}, .rows = {{"x|y", "<1"}}};
  EXPECT_EQ(markdown_table(table), "| a | b |\n| --- | ---: |\n| x\\|y | <1 |\n");
  EXPECT_NE(html_table(table).find("<td class=\"n\">&lt;1</td>"), std::string::npos);
  EXPECT_NE(html_table(table).find("n &amp; m"), std::string::npos);
}

}  // namespace
}  // namespace echoarc::report
