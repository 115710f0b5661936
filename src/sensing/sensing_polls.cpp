// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Pings out of polled range registers.

#include <algorithm>
#include <cmath>
#include <limits>

#include "echoarc/sensing/sensing.hpp"
#include "echoarc/sensing/stamp_bound.hpp"

namespace echoarc {
namespace {

FiringTiming timing_of(const SensorArray& sensors, const SensingOptions& options, double temperature_k) {
  FiringTiming timing{.gap_min_s = options.poll_gap_min_s,
                      .gap_max_s = std::max(options.poll_gap_min_s, options.poll_gap_max_s),
                      .time_out_s = {}};
  for (const Sensor& sensor : sensors.sensors())
    timing.time_out_s.push_back(flight_time_of_range_s(sensor.model.range_max_m, temperature_k));
  return timing;
}

bool same_register(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

void Sensing::push(const Poll& poll) {
  if (sensors_.empty()) return;
  if (options_.polling == Polling::naive) return push_naive(poll);
  if (!stamper_) stamper_.emplace(timing_of(sensors_, options_, recorded_temperature_k_));
  std::vector<double> flight_s;
  const std::size_t known = std::min(poll.ranges_m.size(), sensors_.size());
  for (std::size_t k = 0; k < known; ++k) {
    const SensorModel& model = sensors_.sensors()[k].model;
    // What the range was computed from is the measured time, whatever the air was.
    const DecodedRange decoded = decode_range(poll.ranges_m[k], report_.no_echo[k], model);
    const auto echo_m = echo_range_m(decoded.outcome);
    const double range_m = echo_m ? *echo_m
                           : is_no_echo(decoded.outcome) && !decoded.rejection
                               ? model.range_max_m
                               : std::numeric_limits<double>::quiet_NaN();
    flight_s.push_back(flight_time_of_range_s(range_m, recorded_temperature_k_));
  }
  stamper_->push(poll, flight_s);
  take_firings();
}

void Sensing::end_of_polls() {
  if (!stamper_) return;
  stamper_->finish();
  take_firings();
}

void Sensing::take_firings() {
  for (const StampedFiring& firing : stamper_->firings()) {
    const SensorId id = sensors_.sensors()[firing.sensor].id;
    queue({.time_s = firing.fired.middle_s(), .tx = id, .rx = id, .range_m = firing.register_m, .line = firing.line},
          firing.fired.half_width_s());
  }
  stamper_->clear();
  report_.polls = stamper_->counters();
}

/// A register that changed becomes a ping at the time of the poll that shows it ([Silver04] Fig. 14).
void Sensing::push_naive(const Poll& poll) {
  ++report_.polls.polls;
  const bool late = newest_poll_s_ && !(poll.time_s > *newest_poll_s_);
  if (poll.ranges_m.size() != sensors_.size() || late || !std::isfinite(poll.time_s)) {
    ++report_.polls.bad_polls;
    return;
  }
  for (std::size_t k = 0; k < sensors_.size() && newest_poll_s_; ++k)
    if (!same_register(poll.ranges_m[k], registers_[k])) {
      const SensorId id = sensors_.sensors()[k].id;
      queue({.time_s = poll.time_s, .tx = id, .rx = id, .range_m = poll.ranges_m[k], .line = poll.line}, 0.0);
    }
  registers_ = poll.ranges_m;
  newest_poll_s_ = poll.time_s;
}

bool Sensing::stamped_too_loosely(const Waiting& waiting) const {
  const double w_s = waiting.stamp_half_width_s;
  if (w_s <= 0.0) return false;
  const Mount& mount = sensors_.find(waiting.ping.rx)->mount;
  const TimeInterval fired{waiting.ping.time_s - w_s, waiting.ping.time_s + w_s};
  const StampBound bound = stamp_bound(track_.samples(), fired, norm(mount.T_robot_sensor().position));
  return bound.position_m > options_.max_stamp_error_m || bound.turn > options_.max_stamp_turn;
}

std::vector<Ping> register_changes(const SensorArray& sensors, std::span<const Poll> polls) {
  std::vector<Ping> changes;
  const std::vector<double>* before = nullptr;
  for (const Poll& poll : polls) {
    if (poll.ranges_m.size() != sensors.size()) continue;
    for (std::size_t k = 0; k < sensors.size() && before != nullptr; ++k)
      if (!same_register(poll.ranges_m[k], (*before)[k])) {
        const SensorId id = sensors.sensors()[k].id;
        changes.push_back({.time_s = poll.time_s, .tx = id, .rx = id, .range_m = poll.ranges_m[k], .line = poll.line});
      }
    before = &poll.ranges_m;
  }
  return changes;
}

}  // namespace echoarc
