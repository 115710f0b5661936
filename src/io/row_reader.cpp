// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "io/row_reader.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "io/text_cells.hpp"

namespace echoarc::io {
namespace {

std::string not_a_number(std::string_view cell, std::size_t column) {
  return fmt::format("column {}: \"{:.40}\" is not a finite number", column, cell);
}

}  // namespace

std::optional<Pose2> DeadReckoning::advance(double left_m, double right_m, std::optional<Angle> yaw) {
  const bool zero = counters_ && !started_;
  const double left = counters_ ? (zero ? 0.0 : left_m - left_counter_m_) : left_m;
  const double right = counters_ ? (zero ? 0.0 : right_m - right_counter_m_) : right_m;
  const Angle before = started_ || !yaw ? T_world_robot_.heading : *yaw;
  const Angle turn = yaw ? wrap(*yaw - before) : radians((right - left) / track_m_);
  const Vec2 position = T_world_robot_.position + (0.5 * (left + right)) * unit(before + 0.5 * turn);
  const Pose2 pose{position, yaw ? *yaw : before + turn};
  if (!is_finite(pose)) return std::nullopt;
  started_ = true;
  left_counter_m_ = left_m;
  right_counter_m_ = right_m;
  T_world_robot_ = pose;
  return pose;
}

RowReader::RowReader(const DelimitedTable& table) : table_(table), dead_reckoning_(table) {
  for (const DelimitedColumn& column : table.columns) {
    if (column.quantity == Quantity::sensor) sensor_ = &column;
    has_pose_ = has_pose_ || column.quantity == Quantity::x;
    has_wheels_ = has_wheels_ || column.quantity == Quantity::left_wheel;
  }
}

std::optional<std::string> RowReader::read(const TableRow& row, double time_s, Log& log) {
  pings_.clear();
  scans_.clear();
  if (Fault fault = read_ranges(row, time_s)) return fault;
  for (const DelimitedColumn& column : table_.columns) {
    if (column.quantity != Quantity::scan) continue;
    Scan scan{time_s, column.laser, column.angle_min, column.angle_step, {}, row.line.number};
    if (Fault fault = read_scan(row, column, scan)) return fault;
    scans_.push_back(std::move(scan));
  }
  std::optional<Odometry> pose;  // last, since dead reckoning remembers
  if (Fault fault = read_pose(row, pose)) return fault;
  if (pose) log.odometry.push_back({time_s, pose->T_world_robot, row.line.number});
  log.pings.insert(log.pings.end(), pings_.begin(), pings_.end());
  for (Scan& scan : scans_) log.scans.push_back(std::move(scan));
  return std::nullopt;
}

RowReader::Fault RowReader::read_pose(const TableRow& row, std::optional<Odometry>& pose) {
  if (!has_pose_ && !has_wheels_) return std::nullopt;
  Vec2 position;
  std::optional<double> yaw_rad;
  double left_m = 0.0;
  double right_m = 0.0;
  for (const DelimitedColumn& column : table_.columns) {
    double* target = nullptr;
    if (column.quantity == Quantity::x) target = &position.x;
    if (column.quantity == Quantity::y) target = &position.y;
    if (column.quantity == Quantity::yaw) target = &yaw_rad.emplace(0.0);
    if (column.quantity == Quantity::left_wheel) target = &left_m;
    if (column.quantity == Quantity::right_wheel) target = &right_m;
    if (target == nullptr) continue;
    if (Fault fault = read_number(row, column, *target)) return fault;
  }
  const std::optional<Angle> yaw = yaw_rad ? std::optional(radians(*yaw_rad)) : std::nullopt;
  const auto T_world_robot = has_wheels_ ? dead_reckoning_.advance(left_m, right_m, yaw)
                                         : std::optional(Pose2{position, yaw.value_or(Angle{})});
  if (!T_world_robot) return "the wheels have gone too far";
  pose = Odometry{0.0, *T_world_robot, row.line.number};
  return std::nullopt;
}

RowReader::Fault RowReader::read_ranges(const TableRow& row, double time_s) {
  Ping ping;
  ping.time_s = time_s;
  ping.line = row.line.number;
  for (const DelimitedColumn& column : table_.columns) {
    if (column.quantity != Quantity::range) continue;
    for (std::size_t i = column.first; i <= column.last; ++i) {
      if (sensor_ != nullptr) {
        const auto id = parse_number<SensorId>(row.cells[sensor_->first - 1]);
        if (!id)
          return fmt::format("column {}: \"{:.40}\" is no sensor id", sensor_->first, row.cells[sensor_->first - 1]);
        ping.tx = *id;
      } else {
        ping.tx = column.sensors[i - column.first];
      }
      ping.rx = ping.tx;
      if (Fault fault = read_range(row.cells[i - 1], column, ping)) return fmt::format("column {}: {}", i, *fault);
    }
  }
  return std::nullopt;
}

RowReader::Fault RowReader::read_range(std::string_view cell, const DelimitedColumn& column, Ping ping) {
  const bool is_word = column.no_echo.matches_word(cell);
  if (cell.empty() && !is_word) return std::nullopt;  // the sensor was not fired
  const std::optional<double> value = parse_number<double>(cell);
  if (!is_word && !value) return fmt::format("\"{:.40}\" is not a range", cell);
  if (is_word || column.no_echo.matches(*value))
    ping.range_m = std::numeric_limits<double>::infinity();
  else
    ping.range_m = std::isfinite(*value) ? *value * column.scale : *value;
  // A number that leaves the doubles when scaled must not turn into "no echo".
  if (value && std::isfinite(*value) && !is_word && !column.no_echo.matches(*value) && !std::isfinite(ping.range_m))
    return fmt::format("{} is too large", *value);
  pings_.push_back(ping);
  return std::nullopt;
}

RowReader::Fault RowReader::read_scan(const TableRow& row, const DelimitedColumn& column, Scan& scan) const {
  scan.ranges_m.reserve(column.last - column.first + 1);
  for (std::size_t i = column.first; i <= column.last; ++i) {
    const std::string_view cell = row.cells[i - 1];
    const std::optional<double> value = parse_number<double>(cell);
    const bool silent = cell.empty() || column.no_echo.matches_word(cell) ||
                        (value && (!std::isfinite(*value) || column.no_echo.matches(*value)));
    if (!silent && !value) return not_a_number(cell, i);
    const double range_m = silent ? std::numeric_limits<double>::quiet_NaN() : *value * column.scale;
    if (std::abs(range_m) > std::numeric_limits<float>::max())
      return fmt::format("column {}: {} is too large", i, *value);
    scan.ranges_m.push_back(static_cast<float>(range_m));
  }
  return std::nullopt;
}

RowReader::Fault RowReader::read_number(const TableRow& row, const DelimitedColumn& column, double& value) const {
  const std::string_view cell = row.cells[column.first - 1];
  value = parse_number<double>(cell).value_or(std::numeric_limits<double>::quiet_NaN()) * column.scale;
  return std::isfinite(value) ? Fault{} : Fault{not_a_number(cell, column.first)};
}

}  // namespace echoarc::io
