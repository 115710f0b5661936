// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sensing/log_statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "echoarc/core/pose_track.hpp"

namespace echoarc {
namespace {

/// Times seen so far, NaN while there are none.
struct TimeSpan {
  double begin_s = SensorStatistics::unknown;
  double end_s = SensorStatistics::unknown;

  void add(double time_s) {
    if (!std::isfinite(time_s)) return;
    begin_s = std::fmin(begin_s, time_s);  // fmin and fmax pass over NaN
    end_s = std::fmax(end_s, time_s);
  }
  [[nodiscard]] double length_s() const { return end_s - begin_s; }
};

/// Counts one sensor's pings.
class SensorCounter {
 public:
  SensorCounter(const Sensor& sensor, const NoEchoDecision& no_echo) : sensor_(&sensor), no_echo_(&no_echo) {
    counted_.sensor = sensor.id;
  }

  void add(const Ping& ping) {
    ++counted_.pings;
    times_.add(ping.time_s);
    const DecodedRange decoded = decode_range(ping.range_m, *no_echo_, sensor_->model);
    if (decoded.rejection || std::holds_alternative<Invalid>(decoded.outcome)) {
      ++counted_.unusable;
    } else if (const auto range_m = echo_range_m(decoded.outcome)) {
      ++counted_.echoes;
      ranges_m_.push_back(*range_m);
    } else {
      ++(is_no_echo(decoded.outcome) ? counted_.no_echoes : counted_.too_close);
    }
  }

  [[nodiscard]] SensorStatistics finish() {
    if (times_.length_s() > 0.0) counted_.rate_hz = static_cast<double>(counted_.pings - 1) / times_.length_s();
    if (ranges_m_.empty()) return counted_;
    std::ranges::sort(ranges_m_);
    counted_.range_min_m = ranges_m_.front();
    counted_.range_median_m = ranges_m_[(ranges_m_.size() - 1) / 2];
    counted_.range_max_m = ranges_m_.back();
    return counted_;
  }

 private:
  const Sensor* sensor_;
  const NoEchoDecision* no_echo_;
  SensorStatistics counted_;
  TimeSpan times_;
  std::vector<double> ranges_m_;
};

double path_length_m(std::span<const Odometry> odometry) {
  PoseTrack track;
  for (const Odometry& sample : odometry) (void)track.push(sample);  // what it refuses is no part of the way
  double length_m = 0.0;
  for (std::size_t k = 1; k < track.samples().size(); ++k)
    length_m += norm(track.samples()[k].T_world_robot.position - track.samples()[k - 1].T_world_robot.position);
  return length_m;
}

}  // namespace

LogStatistics log_statistics(const Log& log, std::span<const NoEchoDecision> no_echo) {
  const std::span<const Sensor> sensors = log.robot.sensors.sensors();
  assert(no_echo.size() == sensors.size());
  std::vector<SensorCounter> counters;
  for (std::size_t k = 0; k < sensors.size(); ++k) counters.emplace_back(sensors[k], no_echo[k]);
  LogStatistics statistics;
  TimeSpan times;
  for (const Ping& ping : log.pings) {
    times.add(ping.time_s);
    if (const Sensor* sensor = log.robot.sensors.find(ping.rx))
      counters[static_cast<std::size_t>(sensor - sensors.data())].add(ping);
    else
      ++statistics.unknown_sensor_pings;
  }
  for (const Odometry& sample : log.odometry) times.add(sample.time_s);
  for (const Scan& scan : log.scans) times.add(scan.time_s);
  for (SensorCounter& counter : counters) statistics.sensors.push_back(counter.finish());
  statistics.begin_s = times.begin_s;
  statistics.end_s = times.end_s;
  statistics.path_m = path_length_m(log.odometry);
  return statistics;
}

}  // namespace echoarc
