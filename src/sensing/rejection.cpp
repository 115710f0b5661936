// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/rejection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "echoarc/core/options.hpp"

namespace echoarc {
namespace {

constexpr std::array<RejectionInfo, rejection_count> table{{
    {Rejection::unknown_sensor, "unknown_sensor", "its transmitter or receiver is not in the robot description",
     "Add the sensor to the description, or correct the id in the log."},
    {Rejection::bad_time, "bad_time", "its time stamp is not a finite number or lies far ahead of everything before it",
     "Repair the stamps (seconds); if the robot paused that long, raise max_time_jump_s."},
    {Rejection::time_backwards, "time_backwards", "it is stamped before a record that was already used",
     "Sort the log by time; on a robot, look for a clock that was set back."},
    {Rejection::duplicate, "duplicate",
     "it repeats the record before it: same time and, of a ping, same sensors and value",
     "Harmless; to be rid of it, write every record once."},
    {Rejection::later_echo, "later_echo", "it is not the first echo of its transmission",
     "Nothing to do: the methods use first echoes alone."},
    {Rejection::no_pose, "no_pose", "there is no odometry before it, or none after it",
     "Check that odometry and pings share one clock and one unit of time, and that odometry covers the whole drive."},
    {Rejection::pose_gap, "pose_gap", "the odometry around it is too far apart to interpolate a pose",
     "Record odometry more often; if the robot moves slowly, raise max_pose_gap_s."},
    {Rejection::bad_pose, "bad_pose", "its pose is not finite or beyond 10 000 km",
     "Repair the odometry: x and y in metres, yaw in radians."},
    {Rejection::invalid, "invalid", "the hardware reported a failed measurement (NaN or a negative number)",
     "If the sensor says so when it hears nothing, set its no_echo rule (\"nan\" or \"zero\")."},
    {Rejection::below_min_range, "below_min_range", "the range is below what the sensor can measure",
     "Correct range_min or the unit; to mark what stands so near, set below_minimum = \"too_close\"."},
    {Rejection::above_max_range, "above_max_range",
     "the range is above the sensor's maximum and its no_echo rule does not cover it",
     "Correct range_max, or set no_echo = \"auto\" or \"max\" if the value means that nothing was heard."},
    {Rejection::implausible_range, "implausible_range", "the range is more than twice the sensor's maximum",
     "Check the unit of the ranges: millimetres or centimetres read as metres look like this."},
    {Rejection::path_too_short, "path_too_short",
     "the path is not longer than the distance from transmitter to receiver",
     "Check both mounts, and that the range of such a ping is half of the path."},
    {Rejection::range_cut, "range_cut", "the range is beyond range_cut_m",
     "Nothing to do: this is what the cut is for; raise range_cut_m to keep more."},
    {Rejection::range_jump, "range_jump",
     "the range differs by more than jump_filter_m from the reading before of its sensor",
     "Nothing to do: this is what the filter is for; raise jump_filter_m to keep more."},
    {Rejection::stamp_uncertain, "stamp_uncertain", "when it was fired is known too loosely for the robot's speed",
     "Drive slower or poll more often; to keep such pings, raise max_stamp_error_m and max_stamp_turn_deg."},
}};

/// What `RejectionTally::first_value` is for a reason.
std::string value_text(Rejection reason, double value) {
  if (reason == Rejection::unknown_sensor) return "sensor " + to_text(value);
  const bool of_time = reason == Rejection::bad_time || reason == Rejection::time_backwards ||
                       reason == Rejection::stamp_uncertain || reason == Rejection::no_pose ||
                       reason == Rejection::pose_gap;
  if (of_time) return "t = " + to_text(value) + " s";
  return to_text(value) + " m";
}

}  // namespace

std::span<const RejectionInfo, rejection_count> rejections() {
  return table;
}

const RejectionInfo& info(Rejection reason) {
  return table[static_cast<std::size_t>(reason)];
}

void RejectionCounters::add(Rejection reason, std::uint64_t line, std::uint64_t index, double value) {
  RejectionTally& tally = tallies_[static_cast<std::size_t>(reason)];
  if (tally.count++ > 0) return;
  tally.first_line = line;
  tally.first_index = index;
  tally.first_value = value;
}

std::uint64_t RejectionCounters::total() const {
  return std::accumulate(tallies_.begin(), tallies_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const RejectionTally& tally) { return sum + tally.count; });
}

std::string describe(Rejection reason, const RejectionTally& tally, std::string_view kind) {
  const RejectionInfo& about = info(reason);
  const std::string first = tally.first_line > 0 ? "line " + std::to_string(tally.first_line)
                                                 : "record " + std::to_string(tally.first_index + 1);
  return std::string(about.name) + ": " + std::to_string(tally.count) + " " + std::string(kind) +
         (tally.count == 1 ? "" : "s") + ", first at " + first + " (" + value_text(reason, tally.first_value) +
         "): " + std::string(about.explanation) + ". " + std::string(about.remedy);
}

}  // namespace echoarc
