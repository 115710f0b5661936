// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "sensing/findings.hpp"

namespace echoarc {
namespace {

constexpr std::size_t enough_pings = 20;  // fewer say nothing about a rhythm

struct TimeSpan {
  double begin_s = std::numeric_limits<double>::infinity();
  double end_s = -std::numeric_limits<double>::infinity();
  [[nodiscard]] double length_s() const { return end_s - begin_s; }
};

template <class Record>
TimeSpan span_of(const std::vector<Record>& records) {
  TimeSpan span;
  for (const Record& record : records) {
    if (!std::isfinite(record.time_s)) continue;
    span.begin_s = std::min(span.begin_s, record.time_s);
    span.end_s = std::max(span.end_s, record.time_s);
  }
  return span;
}

std::string text_of(const TimeSpan& span) {
  return number_text(span.begin_s, 3) + " to " + number_text(span.end_s, 3) + " s";
}

template <class Record>
void find_zero_stamps(const std::vector<Record>& records, std::string_view kind, Findings& findings) {
  const auto zeros = static_cast<std::size_t>(std::ranges::count(records, 0.0, &Record::time_s));
  if (zeros < enough_pings || 10 * zeros < records.size()) return;
  findings.push_back(
      {Severity::error, "zero_stamps",
       std::to_string(zeros) + " of " + std::to_string(records.size()) + " " + std::string(kind) + " are stamped 0",
       "stamp every record where it is measured; a microcontroller needs its clock set before it sends"});
}

void find_separate_clocks(const Log& log, Findings& findings) {
  if (log.odometry.empty() || log.pings.empty()) return;
  const TimeSpan pings = span_of(log.pings);
  const TimeSpan odometry = span_of(log.odometry);
  const double common_s = std::min(pings.end_s, odometry.end_s) - std::max(pings.begin_s, odometry.begin_s);
  if (!(pings.length_s() >= 0.0) || common_s >= 0.5 * pings.length_s()) return;
  findings.push_back({common_s < 0.0 ? Severity::error : Severity::warning, "separate_clocks",
                      "pings run from " + text_of(pings) + ", odometry from " + text_of(odometry),
                      "stamp both with one clock, or add the offset to one of them"});
}

/// Intervals between the pings of one sensor, in ascending order; empty for too few.
std::vector<double> sorted_intervals(const std::vector<Ping>& pings) {
  std::vector<double> intervals;
  for (std::size_t k = 1; k < pings.size(); ++k)
    if (const double dt = pings[k].time_s - pings[k - 1].time_s; std::isfinite(dt) && dt > 0.0) intervals.push_back(dt);
  if (intervals.size() < enough_pings) intervals.clear();
  std::ranges::sort(intervals);
  return intervals;
}

/// Stamps given on arrival bunch up: several at once when a buffer is emptied, then a pause.
bool bunched(const std::vector<double>& intervals) {
  if (intervals.empty()) return false;
  const double mean = std::accumulate(intervals.begin(), intervals.end(), 0.0) / static_cast<double>(intervals.size());
  const auto short_ones = std::ranges::upper_bound(intervals, 0.2 * mean) - intervals.begin();
  return 4 * short_ones > static_cast<std::ptrdiff_t>(intervals.size());
}

}  // namespace

void find_odd_clocks(const Log& log, const PingsBySensor& pings, Findings& findings) {
  find_zero_stamps(log.pings, "pings", findings);
  find_zero_stamps(log.odometry, "poses", findings);
  find_separate_clocks(log, findings);
  std::vector<SensorId> bunching;
  std::vector<SensorId> slow;
  std::vector<SensorId> repeating;
  for (const auto& [sensor, own] : pings) {
    const std::vector<double> intervals = sorted_intervals(own);
    if (bunched(intervals)) bunching.push_back(sensor);
    if (!intervals.empty() && intervals[intervals.size() / 2] > 20.0) slow.push_back(sensor);
    std::size_t repeats = 0;
    for (std::size_t k = 1; k < own.size(); ++k)
      repeats += own[k].time_s == own[k - 1].time_s && own[k].range_m != own[k - 1].range_m &&
                         own[k].echo_index == own[k - 1].echo_index
                     ? 1
                     : 0;
    if (own.size() >= enough_pings && 20 * repeats > own.size()) repeating.push_back(sensor);
  }
  if (!bunching.empty())
    findings.push_back({Severity::warning, "receive_time_stamps",
                        sensor_text(bunching) + ": pings come in bunches with pauses between, as if stamped on arrival",
                        "stamp pings when they are fired, not when the message is read"});
  if (!repeating.empty())
    findings.push_back({Severity::warning, "repeated_stamps",
                        sensor_text(repeating) + ": different readings of one sensor bear the same time",
                        "write time stamps with more digits, or stamp each ping by itself"});
  if (!slow.empty())
    findings.push_back({Severity::warning, "slow_pings", sensor_text(slow) + ": more than 20 s between pings",
                        "check the unit of time: seconds, not milliseconds"});
}

}  // namespace echoarc
