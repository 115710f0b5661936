// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "echoarc/io/delimited.hpp"
#include "io/row_reader.hpp"
#include "io/table_cursor.hpp"

namespace echoarc::io {

bool NoEchoSpelling::matches_word(std::string_view cell) const {
  return std::ranges::find(words, cell) != words.end();
}

bool NoEchoSpelling::matches(double value) const {
  return value >= above || std::ranges::find(values, value) != values.end();
}

namespace {

/// A table that is being read, row by row.
struct OpenTable {
  OpenTable(const DelimitedTable& table, std::unique_ptr<ByteSource> source, const ReadLimits& limits)
      : cursor(table, std::move(source), limits), rows(cursor.table()) {}

  /// Reads the present row at `time_s`, unless it is bad.
  void read_row(double time_s, Log& log) {
    if (std::optional<std::string> fault = rows.read(cursor.row(), time_s, log)) cursor.reject(std::move(*fault));
  }
  /// Advances to the next row that is good as far as the cursor can tell.
  bool next_good() {
    while (cursor.next()) {
      if (cursor.row().fault.empty()) return true;
      cursor.reject(cursor.row().fault);
    }
    return false;
  }

  TableCursor cursor;
  RowReader rows;
};
using OpenTables = std::vector<std::unique_ptr<OpenTable>>;

/// Every table tells its own time: always the table with the earliest row is next, so each keeps its order.
void read_by_time(OpenTables& tables, Log& log) {
  std::vector<OpenTable*> active;
  for (const auto& table : tables)
    if (table->next_good()) active.push_back(table.get());
  while (!active.empty()) {
    const auto next =
        std::ranges::min_element(active, {}, [](const OpenTable* table) { return table->cursor.row().time_s; });
    (*next)->read_row((*next)->cursor.row().time_s, log);
    if (!(*next)->next_good()) active.erase(next);
  }
}

/// Row i of every table is one sample, at the time of the first table.
void read_joined_row(OpenTables& tables, Log& log) {
  // Clocks of one sample that differ by more are the sign of a lost row.
  constexpr double max_difference_s = 1e-3;
  const TableCursor& leader = tables.front()->cursor;
  const double time_s = leader.row().time_s;
  for (const auto& table : tables) {
    const TableRow& row = table->cursor.row();
    if (!row.fault.empty())
      table->cursor.reject(row.fault);
    else if (std::abs(row.time_s - time_s) > max_difference_s)
      table->cursor.reject(
          fmt::format("{} s here, {} s in line {} of {}", row.time_s, time_s, leader.row().line.number, leader.name()));
    else if (leader.row().fault.empty())
      table->read_row(time_s, log);
  }
}

void read_by_row(OpenTables& tables, Log& log) {
  while (true) {
    std::size_t advanced = 0;
    for (const auto& table : tables) advanced += table->cursor.next() ? 1 : 0;
    if (advanced == tables.size()) {
      read_joined_row(tables, log);
      continue;
    }
    if (advanced > 0)
      tables.front()->cursor.warn(
          "the tables have different numbers of rows; the rest of the longer ones was left out");
    return;
  }
}

Result<ReadReport> merged_report(const OpenTables& tables) {
  ReadReport merged;
  for (const auto& table : tables) {
    const Result<ReadReport> report = table->cursor.finish();
    if (!report) return report.error();
    merged.lines += report->lines;
    merged.bad_lines += report->bad_lines;
    for (const BadLine& bad : report->first_bad)
      if (merged.first_bad.size() < LineFaults::kept_messages)
        merged.first_bad.push_back({bad.line, fmt::format("{}: {}", table->cursor.name(), bad.message)});
    merged.warnings.insert(merged.warnings.end(), report->warnings.begin(), report->warnings.end());
  }
  return merged;
}

}  // namespace

Result<Log> read_delimited(const DelimitedDescription& description, const TableOpener& open, const ReadLimits& limits) {
  Log log;
  log.source = description.source;
  log.frame = description.frame;
  log.temperature_k = description.temperature_k;
  log.robot = description.robot;
  OpenTables tables;
  for (const DelimitedTable& table : description.tables) {
    Result<std::unique_ptr<ByteSource>> source = open(table.file);
    if (!source) return source.error();
    tables.push_back(std::make_unique<OpenTable>(table, std::move(*source), limits));
    if (const Result<void> started = tables.back()->cursor.start(); !started) return started.error();
  }
  description.join == TableJoin::row ? read_by_row(tables, log) : read_by_time(tables, log);
  Result<ReadReport> report = merged_report(tables);
  if (!report) return report.error();
  log.report = std::move(*report);
  return log;
}

Result<Log> read_delimited(const DelimitedDescription& description, const std::filesystem::path& input,
                           const ReadLimits& limits) {
  std::error_code ignored;  // what cannot be examined is opened as a file, and that says why it fails
  const bool is_folder = std::filesystem::is_directory(input, ignored);
  const std::string& first = description.tables.front().file;
  const auto open = [&](const std::string& file) -> Result<std::unique_ptr<ByteSource>> {
    if (is_folder && file.empty())
      return Error{ErrorCode::bad_value, "the description names no file in the folder", input.string(),
                   "name one of its files, or add file = \"NAME\" to the [[table]] in " + description.source};
    if (!is_folder && file == first) return FileSource::open(input);
    Result<std::unique_ptr<ByteSource>> source = FileSource::open((is_folder ? input : input.parent_path()) / file);
    if (source) return source;
    Error error = source.error();
    error.remedy = fmt::format("put the file there, or correct file = \"{}\" in {}", file, description.source);
    return error;
  };
  Result<Log> log = read_delimited(description, open, limits);
  if (log) log->source = input.string();
  return log;
}

}  // namespace echoarc::io
