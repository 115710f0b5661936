// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace echoarc::studies {

/// A table of plain text, for whatever shows it: a page, a terminal, Markdown.
struct TextTable {
  std::string id;  ///< short and unique within a report: file name and anchor
  std::string title;
  std::string note;  ///< a sentence or two below, may be empty
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as the head has
  std::size_t words = 1;                       ///< columns from the left that hold words, not numbers
};

}  // namespace echoarc::studies
