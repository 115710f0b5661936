// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/sensing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "echoarc/core/arc.hpp"

namespace echoarc {
namespace {

/// The number that made a ping unusable, for the report.
double offending_value(const Ping& ping, Rejection reason) {
  switch (reason) {
    case Rejection::unknown_sensor: return ping.rx;
    case Rejection::bad_time:
    case Rejection::time_backwards:
    case Rejection::stamp_uncertain:
    case Rejection::no_pose:
    case Rejection::pose_gap: return ping.time_s;
    default: return ping.range_m;
  }
}

Rejection reason_of(PoseTrack::Refusal refusal) {
  switch (refusal) {
    case PoseTrack::Refusal::bad_pose: return Rejection::bad_pose;
    case PoseTrack::Refusal::backwards: return Rejection::time_backwards;
    case PoseTrack::Refusal::duplicate: return Rejection::duplicate;
    case PoseTrack::Refusal::bad_time: break;
  }
  return Rejection::bad_time;
}

Rejection reason_of(LaserLimiter::Refusal refusal) {
  switch (refusal) {
    case LaserLimiter::Refusal::unknown_laser: return Rejection::unknown_sensor;
    case LaserLimiter::Refusal::backwards: return Rejection::time_backwards;
    case LaserLimiter::Refusal::bad_time: break;
  }
  return Rejection::bad_time;
}

Rejection reason_of(PoseTrack::Missing missing) {
  return missing == PoseTrack::Missing::gap ? Rejection::pose_gap : Rejection::no_pose;
}

}  // namespace

Sensing::Sensing(SensorArray sensors, const SensingOptions& options, std::vector<NoEchoDecision> no_echo,
                 double recorded_temperature_k)
    : sensors_(std::move(sensors)),
      options_(options),
      recorded_temperature_k_(recorded_temperature_k),
      track_(options.max_pose_gap_s, options.max_time_jump_s) {
  assert(no_echo.empty() || no_echo.size() == sensors_.size());
  report_.no_echo = std::move(no_echo);
  const bool undecided = report_.no_echo.empty();
  for (const Sensor& sensor : sensors_.sensors()) {
    report_.sensors.push_back({.sensor = sensor.id});
    if (undecided) report_.no_echo.push_back(describe_no_echo(sensor));
  }
}

void Sensing::use_lasers(const std::vector<LaserMount>& lasers) {
  assert(report_.pings == 0);
  limited_beside_ = options_.laser_limit == LaserLimit::none;
  limiter_.emplace(lasers, limited_beside_ ? LaserLimit::cone_min : options_.laser_limit, options_.laser_max_age_s);
}

void Sensing::push(const Scan& scan) {
  if (!limiter_) return;
  const std::uint64_t index = report_.scans++;
  if (const auto refusal = limiter_->push(scan)) {
    const bool unknown = *refusal == LaserLimiter::Refusal::unknown_laser;
    report_.rejected_scans.add(reason_of(*refusal), scan.line, index, unknown ? double(scan.laser) : scan.time_s);
  }
}

void Sensing::push(const Odometry& sample) {
  const std::uint64_t index = report_.odometry++;
  if (const auto refusal = track_.push(sample)) {
    const Rejection reason = reason_of(*refusal);
    const bool of_pose = reason == Rejection::bad_pose;
    report_.rejected_odometry.add(reason, sample.line, index,
                                  of_pose ? sample.T_world_robot.position.x : sample.time_s);
    return;
  }
  drain();
}

void Sensing::push(const WallNote& note) {
  const std::uint64_t index = report_.walls++;
  if (!std::isfinite(note.time_s))
    report_.rejected_walls.add(Rejection::bad_time, note.line, index, note.time_s);
  else if (!walls_.empty() && note.time_s < walls_.back().time_s)
    report_.rejected_walls.add(Rejection::time_backwards, note.line, index, note.time_s);
  else
    walls_.push_back(note);
}

void Sensing::push(const Ping& ping) {
  queue(ping, 0.0);
}

void Sensing::queue(const Ping& ping, double stamp_half_width_s) {
  const Waiting waiting{ping, report_.pings++, stamp_half_width_s};
  if (waiting_.size() >= max_waiting) {
    reject(waiting, Rejection::no_pose);
    return;
  }
  waiting_.push_back(waiting);
  drain();
}

void Sensing::end_of_odometry() {
  odometry_ended_ = true;
  drain();
}

bool Sensing::can_settle(const Waiting& waiting) const {
  const Ping& ping = waiting.ping;
  if (odometry_ended_ || !std::isfinite(ping.time_s)) return true;
  if (track_.empty()) return false;
  const double known_s =
      track_.newest_s() - std::max(limiter_ ? options_.laser_max_age_s : 0.0, waiting.stamp_half_width_s);
  return ping.time_s <= known_s || ping.time_s > track_.newest_s() + options_.max_wait_s;
}

void Sensing::drain() {
  while (!waiting_.empty() && can_settle(waiting_.front())) {
    settle(waiting_.front());
    waiting_.pop_front();
  }
  report_.waiting = waiting_.size();
}

std::optional<Rejection> Sensing::check_identity(const Ping& ping) const {
  if (sensors_.find(ping.tx) == nullptr || sensors_.find(ping.rx) == nullptr) return Rejection::unknown_sensor;
  if (!std::isfinite(ping.time_s)) return Rejection::bad_time;
  if (ping.echo_index > 0) return Rejection::later_echo;
  if (newest_ping_s_ && ping.time_s < *newest_ping_s_) return Rejection::time_backwards;
  if (scans_.repeats(ping)) return Rejection::duplicate;
  return std::nullopt;
}

void Sensing::settle(const Waiting& waiting) {
  const Ping& ping = waiting.ping;
  if (const auto reason = check_identity(ping)) return reject(waiting, *reason);
  const std::variant<Pose2, PoseTrack::Missing> pose = track_.at(ping.time_s);
  if (const auto* missing = std::get_if<PoseTrack::Missing>(&pose)) return reject(waiting, reason_of(*missing));
  // Only now is the stamp known to be sane: a wild one must not make the pings after it look late.
  newest_ping_s_ = ping.time_s;
  if (stamped_too_loosely(waiting)) return reject(waiting, Rejection::stamp_uncertain);
  const std::uint32_t scan = scans_.number(ping);
  const DecodedRange decoded = decode(ping);
  if (decoded.rejection) return reject(waiting, *decoded.rejection);
  const Reading reading = make_reading(waiting, std::get<Pose2>(pose), decoded.outcome, scan);
  const double foci_m = norm(reading.T_world_rx.position - reading.T_world_tx.position);
  const auto range_m = echo_range_m(reading.outcome);
  if (!reading.monostatic() && range_m && 2.0 * *range_m <= foci_m + eps_length_m)
    return reject(waiting, Rejection::path_too_short);
  if (const auto reason = filter(reading)) return reject(waiting, *reason);
  accept(reading);
}

std::optional<Rejection> Sensing::filter(const Reading& reading) {
  // What is cut is still what the sensor said: the next reading is compared with it.
  const bool jumps = options_.jump_filter_m > 0.0 && jumps_.jumps(reading, options_.jump_filter_m);
  const auto range_m = echo_range_m(reading.outcome);
  if (options_.range_cut_m > 0.0 && range_m && *range_m > options_.range_cut_m + eps_length_m)
    return Rejection::range_cut;
  return jumps ? std::optional(Rejection::range_jump) : std::nullopt;
}

DecodedRange Sensing::decode(const Ping& ping) const {
  const Sensor& receiver = *sensors_.find(ping.rx);
  const auto place = static_cast<std::size_t>(&receiver - sensors_.sensors().data());
  // Codes and limits are the hardware's, in the hardware's metres; the air matters to true ranges alone.
  DecodedRange decoded = decode_range(ping.range_m, report_.no_echo[place], receiver.model);
  if (decoded.rejection == Rejection::below_min_range && options_.below_minimum == BelowMinimum::too_close)
    return {TooClose{}, std::nullopt};
  const double air_k = options_.air_temperature_k;
  if (auto* echo = std::get_if<Echo>(&decoded.outcome); echo != nullptr && air_k > 0.0)
    echo->range_m = ping.time_of_flight_s > 0.0 ? range_of_flight_time_m(ping.time_of_flight_s, air_k)
                                                : echo->range_m * rerange_factor(recorded_temperature_k_, air_k);
  return decoded;
}

Reading Sensing::make_reading(const Waiting& waiting, const Pose2& T_world_robot, const Outcome& outcome,
                              std::uint32_t scan) const {
  const Sensor& tx = *sensors_.find(waiting.ping.tx);
  const Sensor& rx = *sensors_.find(waiting.ping.rx);
  const double trusted_m = options_.trusted_range_m > 0.0 ? options_.trusted_range_m : rx.model.trusted_range_m;
  Reading reading;
  reading.ping = waiting.id;
  reading.time_s = waiting.ping.time_s;
  reading.scan = scan;
  reading.tx = tx.id;
  reading.rx = rx.id;
  reading.T_world_robot = T_world_robot;
  reading.T_world_tx = T_world_robot * tx.mount.T_robot_sensor();
  reading.T_world_rx = T_world_robot * rx.mount.T_robot_sensor();
  reading.beam_width = rx.model.beam_width;
  reading.range_min_m = rx.model.range_min_m;
  reading.range_max_m = rx.model.range_max_m;
  reading.trusted_range_m = std::min(trusted_m, rx.model.range_max_m);
  reading.outcome = outcome;
  reading.wall = wall_at(waiting.ping.time_s);
  return reading;
}

WallSide Sensing::wall_at(double time_s) const {
  const auto after = std::ranges::upper_bound(walls_, time_s, {}, &WallNote::time_s);
  return after == walls_.begin() ? WallSide::unknown : (after - 1)->side;
}

void Sensing::accept(const Reading& reading) {
  SensorTally& tally = *tally_of(reading.rx);
  if (std::holds_alternative<Echo>(reading.outcome)) {
    ++report_.echoes;
    ++tally.echoes;
  } else if (is_no_echo(reading.outcome)) {
    ++report_.no_echoes;
    ++tally.no_echoes;
  } else {
    ++report_.too_close;
    ++tally.too_close;
  }
  if (!limiter_) {
    readings_.push_back(reading);
    return;
  }
  const Reading limited = limiter_->limited(reading, track_);
  report_.laser_limited += limited.laser_limited ? 1 : 0;
  readings_.push_back(limited_beside_ ? reading : limited);
  if (limited_beside_) limited_.push_back(limited);
}

void Sensing::reject(const Waiting& waiting, Rejection reason) {
  const Ping& ping = waiting.ping;
  report_.rejected_pings.add(reason, ping.line, waiting.id, offending_value(ping, reason));
  if (SensorTally* tally = tally_of(ping.rx)) ++tally->rejected[static_cast<std::size_t>(reason)];
  if (watcher_) watcher_(ping, waiting.id, reason);
}

SensorTally* Sensing::tally_of(SensorId sensor) {
  const auto found = std::ranges::lower_bound(report_.sensors, sensor, {}, &SensorTally::sensor);
  return found != report_.sensors.end() && found->sensor == sensor ? &*found : nullptr;
}

SensedLog sense(const Log& log, const SensingOptions& options) {
  Sensing sensing = sensing_for(log, options);
  for (const Ping& ping : log.pings) sensing.push(ping);
  if (log.pings.empty())
    for (const Poll& poll : log.polls) sensing.push(poll);
  sensing.end_of_polls();
  const std::span<const Reading> readings = sensing.readings();
  return {{readings.begin(), readings.end()}, sensing.report()};
}

Sensing sensing_for(const Log& log, const SensingOptions& options, bool limited_beside) {
  const SensorArray& sensors = log.robot.sensors;
  const std::vector<Ping> polled = log.pings.empty() ? register_changes(sensors, log.polls) : std::vector<Ping>{};
  const std::span<const Ping> values = log.pings.empty() ? std::span<const Ping>(polled) : log.pings;
  Sensing sensing(sensors, options, decide_no_echo(sensors, values), log.temperature_k);
  if (limited_beside || options.laser_limit != LaserLimit::none) sensing.use_lasers(log.robot.lasers);
  for (const Scan& scan : log.scans) sensing.push(scan);
  for (const Odometry& sample : log.odometry) sensing.push(sample);
  for (const WallNote& note : log.walls) sensing.push(note);
  sensing.end_of_odometry();
  return sensing;
}

}  // namespace echoarc
