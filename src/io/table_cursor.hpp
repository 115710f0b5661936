// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/io/delimited.hpp"
#include "io/line_faults.hpp"

namespace echoarc::io {

/// One row of a table, cut into cells. A faulty row still counts as a row, so that joined tables stay in step.
struct TableRow {
  Line line;
  std::vector<std::string_view> cells;                       ///< valid until the cursor moves on
  double time_s = std::numeric_limits<double>::quiet_NaN();  ///< NaN where the table does not tell it
  std::string fault;                                         ///< empty: the row is good so far
};

/// Walks through the rows of one table, past comments, blank lines and the header.
class TableCursor {
 public:
  TableCursor(DelimitedTable table, std::unique_ptr<ByteSource> source, const ReadLimits& limits);

  /// Skips what stands before the rows and finds the columns named in the header line.
  [[nodiscard]] Result<void> start();
  /// Advances to the next row; false at the end, after an error of the source, or when too many rows were bad.
  [[nodiscard]] bool next();
  [[nodiscard]] const TableRow& row() const { return row_; }
  /// The description, its named columns resolved to numbers once `start` succeeded.
  [[nodiscard]] const DelimitedTable& table() const { return table_; }
  [[nodiscard]] const std::string& name() const { return source_->name(); }

  /// Counts the present row as bad.
  void reject(std::string cause) { faults_.add(row_.line, std::move(cause)); }
  void warn(std::string warning) { faults_.warn(std::move(warning)); }
  /// What the table was like, or why it cannot be used.
  [[nodiscard]] Result<ReadReport> finish() const;

 private:
  /// The next line that is neither blank nor a comment.
  [[nodiscard]] bool next_line();
  void split();
  void read_time();
  [[nodiscard]] Result<void> resolve_names();
  [[nodiscard]] Error no_rows() const;

  DelimitedTable table_;
  std::unique_ptr<ByteSource> source_;
  LineReader lines_;
  LineFaults faults_;
  TableRow row_;
  std::size_t needed_cells_ = 0;
  const DelimitedColumn* time_column_ = nullptr;
  std::uint64_t rows_ = 0;
};

}  // namespace echoarc::io
