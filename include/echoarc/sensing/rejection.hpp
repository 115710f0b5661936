// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace echoarc {

/// Why a record of a log was not used. Nothing is dropped without one of these.
enum class Rejection : std::uint8_t {
  unknown_sensor,     ///< transmitter or receiver is not in the robot description
  bad_time,           ///< time stamp not finite, or far ahead of everything before it
  time_backwards,     ///< stamped before a record that was already used
  duplicate,          ///< repeats the record before it: same time and, of a ping, same sensors and value
  later_echo,         ///< not the first echo of its transmission
  no_pose,            ///< no odometry before it, or none after it
  pose_gap,           ///< the odometry around it is too far apart to interpolate
  bad_pose,           ///< odometry pose not finite or out of reach
  invalid,            ///< the hardware reported a failed measurement
  below_min_range,    ///< an echo nearer than the sensor can measure
  above_max_range,    ///< an echo beyond the sensor's maximum where the described no-echo rule does not cover it
  implausible_range,  ///< more than twice the maximum: probably another unit
  path_too_short,     ///< path of a bistatic ping not longer than the distance from transmitter to receiver
  range_cut,          ///< an echo beyond the range cut of the user
  range_jump,         ///< differs too much from the reading before of its sensor, as the user wants it
  stamp_uncertain,    ///< a polled ping that could have been fired too far from where it is said to be
};
inline constexpr std::size_t rejection_count = 16;

/// What people are told about a reason.
struct RejectionInfo {
  Rejection reason;
  std::string_view name;         ///< in reports and JSON
  std::string_view explanation;  ///< what was wrong, one clause
  std::string_view remedy;       ///< what to do about it, one sentence
};

/// All reasons in the order of the enum.
[[nodiscard]] std::span<const RejectionInfo, rejection_count> rejections();
[[nodiscard]] const RejectionInfo& info(Rejection reason);
[[nodiscard]] inline std::string_view name(Rejection reason) {
  return info(reason).name;
}

/// Count of one reason with its first occurrence.
struct RejectionTally {
  std::uint64_t count = 0;
  std::uint64_t first_line = 0;   ///< line in the source file, from 1; 0 where there is none
  std::uint64_t first_index = 0;  ///< place among the records of its kind, from 0: of a ping its id
  double first_value = std::numeric_limits<double>::quiet_NaN();  ///< offending number: a range (m) or a time (s)
  friend bool operator==(const RejectionTally& a, const RejectionTally& b) {
    return a.count == b.count && a.first_line == b.first_line && a.first_index == b.first_index;
  }
};

/// One tally per reason.
class RejectionCounters {
 public:
  void add(Rejection reason, std::uint64_t line, std::uint64_t index, double value);
  [[nodiscard]] const RejectionTally& operator[](Rejection reason) const {
    return tallies_[static_cast<std::size_t>(reason)];
  }
  [[nodiscard]] std::uint64_t total() const;
  friend bool operator==(const RejectionCounters&, const RejectionCounters&) = default;

 private:
  std::array<RejectionTally, rejection_count> tallies_{};
};

/// "implausible_range: 31 pings, first at line 12 (5110 m): ... Check the unit ...", for people. `kind` names one
/// record: "ping", "odometry record", "wall note".
[[nodiscard]] std::string describe(Rejection reason, const RejectionTally& tally, std::string_view kind);

}  // namespace echoarc
