// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/io/byte_source.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

/// What a column of a delimited text holds.
enum class Quantity : std::uint8_t {
  time,
  x,  ///< pose of the robot
  y,
  yaw,
  left_wheel,  ///< distance rolled since the row before (or a counter, see `DelimitedTable::wheel_counters`)
  right_wheel,
  sensor,  ///< id of the sensor whose range stands in the same row
  range,
  scan,  ///< ranges of one laser scan, one column a beam
};

/// How a column says that nothing was heard, in the words and units of the file.
struct NoEchoSpelling {
  std::vector<std::string> words;                          ///< the whole cell
  std::vector<double> values;                              ///< numbers exactly equal to the cell's
  double above = std::numeric_limits<double>::infinity();  ///< numbers at or above this

  [[nodiscard]] bool empty() const {
    return words.empty() && values.empty() && above == std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] bool matches_word(std::string_view cell) const;
  [[nodiscard]] bool matches(double value) const;
};

/// One column, or neighbouring columns of one kind (ranges, beams).
struct DelimitedColumn {
  Quantity quantity = Quantity::range;
  std::size_t first = 1;          ///< column number, counted from 1
  std::size_t last = 1;           ///< the same as `first` for a single column
  std::string header;             ///< name in the header line, instead of a number
  double scale = 1.0;             ///< SI units per unit of the file; negative turns the sign
  std::vector<SensorId> sensors;  ///< of `range`: the sensor of each column
  std::uint32_t laser = 0;        ///< of `scan`
  Angle angle_min;                ///< of `scan`: bearing of the first beam in the laser's frame
  Angle angle_step;
  NoEchoSpelling no_echo;  ///< of `range`: no echo; of `scan`: no return
};

/// One file of rows.
struct DelimitedTable {
  static constexpr char whitespace = '\0';

  std::string file;              ///< relative to the input folder; empty: the input itself
  char delimiter = whitespace;   ///< `whitespace`: any run of blanks and tabs
  std::string comment = "#";     ///< lines that start with it are skipped; empty: none
  bool header = false;           ///< the first row names the columns
  std::uint64_t skip_lines = 0;  ///< lines before the first row (or header)
  double rate_hz = 0.0;          ///< rows per second where no column tells the time; 0: not given
  bool wheel_counters = false;   ///< wheel columns count up instead of starting anew in each row
  double track_m = 0.0;          ///< distance of the wheels, for the heading where no column tells it; 0: not given
  std::vector<DelimitedColumn> columns;
};

/// How the rows of several tables belong together.
enum class TableJoin : std::uint8_t {
  time,  ///< every table tells its own time; rows are merged by it
  row,   ///< row i of every table is one sample; the first table tells the time
};

/// What TOML says about a delimited text (docs/formats.md, descriptions/*.toml).
struct DelimitedDescription {
  std::string source;  ///< for messages
  std::string frame = "odom";
  double temperature_k = 293.0;
  RobotDescription robot;
  TableJoin join = TableJoin::time;
  std::vector<DelimitedTable> tables;
};

/// A description out of TOML text. Errors name `source`, line and remedy: TOML that is none, unknown keys, units of the
/// wrong dimension, half a pose, ranges without sensors, rows without time.
[[nodiscard]] Result<DelimitedDescription> parse_description(std::string_view toml, std::string_view source);
/// The same out of a file.
[[nodiscard]] Result<DelimitedDescription> read_description(const std::filesystem::path& path);

/// Opens a table by its `file` key.
using TableOpener = std::function<Result<std::unique_ptr<ByteSource>>(const std::string& file)>;

/// Reads the described tables into one log, streaming. A cell "inf", "-inf" or "nan" of a range is its REP 117 value;
/// an empty one is no ping. Bad lines: as `read_jsonl`, per table. Tables without poses give a log without odometry.
[[nodiscard]] Result<Log> read_delimited(const DelimitedDescription& description, const TableOpener& open,
                                         const ReadLimits& limits = {});
/// The tables of a folder, or of the folder a file lies in; the file itself is the first table.
[[nodiscard]] Result<Log> read_delimited(const DelimitedDescription& description, const std::filesystem::path& input,
                                         const ReadLimits& limits = {});

}  // namespace echoarc::io
