// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

/// Counts the bad lines of one file and decides when they are too many: more than 1 % of the lines, or more than 100.
class LineFaults {
 public:
  static constexpr std::uint64_t max_bad_lines = 100;
  static constexpr std::uint64_t max_bad_percent = 1;
  static constexpr std::size_t kept_messages = 10;

  /// `remedy` says what a good line looks like.
  LineFaults(std::string source, std::string remedy) : source_(std::move(source)), remedy_(std::move(remedy)) {}

  /// A line that holds a record, good or bad.
  void count_line() { ++report_.lines; }
  /// The line is bad. A last line that was cut off is only worth a warning.
  void add(const Line& line, std::string cause);
  void warn(std::string warning);
  /// True once no further line can help.
  [[nodiscard]] bool hopeless() const { return report_.bad_lines > max_bad_lines; }
  /// The report, or the error when the bad lines are too many.
  [[nodiscard]] Result<ReadReport> finish() const;
  /// "file:line"
  [[nodiscard]] std::string place(std::uint64_t line) const;

 private:
  std::string source_;
  std::string remedy_;
  ReadReport report_;
};

}  // namespace echoarc::io
