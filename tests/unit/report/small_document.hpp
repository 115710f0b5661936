// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>

#include "report/report_document.hpp"

namespace echoarc::report::test {

/// Everything a report may hold, with text that HTML and JSON have to escape.
inline ReportDocument small_document() {
  using namespace studies;
  StudySection section;
  section.id = "part";
  section.title = "Part <1> & \"more\"";
  section.paragraphs = {"A < B, that's it."};
  section.claims = {{"c1", "DM < VT", "3.8", Verdict::holds, 3, 2, "1 cm against 2 cm"},
                    {"c2", "MP < BU", "", Verdict::fails, 3, 0, ""},
                    {"c3", "PM < TBF", "", Verdict::undecided, 0, 0, ""}};
  StudyTable rows{.id = "T1", .title = "Rows", .note = "A note.", .rows = {}};
  rows.rows.push_back({"MAE", "VT", "cm", 2.5, "", {2.0, 0.1, 1.9, 2.1, 3, 3}, 2, "near"});
  rows.rows.push_back({"gap", "PM", "m", std::numeric_limits<double>::quiet_NaN(), "> 20 %", {}, 1, ""});
  StudyTable matrix = rows;
  matrix.layout = TableLayout::matrix;
  section.tables = {rows, matrix};
  section.charts = {{"chart", "A chart.", Chart{.title = "t", .series = {{.name = "s", .x = {0, 1}, .y = {1, 2}}}}}};
  section.pictures = {{"picture", "A map.", Image{2, 1, {255, 0, 0, 0, 0, 255}}}};
  section.remarks = {"The end."};
  StudyReport study{.name = "paper", .title = "Title", .source = "Journal", .seeds = 3, .summary = {"Short."}};
  study.sections = {section};
  return {"1.2.3", "echoarc reproduce paper", {study}};
}

}  // namespace echoarc::report::test
