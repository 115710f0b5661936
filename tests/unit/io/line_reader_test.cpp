// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/line_reader.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "log_text.hpp"

namespace echoarc::io {
namespace {

std::vector<std::string> lines_of(ByteSource& source, const ReadLimits& limits = {}) {
  LineReader reader(source, limits);
  std::vector<std::string> lines;
  while (reader.next()) {
    EXPECT_EQ(reader.line().number, lines.size() + 1);
    lines.emplace_back(reader.line().too_long ? "<too long>" : reader.line().text);
  }
  EXPECT_FALSE(reader.failure());
  return lines;
}

std::vector<std::string> lines_of(std::string_view text, const ReadLimits& limits = {}) {
  MemorySource source(text);
  return lines_of(source, limits);
}

TEST(LineReader, CutsAtLineFeeds) {
  EXPECT_EQ(lines_of("a\n\nbc\n"), (std::vector<std::string>{"a", "", "bc"}));
  EXPECT_EQ(lines_of("a\r\nb"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(lines_of("\xEF\xBB\xBFt,x\n"), (std::vector<std::string>{"t,x"}));
  EXPECT_EQ(lines_of(""), std::vector<std::string>{});
}

TEST(LineReader, SaysWhenTheLastLineIsCutOff) {
  MemorySource source("a\nb");
  LineReader reader(source);
  ASSERT_TRUE(reader.next());
  EXPECT_TRUE(reader.line().terminated);
  ASSERT_TRUE(reader.next());
  EXPECT_FALSE(reader.line().terminated);
  EXPECT_FALSE(reader.next());
}

TEST(LineReader, SkipsLinesOverTheLimitWithoutKeepingThem) {
  const ReadLimits limits{.line_bytes = 4};
  EXPECT_EQ(lines_of("1234\n12345\n12\n", limits), (std::vector<std::string>{"1234", "<too long>", "12"}));
  EXPECT_EQ(lines_of(std::string(3'000'000, 'x') + "\nend\n", limits), (std::vector<std::string>{"<too long>", "end"}));
  EXPECT_EQ(lines_of(std::string(3'000'000, 'x'), limits), (std::vector<std::string>{"<too long>"}));
}

TEST(LineReader, LinesLongerThanABlockStayWhole) {
  const std::string line(1'000'000, 'y');
  EXPECT_EQ(lines_of("a\n" + line + "\nb\n"), (std::vector<std::string>{"a", line, "b"}));
}

TEST(LineReader, StopsAtTheInputLimit) {
  MemorySource source(std::string_view("a\nb\nc\n"), "endless.log");
  LineReader reader(source, {.input_bytes = 3});
  while (reader.next()) {
  }
  ASSERT_TRUE(reader.failure());
  EXPECT_EQ(reader.failure()->code, ErrorCode::too_large);
  EXPECT_EQ(reader.failure()->where, "endless.log:1");
}

RC_GTEST_PROP(LineReader, BlocksOfAnySizeGiveTheSameLines, (const std::vector<std::string>& parts)) {
  std::string text;
  for (const std::string& part : parts) text += part + (part.size() % 2 == 0 ? "\n" : "\r\n");
  const auto block = *rc::gen::inRange<std::size_t>(1, 20);
  TricklingSource trickle(text, block);
  RC_ASSERT(lines_of(trickle) == lines_of(text));
}

}  // namespace
}  // namespace echoarc::io
