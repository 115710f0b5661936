// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

namespace echoarc::cli {

/// A table for people: columns as wide as their widest cell, the first one flush left, the others flush right.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}
  /// Columns from 0 that hold words: flush left like the first one.
  void words(std::vector<std::size_t> columns) { words_ = std::move(columns); }
  /// A row of as many cells as the head has.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const { return rows_.size() == 1; }
  /// The table, every line behind `indent`, no blanks at line ends.
  [[nodiscard]] std::string text(std::string_view indent = "  ") const;

 private:
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> words_;
};

}  // namespace echoarc::cli
