// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/table_cursor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/text_cells.hpp"

namespace echoarc::io {
namespace {

constexpr const char* row_remedy =
    "correct or delete the bad lines, or correct the columns, delimiter or comment of the description";
constexpr std::size_t max_header_cells = 65'536;

}  // namespace

TableCursor::TableCursor(DelimitedTable table, std::unique_ptr<ByteSource> source, const ReadLimits& limits)
    : table_(std::move(table)),
      source_(std::move(source)),
      lines_(*source_, limits),
      faults_(source_->name(), row_remedy) {}

Result<void> TableCursor::start() {
  for (std::uint64_t i = 0; i < table_.skip_lines && lines_.next();) ++i;
  if (table_.header) {
    needed_cells_ = max_header_cells;
    if (!next_line()) return lines_.failure() ? *lines_.failure() : no_rows();
    split();
    if (Result<void> resolved = resolve_names(); !resolved) return resolved;
  }
  needed_cells_ = 0;
  for (const DelimitedColumn& column : table_.columns) {
    needed_cells_ = std::max(needed_cells_, column.last);
    if (column.quantity == Quantity::time) time_column_ = &column;
  }
  return lines_.failure() ? Result<void>{*lines_.failure()} : Result<void>{};
}

Error TableCursor::no_rows() const {
  return {ErrorCode::bad_format, "the file has no rows", name(), "check that the recording was written"};
}

Result<void> TableCursor::resolve_names() {
  for (DelimitedColumn& column : table_.columns) {
    if (column.header.empty()) continue;
    const auto found = std::ranges::find(row_.cells, std::string_view(column.header));
    if (found == row_.cells.end())
      return Error{ErrorCode::bad_format, fmt::format("the header line has no column \"{}\"", column.header),
                   faults_.place(row_.line.number),
                   fmt::format("it has: {:.200}", fmt::format("{}", fmt::join(row_.cells, ", ")))};
    column.first = column.last = static_cast<std::size_t>(found - row_.cells.begin()) + 1;
  }
  return {};
}

bool TableCursor::next() {
  if (faults_.hopeless() || !next_line()) return false;
  faults_.count_line();
  row_.fault.clear();
  row_.cells.clear();
  row_.time_s = std::numeric_limits<double>::quiet_NaN();
  if (row_.line.too_long)
    row_.fault = "the line is too long";
  else
    split();
  if (row_.fault.empty() && row_.cells.size() < needed_cells_)
    row_.fault = fmt::format("the line has {} cells, column {} is needed", row_.cells.size(), needed_cells_);
  if (row_.fault.empty()) read_time();
  ++rows_;
  return true;
}

bool TableCursor::next_line() {
  while (lines_.next()) {
    const std::string_view text = trimmed(lines_.line().text);
    const bool skipped = text.empty() || (!table_.comment.empty() && text.starts_with(table_.comment));
    if (skipped && !lines_.line().too_long) continue;
    row_.line = lines_.line();
    return true;
  }
  return false;
}

void TableCursor::split() {
  if (table_.delimiter == DelimitedTable::whitespace)
    split_words(row_.line.text, needed_cells_, row_.cells);
  else
    split_cells(row_.line.text, table_.delimiter, needed_cells_, row_.cells);
}

void TableCursor::read_time() {
  if (time_column_ == nullptr) {
    if (table_.rate_hz > 0.0) row_.time_s = static_cast<double>(rows_) / table_.rate_hz;
    return;
  }
  const std::string_view cell = row_.cells[time_column_->first - 1];
  row_.time_s = parse_number<double>(cell).value_or(row_.time_s) * time_column_->scale;
  if (!std::isfinite(row_.time_s)) row_.fault = fmt::format("the time \"{:.40}\" is not a number", cell);
}

Result<ReadReport> TableCursor::finish() const {
  if (lines_.failure()) return *lines_.failure();
  if (rows_ == 0) return no_rows();
  return faults_.finish();
}

}  // namespace echoarc::io
