// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "live/mapper_state.hpp"

namespace echoarc::live {
namespace {

/// A timeline of eleven days; later pings are counted in its last bin.
constexpr std::size_t max_bins = 1'000'000;

double said_by(const Reading& reading) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (const auto range_m = echo_range_m(reading.outcome)) return *range_m;
  return is_no_echo(reading.outcome) ? infinity : -infinity;
}

}  // namespace

JudgedStream::JudgedStream(const SourceDescription& source, const SensingOptions& options, bool limited)
    : sensors_(source.robot.sensors),
      sensing_(source.robot.sensors, options, source.no_echo, source.temperature_k),
      limited_(limited) {
  if (limited || options.laser_limit != LaserLimit::none) sensing_.use_lasers(source.robot.lasers);
  sensing_.watch_rejections([this](const Ping& ping, PingId id, Rejection reason) { take_rejected(ping, id, reason); });
}

void JudgedStream::push(const Ping& ping) {
  raw_m_.emplace_back(sensing_.report().pings, ping.range_m);
  sensing_.push(ping);
  take_accepted();
}

void JudgedStream::end() {
  sensing_.end_of_polls();
  sensing_.end_of_odometry();
  take_accepted();
}

void JudgedStream::mark() {
  if (log_.size() > 0 && (marks_.empty() || marks_.back() < log_.size())) marks_.push_back(log_.size());
}

void JudgedStream::take_accepted() {
  const std::span<const Reading> readings = limited_ ? sensing_.limited_readings() : sensing_.readings();
  for (const Reading& reading : readings.subspan(taken_))
    log_.append({reading, std::nullopt, take_raw_range(reading.ping).value_or(said_by(reading))});
  sensing_.clear_readings();
  taken_ = 0;
}

void JudgedStream::take_rejected(const Ping& ping, PingId id, Rejection reason) {
  // Readings made before this ping come before it; the sensing is in the middle of its work and keeps them.
  const std::span<const Reading> readings = limited_ ? sensing_.limited_readings() : sensing_.readings();
  for (; taken_ < readings.size(); ++taken_)
    log_.append(
        {readings[taken_], std::nullopt, take_raw_range(readings[taken_].ping).value_or(said_by(readings[taken_]))});
  JudgedPing judged{{}, reason, take_raw_range(id).value_or(ping.range_m)};
  Reading& reading = judged.reading;
  reading.ping = id;
  reading.time_s = ping.time_s;
  reading.tx = ping.tx;
  reading.rx = ping.rx;
  reading.outcome = Invalid{};
  reading.T_world_robot = pose_near(ping.time_s);
  reading.T_world_tx = reading.T_world_rx = reading.T_world_robot;
  if (const Sensor* tx = sensors_.find(ping.tx))
    reading.T_world_tx = reading.T_world_robot * tx->mount.T_robot_sensor();
  if (const Sensor* rx = sensors_.find(ping.rx)) {
    reading.T_world_rx = reading.T_world_robot * rx->mount.T_robot_sensor();
    reading.beam_width = rx->model.beam_width;
    reading.range_min_m = rx->model.range_min_m;
    reading.range_max_m = rx->model.range_max_m;
    reading.trusted_range_m = rx->model.trusted_range_m;
  }
  log_.append(judged);
}

Pose2 JudgedStream::pose_near(double time_s) const {
  const PoseTrack& track = sensing_.track();
  const std::variant<Pose2, PoseTrack::Missing> pose = track.at(time_s);
  if (const auto* known = std::get_if<Pose2>(&pose)) return *known;
  return track.empty() ? Pose2{} : track.samples().back().T_world_robot;
}

std::optional<double> JudgedStream::take_raw_range(PingId ping) {
  const auto is = [&](const auto& raw) { return raw.first == ping; };
  // Pings are judged in their order, all but those that are given up while too many wait.
  const auto found = std::ranges::find_if(raw_m_, is);
  if (found == raw_m_.end()) return std::nullopt;
  const double range_m = found->second;
  raw_m_.erase(found);
  return range_m;
}

void TimelineBins::add(const JudgedPing& ping, double begin_s, double newest_s) {
  // A wild stamp must not stretch the timeline: such pings count where the records are by now.
  const double time_s = std::isfinite(ping.reading.time_s) ? ping.reading.time_s : newest_s;
  const double since_s = std::clamp(time_s, begin_s, std::max(begin_s, newest_s)) - begin_s;
  const auto bin = std::min(std::size_t(since_s / Mapper::timeline_bin_s), max_bins - 1);
  if (bin >= bins_.size()) bins_.resize(bin + 1);
  if (ping.rejected)
    ++bins_[bin].rejected;
  else if (is_no_echo(ping.reading.outcome))
    ++bins_[bin].no_echoes;
  else
    ++bins_[bin].echoes;
}

void NewestScan::place(const PoseTrack& track, std::span<const LaserMount> lasers) {
  if (!waiting_ || track.empty() || !(waiting_->time_s <= track.newest_s())) return;
  const Scan scan = *std::exchange(waiting_, std::nullopt);
  const auto laser = std::ranges::find(lasers, scan.laser, &LaserMount::id);
  const std::variant<Pose2, PoseTrack::Missing> pose = track.at(scan.time_s);
  const auto* T_world_robot = std::get_if<Pose2>(&pose);
  if (laser == lasers.end() || T_world_robot == nullptr) return;
  const Pose2 T_world_laser = *T_world_robot * laser->mount.T_robot_sensor();
  returns_.clear();
  for (std::size_t k = 0; k < scan.ranges_m.size(); ++k) {
    const double range_m = double(scan.ranges_m[k]);
    if (!(range_m >= laser->range_min_m && range_m < laser->range_max_m)) continue;
    returns_.push_back(T_world_laser * (range_m * unit(scan.angle_min + double(k) * scan.angle_step)));
  }
}

}  // namespace echoarc::live
