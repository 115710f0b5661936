// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/workload.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "echoarc/core/rng.hpp"

namespace echoarc::bench {
namespace {

constexpr double room_x_m = 20.0;
constexpr double room_y_m = 15.0;
constexpr double margin_m = 2.0;
constexpr double firing_interval_s = 0.040;
constexpr double speed_mps = 0.30;
constexpr double range_noise_m = 0.005;
constexpr int sonars = 16;
constexpr double ring_radius_m = 0.23;

struct Segment {
  Vec2 a;
  Vec2 b;
};
struct Circle {
  Vec2 centre;
  double radius_m;
};

constexpr std::array<Segment, 4> sides_of(Vec2 low, Vec2 high) {
  return {{{low, {high.x, low.y}}, {{high.x, low.y}, high}, {high, {low.x, high.y}}, {{low.x, high.y}, low}}};
}

constexpr std::array<std::array<Segment, 4>, 3> boxes = {
    sides_of({0.0, 0.0}, {room_x_m, room_y_m}),  // the room
    sides_of({5.5, 5.5}, {14.5, 9.5}),           // a block in its middle
    sides_of({0.0, 12.0}, {0.6, 14.0}),          // a cabinet against the left wall
};
constexpr std::array<Circle, 4> pillars = {
    {{{3.0, 3.0}, 0.25}, {{17.0, 3.0}, 0.25}, {{17.0, 12.0}, 0.25}, {{3.0, 12.0}, 0.25}}};

/// A beam seen from its apex: points are tested by two cross products, no angles.
struct Beam {
  Vec2 apex;
  Vec2 axis;
  Vec2 low;  // unit vectors along the two edges
  Vec2 high;

  Beam(const Pose2& T_world_sensor, Angle width)
      : apex(T_world_sensor.position),
        axis(unit(T_world_sensor.heading)),
        low(unit(T_world_sensor.heading - width / 2)),
        high(unit(T_world_sensor.heading + width / 2)) {}
  [[nodiscard]] bool holds(Vec2 from_apex) const { return cross(low, from_apex) >= 0 && cross(from_apex, high) >= 0; }
};

constexpr double nothing = std::numeric_limits<double>::infinity();

double distance_in_beam(const Beam& beam, Vec2 from_apex) {
  return beam.holds(from_apex) ? norm(from_apex) : nothing;
}

double along_ray(Vec2 direction, Vec2 a, Vec2 b) {
  const double turn = cross(direction, b - a);
  if (turn == 0.0) return nothing;
  const double range = cross(a, b - a) / turn;
  const double fraction = cross(a, direction) / turn;
  return range >= 0.0 && fraction >= 0.0 && fraction <= 1.0 ? range : nothing;
}

/// Nearest point of a segment inside the beam: the foot of the perpendicular, an end, or where an edge of the beam
/// meets it.
double nearest(const Beam& beam, const Segment& segment) {
  const Vec2 a = segment.a - beam.apex;
  const Vec2 b = segment.b - beam.apex;
  const Vec2 d = b - a;
  const double fraction = std::clamp(-dot(a, d) / squared_norm(d), 0.0, 1.0);
  return std::min({distance_in_beam(beam, a + fraction * d), distance_in_beam(beam, a), distance_in_beam(beam, b),
                   along_ray(beam.low, a, b), along_ray(beam.high, a, b)});
}

double along_ray(Vec2 direction, Vec2 centre, double radius_m) {
  const double along = dot(direction, centre);
  const double inside = radius_m * radius_m - (squared_norm(centre) - along * along);
  return along > 0.0 && inside >= 0.0 ? along - std::sqrt(inside) : nothing;
}

double nearest(const Beam& beam, const Circle& circle) {
  const Vec2 centre = circle.centre - beam.apex;
  const double straight = beam.holds(centre) ? norm(centre) - circle.radius_m : nothing;
  return std::min(
      {straight, along_ray(beam.low, centre, circle.radius_m), along_ray(beam.high, centre, circle.radius_m)});
}

double nearest_surface_m(const Beam& beam) {
  double range = nothing;
  for (const auto& box : boxes)
    for (const Segment& side : box) range = std::min(range, nearest(beam, side));
  for (const Circle& pillar : pillars) range = std::min(range, nearest(beam, pillar));
  return range;
}

/// The loop, with slow sideways waves so that no lap repeats another.
Pose2 robot_at(const WorkloadOptions& options, double time_s) {
  const double lap =
      speed_mps * time_s / std::hypot(options.loop_half_x_m, options.loop_half_y_m) * std::numbers::sqrt2;
  const double wave = 1.0 + 0.06 * std::sin(2.37 * lap);
  const Vec2 middle = {room_x_m / 2, room_y_m / 2};
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
  const double surface_m = nearest_surface_m(Beam(T_world_sensor, beam_width));
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
    log.pings.push_back(
        {.time_s = r.time_s, .tx = r.tx, .rx = r.rx, .range_m = echo_range_m(r.outcome).value_or(nothing)});
  }
  log.odometry.push_back({log.pings.back().time_s, robot_at(options, log.pings.back().time_s)});
  return log;
}

DenseArea workload_area(double cell_m) {
  const auto cells = [&](double length_m) { return std::int32_t(std::lround(length_m / cell_m)); };
  return {{cell_m, {-margin_m, -margin_m}}, cells(room_x_m + 2 * margin_m), cells(room_y_m + 2 * margin_m)};
}

double reach_m(const Reading& reading) {
  return echo_range_m(reading.outcome).value_or(std::min(reading.trusted_range_m, reading.range_max_m));
}

Arc rim_of(const Reading& reading, double margin) {
  const double beyond = is_no_echo(reading.outcome) ? 0.0 : margin;
  return Arc::circular(reading.T_world_tx.position, reading.T_world_tx.heading, reach_m(reading) + beyond,
                       reading.beam_width);
}

WorkloadSummary summarise(const std::vector<Reading>& readings) {
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
