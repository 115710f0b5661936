// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/plain_csv.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "echoarc/io/delimited.hpp"
#include "io/text_cells.hpp"
#include "io/units.hpp"

namespace echoarc::io {
namespace {

constexpr std::size_t max_header_cells = 1024;
constexpr std::size_t max_header_bytes = 65'536;
constexpr const char* ranges_remedy = "name the columns in the first line: t,sensor_id,range_m";
constexpr const char* odometry_remedy = "name the columns in the first line: t,x,y,yaw";

struct ColumnName {
  std::string_view name;
  Quantity quantity;
};
constexpr std::array column_names = {
    ColumnName{"t", Quantity::time},
    ColumnName{"time", Quantity::time},
    ColumnName{"timestamp", Quantity::time},
    ColumnName{"stamp", Quantity::time},
    ColumnName{"x", Quantity::x},
    ColumnName{"y", Quantity::y},
    ColumnName{"yaw", Quantity::yaw},
    ColumnName{"theta", Quantity::yaw},
    ColumnName{"heading", Quantity::yaw},
    ColumnName{"sensor_id", Quantity::sensor},
    ColumnName{"sensor", Quantity::sensor},
    ColumnName{"id", Quantity::sensor},
    ColumnName{"range", Quantity::range},
    ColumnName{"distance", Quantity::range},
};

const ColumnName* find_name(std::string_view name) {
  const auto found = std::ranges::find(column_names, name, &ColumnName::name);
  return found == column_names.end() ? nullptr : &*found;
}

/// "range_cm" is a range in centimetres; a name without unit is SI. Nothing for a name that means nothing here.
std::optional<DelimitedColumn> column_of(std::string_view cell) {
  std::string name(cell.substr(0, 64));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  DelimitedColumn column;
  if (const ColumnName* known = find_name(name)) {
    column.quantity = known->quantity;
    return column;
  }
  const std::size_t underscore = name.rfind('_');
  if (underscore == std::string::npos) return std::nullopt;
  const ColumnName* known = find_name(std::string_view(name).substr(0, underscore));
  if (known == nullptr) return std::nullopt;
  const auto scale = si_scale(dimension_of(known->quantity), std::string_view(name).substr(underscore + 1));
  if (!scale) return std::nullopt;
  column.quantity = known->quantity;
  column.scale = *scale;
  return column;
}

/// The table a header line describes; of each quantity the first column counts.
DelimitedTable table_of(std::string_view header) {
  DelimitedTable table;
  table.header = true;
  for (const char delimiter : {',', ';', '\t'})
    if (table.delimiter == DelimitedTable::whitespace && header.find(delimiter) != std::string_view::npos)
      table.delimiter = delimiter;
  std::vector<std::string_view> cells;
  if (table.delimiter == DelimitedTable::whitespace)
    split_words(header, max_header_cells, cells);
  else
    split_cells(header, table.delimiter, max_header_cells, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::optional<DelimitedColumn> column = column_of(cells[i]);
    if (!column || std::ranges::count(table.columns, column->quantity, &DelimitedColumn::quantity) > 0) continue;
    column->first = column->last = i + 1;
    table.columns.push_back(std::move(*column));
  }
  return table;
}

bool has_all(const DelimitedTable& table, std::initializer_list<Quantity> quantities) {
  return std::ranges::all_of(quantities, [&](Quantity quantity) {
    return std::ranges::count(table.columns, quantity, &DelimitedColumn::quantity) == 1;
  });
}

void keep_only(DelimitedTable& table, std::initializer_list<Quantity> quantities) {
  std::erase_if(table.columns, [&](const DelimitedColumn& column) {
    return std::ranges::find(quantities, column.quantity) == quantities.end();
  });
}

/// The table of a file, told from its first line that is not a comment.
Result<DelimitedTable> describe(const std::string& file, const TableOpener& open, const char* remedy) {
  Result<std::unique_ptr<ByteSource>> source = open(file);
  if (!source) return source.error();
  LineReader lines(**source, {.line_bytes = max_header_bytes});
  while (lines.next()) {
    const std::string_view text = trimmed(lines.line().text);
    if (text.starts_with('#') || (text.empty() && !lines.line().too_long)) continue;
    DelimitedTable table = table_of(text);
    table.file = file;
    return table;
  }
  if (lines.failure()) return *lines.failure();
  return Error{ErrorCode::bad_format, "the file is empty", file, remedy};
}

/// The ranges, with or without poses; nothing else of the file is kept.
Result<DelimitedTable> describe_ranges(const std::string& file, const TableOpener& open) {
  Result<DelimitedTable> table = describe(file, open, ranges_remedy);
  if (!table || has_all(*table, {Quantity::time, Quantity::sensor, Quantity::range})) return table;
  return Error{ErrorCode::bad_format, "the header line does not name t, sensor_id and range_m", file, ranges_remedy};
}

Result<DelimitedTable> describe_odometry(const std::string& file, const TableOpener& open) {
  Result<DelimitedTable> table = describe(file, open, odometry_remedy);
  if (!table) return table;
  keep_only(*table, {Quantity::time, Quantity::x, Quantity::y, Quantity::yaw});
  if (table->columns.size() == 4) return table;
  return Error{ErrorCode::bad_format, "the header line does not name t, x, y and yaw", file, odometry_remedy};
}

bool has_pose(const DelimitedTable& table) {
  return has_all(table, {Quantity::x, Quantity::y, Quantity::yaw});
}

std::optional<std::string> find_odometry(const std::filesystem::path& ranges) {
  const std::filesystem::path folder = ranges.parent_path();
  for (const std::string& name :
       {ranges.stem().string() + ".odom.csv", std::string("odometry.csv"), std::string("odom.csv")}) {
    std::error_code ignored;  // a candidate that cannot be examined is none
    if (std::filesystem::is_regular_file(folder / name, ignored)) return (folder / name).string();
  }
  return std::nullopt;
}

Error no_odometry(const std::string& ranges) {
  return {
      ErrorCode::not_found, "the ranges have no odometry beside them", ranges,
      fmt::format("put odometry.csv or {}.odom.csv with the columns t,x,y,yaw beside it, or name one: --odometry FILE",
                  std::filesystem::path(ranges).stem().string())};
}

}  // namespace

bool is_plain_csv_header(std::string_view line) {
  return has_all(table_of(line), {Quantity::time, Quantity::sensor, Quantity::range});
}

Result<Log> read_plain_csv(const std::string& ranges, const std::optional<std::string>& odometry,
                           const RobotDescription& robot, const TableOpener& open, const ReadLimits& limits) {
  Result<DelimitedTable> table = describe_ranges(ranges, open);
  if (!table) return table.error();
  DelimitedDescription description;
  description.source = ranges;
  description.robot = robot;
  if (odometry) {
    Result<DelimitedTable> poses = describe_odometry(*odometry, open);
    if (!poses) return poses.error();
    description.tables.push_back(std::move(*poses));
  } else if (!has_pose(*table)) {
    return no_odometry(ranges);
  }
  if (odometry || !has_pose(*table)) keep_only(*table, {Quantity::time, Quantity::sensor, Quantity::range});
  description.tables.push_back(std::move(*table));
  return read_delimited(description, open, limits);
}

Result<Log> read_plain_csv(const std::filesystem::path& ranges, const PlainCsvOptions& options) {
  const auto open = [](const std::string& file) { return FileSource::open(file); };
  const Result<DelimitedTable> table = describe_ranges(ranges.string(), open);
  if (!table) return table.error();
  if (!options.robot)
    return Error{ErrorCode::bad_value, "the ranges do not say where the sensors are", ranges.string(),
                 "describe the robot: --robot robot.toml (echoarc init writes one)"};
  std::optional<std::string> odometry;
  if (options.odometry) odometry = options.odometry->string();
  if (!odometry && !has_pose(*table)) odometry = find_odometry(ranges);
  return read_plain_csv(ranges.string(), odometry, *options.robot, open, options.limits);
}

}  // namespace echoarc::io
