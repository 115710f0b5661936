// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "cli/table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace echoarc::cli {
namespace {

/// Characters a terminal shows: bytes that do not continue a UTF-8 sequence.
std::size_t shown_width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & '\xc0') != '\x80'; }));
}

}  // namespace

std::string Table::text(std::string_view indent) const {
  std::vector<std::size_t> width(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], shown_width(row[c]));
  std::string all;
  for (const auto& row : rows_) {
    std::string line(indent);
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blank(width[c] - shown_width(row[c]), ' ');
      const bool left = c == 0 || std::ranges::find(words_, c) != words_.end();
      line += (c > 0 ? "  " : "") + (left ? row[c] + blank : blank + row[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    all += line + "\n";
  }
  return all;
}

}  // namespace echoarc::cli
