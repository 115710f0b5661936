// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/positions_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "echoarc/io/byte_sink.hpp"
#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {
namespace {

template <std::size_t N>
using Names = std::array<std::string_view, N>;

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    while (cell.starts_with(' ')) cell.remove_prefix(1);
    while (cell.ends_with(' ')) cell.remove_suffix(1);
    cells.push_back(cell);
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

template <std::size_t N>
std::string expected_header(const Names<N>& names) {
  return fmt::format("the first line names the columns, the others hold numbers: {}", fmt::join(names, ","));
}

/// Where the named columns stand in the header line.
template <std::size_t N>
Result<std::array<std::size_t, N>> find_columns(std::string_view header, const Names<N>& names,
                                                const std::string& where) {
  const std::vector<std::string_view> cells = split(header);
  std::array<std::size_t, N> columns{};
  for (std::size_t k = 0; k < N; ++k) {
    const auto found = std::ranges::find(cells, names[k]);
    if (found == cells.end())
      return Error{ErrorCode::bad_format, fmt::format("there is no column {}", names[k]), where,
                   expected_header(names)};
    columns[k] = static_cast<std::size_t>(found - cells.begin());
  }
  return columns;
}

Result<double> read_number(std::span<const std::string_view> cells, std::size_t column, std::string_view name,
                           const std::string& where) {
  if (column >= cells.size())
    return Error{ErrorCode::bad_format, fmt::format("the row ends before column {}", name), where, "complete the row"};
  const std::string_view cell = cells[column];
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    return Error{ErrorCode::bad_format, fmt::format("\"{}\" in column {} is no number", cell.substr(0, 40), name),
                 where, "write a plain decimal number, such as 1.25"};
  return value;
}

/// Calls `row` with the named columns of every row; empty lines are skipped.
template <std::size_t N>
Result<void> read_columns(const std::filesystem::path& path, const Names<N>& names,
                          const std::function<void(const std::array<double, N>&)>& row) {
  Result<std::unique_ptr<ByteSource>> source = FileSource::open(path);
  if (!source) return source.error();
  LineReader reader(**source);
  const auto where = [&] { return fmt::format("{}:{}", path.string(), reader.line().number); };
  if (!reader.next())
    return reader.failure().value_or(
        Error{ErrorCode::bad_format, "the file is empty", path.string(), expected_header(names)});
  const Result<std::array<std::size_t, N>> columns = find_columns(reader.line().text, names, where());
  if (!columns) return columns.error();
  while (reader.next()) {
    if (reader.line().text.empty() && !reader.line().too_long) continue;
    const std::vector<std::string_view> cells = split(reader.line().text);
    std::array<double, N> values{};
    for (std::size_t k = 0; k < N; ++k) {
      const Result<double> value = read_number(cells, (*columns)[k], names[k], where());
      if (!value) return value.error();
      values[k] = *value;
    }
    row(values);
  }
  if (reader.failure()) return *reader.failure();
  return {};
}

}  // namespace

Result<void> write_path_csv(const std::filesystem::path& path, std::span<const Odometry> poses) {
  Result<std::unique_ptr<FileSink>> sink = FileSink::create(path);
  if (!sink) return sink.error();
  std::string text = "t,x,y,yaw\n";
  for (const Odometry& pose : poses) {
    const Pose2& T = pose.T_world_robot;
    text += fmt::format("{},{},{},{}\n", pose.time_s, T.position.x, T.position.y, T.heading.rad());
  }
  if (Result<void> written = (*sink)->write(text); !written) return written;
  return (*sink)->commit();
}

Result<std::vector<Vec2>> read_positions_csv(const std::filesystem::path& path) {
  std::vector<Vec2> positions;
  const Result<void> read = read_columns<2>(
      path, {"x", "y"}, [&](const std::array<double, 2>& row) { positions.push_back({row[0], row[1]}); });
  if (!read) return read.error();
  return positions;
}

Result<std::vector<Polyline>> read_polylines_csv(const std::filesystem::path& path) {
  std::vector<Polyline> polylines;
  double current = 0.0;
  const Result<void> read = read_columns<3>(path, {"polyline", "x", "y"}, [&](const std::array<double, 3>& row) {
    if (polylines.empty() || row[0] != current) polylines.emplace_back();
    current = row[0];
    polylines.back().push_back({row[1], row[2]});
  });
  if (!read) return read.error();
  return polylines;
}

}  // namespace echoarc::io
