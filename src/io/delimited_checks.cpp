// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/delimited_checks.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace echoarc::io {
namespace {

std::size_t count_of(const DelimitedTable& table, Quantity quantity) {
  return static_cast<std::size_t>(std::ranges::count(table.columns, quantity, &DelimitedColumn::quantity));
}
bool has(const DelimitedTable& table, Quantity quantity) {
  return count_of(table, quantity) > 0;
}

Error bad(std::string message, std::string remedy) {
  return {ErrorCode::bad_value, std::move(message), "", std::move(remedy)};
}

Result<void> check_repeats(const DelimitedTable& table) {
  for (const Quantity quantity : {Quantity::time, Quantity::x, Quantity::y, Quantity::yaw, Quantity::left_wheel,
                                  Quantity::right_wheel, Quantity::sensor})
    if (count_of(table, quantity) > 1)
      return bad("a quantity that can be there once is there twice", "keep one column of time, x, y, yaw, ...");
  return {};
}

Result<void> check_pose(const DelimitedTable& table) {
  const bool x = has(table, Quantity::x);
  const bool y = has(table, Quantity::y);
  const bool yaw = has(table, Quantity::yaw);
  const bool left = has(table, Quantity::left_wheel);
  const bool right = has(table, Quantity::right_wheel);
  const bool position = x && y && yaw && !left && !right;
  const bool wheels = left && right && !x && !y && (yaw || table.track_m > 0.0);
  const bool none = !x && !y && !yaw && !left && !right;
  if (position || wheels || none) return {};
  return bad(
      "the columns make no whole pose",
      "give x, y and yaw; or left_wheel, right_wheel and yaw; or left_wheel, right_wheel and the table's track_m");
}

Result<void> check_ranges(const DelimitedTable& table) {
  const bool by_column = !has(table, Quantity::sensor);
  for (const DelimitedColumn& column : table.columns) {
    if (column.last > column.first && column.quantity != Quantity::range && column.quantity != Quantity::scan)
      return bad("only range and scan take neighbouring columns", "write column = 3");
    if (column.quantity != Quantity::range) continue;
    const std::size_t width = column.last - column.first + 1;
    if (by_column && column.sensors.size() != width)
      return bad(fmt::format("{} range column(s) name {} sensor(s)", width, column.sensors.size()),
                 "list one sensor id a column: sensors = [0, 1, 2], or add a column of quantity \"sensor\"");
    if (!by_column && (!column.sensors.empty() || width != 1 || count_of(table, Quantity::range) != 1))
      return bad("a row that names its sensor has one range",
                 "drop sensors = [...], or the column of quantity \"sensor\"");
  }
  if (!by_column && !has(table, Quantity::range)) return bad("a sensor column without a range", "add the range column");
  return {};
}

Result<void> check_header_names(const DelimitedTable& table) {
  for (const DelimitedColumn& column : table.columns)
    if (!column.header.empty() && !table.header)
      return bad(fmt::format("the column \"{}\" is named, but the table has no header line", column.header),
                 "write header = true, or number the columns from 1");
  return {};
}

bool tells_time(const DelimitedTable& table) {
  return has(table, Quantity::time) || table.rate_hz > 0.0;
}

}  // namespace

Result<void> check_table(const DelimitedTable& table) {
  for (const auto& check : {check_repeats, check_pose, check_ranges, check_header_names})
    if (Result<void> checked = check(table); !checked) return checked;
  const bool useful = std::ranges::any_of(
      table.columns, [](const DelimitedColumn& column) { return column.quantity != Quantity::time; });
  if (!useful) return bad("nothing but times", "add the columns of poses or ranges");
  return {};
}

Result<void> check_tables(const DelimitedDescription& description) {
  const auto fail = [&](std::string message, std::string remedy) {
    return Error{ErrorCode::bad_value, std::move(message), description.source, std::move(remedy)};
  };
  if (description.tables.empty()) return fail("the description has no table", "add [[table]] with its columns");
  const bool by_row = description.join == TableJoin::row;
  for (const DelimitedTable& table : description.tables) {
    const bool first = &table == &description.tables.front();
    if (!tells_time(table) && (first || !by_row))
      return fail(fmt::format("no column of the table \"{}\" tells the time", table.file),
                  "add a column of quantity \"time\" or rate_hz = 10, or join = \"row\" to use the first table's");
    if (table.file.empty() && description.tables.size() > 1 && !first)
      return fail("a table has no file", "name it: file = \"sonar.txt\"");
  }
  return {};
}

}  // namespace echoarc::io
