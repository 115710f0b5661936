// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/workload.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "echoarc/core/rng.hpp"

namespace echoarc::bench {
namespace {

constexpr double margin_m = 2.0;
constexpr double firing_interval_s = 0.040;
constexpr double speed_mps = 0.30;
constexpr double range_noise_m = 0.005;
constexpr int sonars = 16;
constexpr double ring_radius_m = 0.23;

/// The loop, with slow sideways waves so that no lap repeats another.
Pose2 robot_at(const WorkloadOptions& options, double time_s) {
  const double lap =
      speed_mps * time_s / std::hypot(options.loop_half_x_m, options.loop_half_y_m) * std::numbers::sqrt2;
  const double wave = 1.0 + 0.06 * std::sin(2.37 * lap);
  const Vec2 middle = 0.5 * options.scene.size;
  const Vec2 position = {options.loop_half_x_m * wave * std::cos(lap), options.loop_half_y_m * wave * std::sin(lap)};
  return {middle + position, radians(lap + std::numbers::pi / 2 + 0.2 * std::sin(5.1 * lap))};
}

SensorModel workload_sonar(const WorkloadOptions& options) {
  SensorModel model;
  model.beam_width = degrees(25.0);
  model.range_min_m = 0.15;
  model.range_max_m = options.range_max_m;
  model.trusted_range_m = options.range_max_m;
  model.no_echo.kind = NoEchoRule::Kind::inf;
  return model;
}

Outcome listen(const WorkloadOptions& options, const Pose2& T_world_sensor, Angle beam_width, Rng& rng) {
  const double surface_m = nearest_surface_m(options.scene, T_world_sensor, beam_width);
  const double range_m = surface_m + rng.normal(0.0, range_noise_m);
  if (range_m > options.range_max_m) return NoEcho{};
  return Echo{range_m};
}

}  // namespace

std::vector<Reading> make_workload(const WorkloadOptions& options) {
  Rng rng(options.seed);
  const std::vector<Sensor> sensors = ring(sonars, ring_radius_m, degrees(0.0), workload_sonar(options));
  std::vector<Reading> readings(options.readings);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const Sensor& sensor = sensors[k % sensors.size()];
    Reading& r = readings[k];
    r.ping = k;
    r.time_s = double(k) * firing_interval_s;
    r.scan = std::uint32_t(k / sensors.size());
    r.tx = r.rx = sensor.id;
    r.T_world_robot = robot_at(options, r.time_s);
    r.T_world_tx = r.T_world_rx = r.T_world_robot * sensor.mount.T_robot_sensor();
    r.beam_width = sensor.model.beam_width;
    r.range_min_m = sensor.model.range_min_m;
    r.range_max_m = sensor.model.range_max_m;
    r.trusted_range_m = sensor.model.trusted_range_m;
    r.outcome = listen(options, r.T_world_tx, r.beam_width, rng);
  }
  return readings;
}

Log make_workload_log(const WorkloadOptions& options) {
  Log log;
  log.source = "workload";
  log.robot.name = "ring16";
  log.robot.radius_m = ring_radius_m;
  log.robot.sensors = SensorArray::make(ring(sonars, ring_radius_m, degrees(0.0), workload_sonar(options))).value();
  for (const Reading& r : make_workload(options)) {
    if (r.ping % sonars == 0) log.odometry.push_back({r.time_s, r.T_world_robot});
    log.pings.push_back({.time_s = r.time_s,
                         .tx = r.tx,
                         .rx = r.rx,
                         .range_m = echo_range_m(r.outcome).value_or(std::numeric_limits<double>::infinity())});
  }
  log.odometry.push_back({log.pings.back().time_s, robot_at(options, log.pings.back().time_s)});
  return log;
}

DenseArea workload_area(double cell_m) {
  const Vec2 size = hall().size;
  const auto cells = [&](double length_m) { return std::int32_t(std::lround(length_m / cell_m)); };
  return {{cell_m, {-margin_m, -margin_m}}, cells(size.x + 2 * margin_m), cells(size.y + 2 * margin_m)};
}

double reach_m(const Reading& reading) {
  return echo_range_m(reading.outcome).value_or(std::min(reading.trusted_range_m, reading.range_max_m));
}

Arc rim_of(const Reading& reading, double margin) {
  const double beyond = is_no_echo(reading.outcome) ? 0.0 : margin;
  return Arc::circular(reading.T_world_tx.position, reading.T_world_tx.heading, reach_m(reading) + beyond,
                       reading.beam_width);
}

WorkloadSummary summarise(std::span<const Reading> readings) {
  WorkloadSummary summary;
  summary.readings = readings.size();
  for (const Reading& reading : readings) {
    const double reach = reach_m(reading);
    summary.mean_range_m += reach;
    summary.no_echo_share += is_no_echo(reading.outcome) ? 1.0 : 0.0;
    summary.sector_area_m2 += 0.5 * reading.beam_width.rad() * reach * reach;
  }
  const double count = std::max<double>(1.0, double(readings.size()));
  summary.mean_range_m /= count;
  summary.no_echo_share /= count;
  summary.sector_area_m2 /= count;
  return summary;
}

}  // namespace echoarc::bench
