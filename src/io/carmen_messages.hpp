// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/io/line_reader.hpp"

namespace echoarc::io {

/// Whether a line starts like a message of a CARMEN log that this reader uses.
[[nodiscard]] bool is_carmen_message(std::string_view line);

/// Takes the words of a message one by one; after the first that is missing or wrong all further ones fail.
class CarmenWords {
 public:
  void split(std::string_view line);
  [[nodiscard]] std::string_view name() const { return words_.empty() ? std::string_view{} : words_.front(); }

  /// A finite number.
  double number();
  Angle angle() { return radians(number()); }
  Pose2 pose();
  /// How many values follow; never more than there are words.
  std::size_t count();
  void skip(std::size_t words);
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
  bool failed_ = false;
};

/// Turns the messages of a CARMEN log into records.
class CarmenMessages {
 public:
  /// Appends what the line says. False when it is no message: nothing was appended, and `fault` says why.
  [[nodiscard]] bool read(const Line& line, Log& log);
  [[nodiscard]] const std::string& fault() const { return fault_; }
  /// Gives a log without ODOM the poses of its laser messages. Call once, at the end.
  void finish(Log& log);
  /// Names of messages that were passed over.
  [[nodiscard]] const std::set<std::string, std::less<>>& skipped() const { return skipped_; }

 private:
  bool read_odometry(Log& log);
  bool read_true_pose(Log& log);
  bool read_old_laser(std::uint32_t laser, Log& log);
  bool read_laser(Log& log);
  bool read_sonar(Log& log);
  void read_ranges(Scan& scan, double range_max_m);
  bool add_scan(Scan scan, const Pose2& T_world_laser, const Pose2& T_world_robot, double range_max_m, Log& log);
  bool add_sensors(const std::vector<Pose2>& T_robot_sensors, Angle cone, Log& log);
  bool fail(std::string cause);

  CarmenWords words_;
  std::uint64_t line_ = 0;
  std::string fault_;
  std::vector<Odometry> laser_odometry_;
  std::set<std::string, std::less<>> skipped_;
};

}  // namespace echoarc::io
