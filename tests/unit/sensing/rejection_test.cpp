// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/rejection.hpp"

#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

TEST(Rejection, EveryReasonHasItsRow) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < rejection_count; ++i) {
    const RejectionInfo& row = rejections()[i];
    EXPECT_EQ(row.reason, static_cast<Rejection>(i)) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.explanation.empty()) << row.name;
    EXPECT_TRUE(row.remedy.ends_with('.')) << row.name;
  }
}

TEST(Rejection, CountersKeepTheFirst) {
  RejectionCounters counters;
  counters.add(Rejection::no_pose, 12, 5, 1.5);
  counters.add(Rejection::no_pose, 13, 6, 1.6);
  counters.add(Rejection::invalid, 14, 7, 0.0);
  EXPECT_EQ(counters[Rejection::no_pose].count, 2U);
  EXPECT_EQ(counters[Rejection::no_pose].first_line, 12U);
  EXPECT_EQ(counters[Rejection::no_pose].first_index, 5U);
  EXPECT_EQ(counters[Rejection::no_pose].first_value, 1.5);
  EXPECT_EQ(counters[Rejection::bad_pose].count, 0U);
  EXPECT_EQ(counters.total(), 3U);
}

TEST(Rejection, DescriptionNamesCountPlaceValueAndRemedy) {
  RejectionCounters counters;
  counters.add(Rejection::implausible_range, 12, 5, 5110.0);
  EXPECT_EQ(describe(Rejection::implausible_range, counters[Rejection::implausible_range], "ping"),
            "implausible_range: 1 ping, first at line 12 (5110 m): the range is more than twice the sensor's maximum. "
            "Check the unit of the ranges: millimetres or centimetres read as metres look like this.");
  counters.add(Rejection::no_pose, 0, 5, 3.25);
  counters.add(Rejection::no_pose, 0, 6, 3.5);
  const std::string text = describe(Rejection::no_pose, counters[Rejection::no_pose], "ping");
  EXPECT_NE(text.find("2 pings, first at record 6 (t = 3.25 s)"), std::string::npos) << text;
}

// The table of docs/no-echo.md is written for people; it must say what the program says.
TEST(Rejection, DocsListEveryReasonAsTheProgramStatesIt) {
  std::ifstream file(ECHOARC_SOURCE_DIR "/docs/no-echo.md");
  ASSERT_TRUE(file) << "docs/no-echo.md is missing";
  std::vector<std::string> rows;
  bool in_table = false;
  for (std::string line; std::getline(file, line);) {
    in_table = line == "| reason | what was wrong | what to do |" || (in_table && line.starts_with('|'));
    if (in_table && line.starts_with("| `")) rows.push_back(line);
  }
  std::vector<std::string> expected;
  for (const RejectionInfo& row : rejections())
    expected.push_back("| `" + std::string(row.name) + "` | " + std::string(row.explanation) + " | " +
                       std::string(row.remedy) + " |");
  EXPECT_EQ(rows, expected);
}

}  // namespace
}  // namespace echoarc
