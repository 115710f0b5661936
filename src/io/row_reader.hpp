// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/io/delimited.hpp"
#include "io/table_cursor.hpp"

namespace echoarc::io {

/// Wheel odometry: straight pieces along the mean of old and new heading, which is exact to second order in the turn.
class DeadReckoning {
 public:
  explicit DeadReckoning(const DelimitedTable& table) : counters_(table.wheel_counters), track_m_(table.track_m) {}

  /// The pose after the wheels moved (or stand, for counters) at `left_m` and `right_m`; `yaw` where a column tells it.
  /// The first row of a counter is its zero. Nothing changes when the pose would not be finite.
  [[nodiscard]] std::optional<Pose2> advance(double left_m, double right_m, std::optional<Angle> yaw);

 private:
  bool counters_;
  double track_m_;
  bool started_ = false;
  double left_counter_m_ = 0.0;
  double right_counter_m_ = 0.0;
  Pose2 T_world_robot_;
};

/// Turns the rows of one table into records of a log.
class RowReader {
 public:
  /// `table` has its columns resolved and passed `check_table`; it must outlive the reader.
  explicit RowReader(const DelimitedTable& table);

  /// Appends what the row says, at `time_s`. On a fault nothing is appended and the cause returned.
  [[nodiscard]] std::optional<std::string> read(const TableRow& row, double time_s, Log& log);

 private:
  using Fault = std::optional<std::string>;

  Fault read_pose(const TableRow& row, std::optional<Odometry>& pose);
  Fault read_ranges(const TableRow& row, double time_s);
  Fault read_range(std::string_view cell, const DelimitedColumn& column, Ping ping);
  Fault read_scan(const TableRow& row, const DelimitedColumn& column, Scan& scan) const;
  /// A finite number in SI units, or a fault.
  Fault read_number(const TableRow& row, const DelimitedColumn& column, double& value) const;

  const DelimitedTable& table_;
  const DelimitedColumn* sensor_ = nullptr;
  bool has_pose_ = false;
  bool has_wheels_ = false;
  DeadReckoning dead_reckoning_;
  std::vector<Ping> pings_;  ///< of the present row
  std::vector<Scan> scans_;
};

}  // namespace echoarc::io
