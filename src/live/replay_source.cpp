// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/live/replay_source.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "echoarc/sensing/sensing.hpp"

namespace echoarc::live {
namespace {

/// The rules by which the whole log is read, as `sensing_for` has them.
std::vector<NoEchoDecision> decisions(const Log& log) {
  const SensorArray& sensors = log.robot.sensors;
  if (!log.pings.empty()) return decide_no_echo(sensors, log.pings);
  return decide_no_echo(sensors, register_changes(sensors, log.polls));
}

}  // namespace

ReplaySource::ReplaySource(Log log) : log_(std::move(log)) {
  list(Kind::odometry, log_.odometry);
  list(Kind::truth, log_.truth);
  list(Kind::wall, log_.walls);
  list(Kind::scan, log_.scans);
  list(Kind::ping, log_.pings);
  list(Kind::poll, log_.polls);
  std::ranges::sort(order_, {}, [](const Entry& entry) { return std::tuple(entry.time_s, entry.kind, entry.index); });
  description_.name = log_.source;
  description_.title = log_.source;
  description_.frame = log_.frame;
  description_.temperature_k = log_.temperature_k;
  description_.robot = log_.robot;
  description_.no_echo = decisions(log_);
  description_.has_truth = !log_.truth.empty();
  if (order_.empty()) return;
  description_.begin_s = order_.front().time_s;
  description_.end_s = order_.back().time_s;
  time_s_ = description_.begin_s;
}

/// Sorting needs times that can be compared.
template <class Of>
void ReplaySource::list(Kind kind, const std::vector<Of>& records) {
  for (std::size_t k = 0; k < records.size(); ++k)
    if (std::isfinite(records[k].time_s)) order_.push_back({records[k].time_s, kind, k});
}

Result<std::unique_ptr<ReplaySource>> ReplaySource::make(Log log) {
  std::unique_ptr<ReplaySource> source(new ReplaySource(std::move(log)));
  if (source->order_.empty())
    return Error{ErrorCode::bad_format, "the log has no record with a time", source->log_.source,
                 "play a log with odometry and pings"};
  return source;
}

Result<void> ReplaySource::advance(double until_s, std::vector<Record>& records) {
  if (!std::isfinite(until_s) || until_s < time_s_) return {};
  for (; next_ < order_.size() && order_[next_].time_s <= until_s; ++next_) records.push_back(record_of(order_[next_]));
  time_s_ = ended() ? std::min(until_s, *description_.end_s) : until_s;
  return {};
}

void ReplaySource::seek(double time_s) {
  if (!std::isfinite(time_s)) return;
  time_s_ = std::clamp(time_s, description_.begin_s, *description_.end_s);
  // Before its first record the log has said nothing yet.
  next_ = time_s < description_.begin_s
              ? 0
              : static_cast<std::size_t>(std::ranges::upper_bound(order_, time_s, {}, &Entry::time_s) - order_.begin());
}

Record ReplaySource::record_of(const Entry& entry) const {
  switch (entry.kind) {
    case Kind::odometry: return log_.odometry[entry.index];
    case Kind::truth: return Truth{log_.truth[entry.index]};
    case Kind::wall: return log_.walls[entry.index];
    case Kind::scan: return log_.scans[entry.index];
    case Kind::ping: return log_.pings[entry.index];
    case Kind::poll: break;
  }
  return log_.polls[entry.index];
}

}  // namespace echoarc::live
