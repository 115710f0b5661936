// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/sonar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "echoarc/core/range_quantum.hpp"
#include "echoarc/core/speed_of_sound.hpp"
#include "sim/random_streams.hpp"
#include "sim/silence.hpp"

namespace echoarc::sim {
namespace {

// A path still under way this long after the longest time-out is forgotten.
constexpr double afterlife_s = 0.1;
// Most that a hollow surface can make an echo louder than a plane: 10 lg 4.
constexpr double most_focus_db = 6.03;
// Echoes closer together than a pulse of 16 periods of 49.4 kHz and its ringing run into one another.
constexpr double echo_separation_s = 0.44e-3;
constexpr std::uint32_t most_echoes = 8;

/// The longest path that can be loud enough, whatever the bearings.
double farthest_audible_m(const SonarOptions& options) {
  if (options.residual_db_per_m <= 0.0) return std::numeric_limits<double>::infinity();
  return 2.0 * (options.flat_range_m + (options.threshold_db + most_focus_db) / options.residual_db_per_m);
}

double time_out_s(const Sensor& sensor, double speed_m_s) {
  return 2.0 * sensor.model.range_max_m / speed_m_s;
}

Transducer transducer_at(const Firing& fired, const Sensor& sensor, Angle half_window) {
  const Pose2 T_world_sensor = fired.T_world_robot * sensor.mount.T_robot_sensor();
  return {T_world_sensor.position, T_world_sensor.heading, half_window};
}

}  // namespace

Sonar::Sonar(const World& world, const SensorArray& array, const SonarOptions& options, std::uint64_t seed)
    : world_(world),
      sensors_(array.sensors()),
      options_(options),
      seed_(seed),
      true_m_s_(speed_of_sound_m_s(options.temperature_k)),
      assumed_m_s_(speed_of_sound_m_s(options.assumed_temperature_k)),
      acoustics_(options),
      finder_(world) {
  double longest_s = 0.0;
  for (const Sensor& sensor : sensors_) longest_s = std::max(longest_s, time_out_s(sensor, assumed_m_s_));
  farthest_m_ = std::min(true_m_s_ * (longest_s + afterlife_s), farthest_audible_m(options));
  memory_s_ = farthest_m_ / true_m_s_;
  const std::size_t listeners = options.listening == Listening::own ? 1 : sensors_.size();
  outlier_share_of_windows_ = options.outlier_share / double(listeners);
}

void Sonar::listen(std::span<const Firing> earlier, const Firing& now, std::vector<Ping>& pings) {
  if (options_.listening == Listening::own) return listen_with(now.sensor, earlier, now, pings);
  for (std::size_t receiver = 0; receiver < sensors_.size(); ++receiver) listen_with(receiver, earlier, now, pings);
}

/// One receiver's window: everything that crosses its threshold while it is open, of this ping and of earlier ones.
void Sonar::listen_with(std::size_t receiver, std::span<const Firing> earlier, const Firing& now,
                        std::vector<Ping>& pings) {
  const Sensor& sensor = sensors_[receiver];
  const Window window = window_of(sensor);
  arrivals_.clear();
  add_paths(now, sensor, 0.0, window);
  if (receiver == now.sensor) add_floor(now, sensor, window);
  if (options_.cross_talk) add_cross_talk(earlier, now, sensor, window);
  std::ranges::stable_sort(arrivals_, {}, &Arrival::delay_s);
  const Ping silent{
      .time_s = now.time_s, .tx = sensors_[now.sensor].id, .rx = sensor.id, .range_m = silence_m(sensor.model)};
  Rng rng = stream(seed_, Draw::ping, now.number, receiver);
  report(silent, window, rng, pings);
}

/// From the end of the blanking to the time-out, or to the next firing where that comes first and is heard.
Sonar::Window Sonar::window_of(const Sensor& receiver) const {
  const double time_out = time_out_s(receiver, assumed_m_s_);
  return {2.0 * receiver.model.range_min_m / assumed_m_s_,
          options_.cross_talk ? std::min(options_.interval_s, time_out) : time_out};
}

/// Arrivals at `receiver` of a ping fired `before_s` before the window's own. The robot's motion in between is left
/// out: everything is where it was when the ping was fired.
void Sonar::add_paths(const Firing& fired, const Sensor& receiver, double before_s, const Window& window) {
  const Transducer from = transducer_at(fired, sensors_[fired.sensor], acoustics_.half_window());
  const Transducer to = transducer_at(fired, receiver, acoustics_.half_window());
  const PathLimits limits = acoustics_.limits(std::min(farthest_m_, true_m_s_ * (before_s + window.closes_s)));
  const std::vector<Disc> moving = world_.moving_at(fired.time_s);
  for (const EchoPath& path : finder_.find(from, to, limits, moving)) {
    const double delay_s = path.length_m / true_m_s_ - before_s;
    if (delay_s < window.opens_s || delay_s >= window.closes_s) continue;
    if (!acoustics_.heard(acoustics_.level_db(path, from.axis, to.axis))) continue;
    arrivals_.push_back({delay_s, before_s > 0.0 ? EchoCause::cross_talk : path.cause});
  }
}

/// How steeply the floor is seen: tilted by the robot's pitch, which changes smoothly on the way and is as large on
/// average everywhere.
Angle Sonar::floor_angle(double travelled_m) const {
  const double knots = travelled_m / options_.pitch_correlation_m;
  const double before = std::floor(knots);
  const Angle blend = degrees(90.0) * (knots - before);
  const auto knot = static_cast<std::uint64_t>(before);
  const double pitch = cos(blend) * stream(seed_, Draw::pitch, knot).normal(0.0, 1.0) +
                       sin(blend) * stream(seed_, Draw::pitch, knot + 1).normal(0.0, 1.0);
  return options_.floor_angle + pitch * options_.pitch_sigma;
}

/// The floor, unless something stands before it.
void Sonar::add_floor(const Firing& now, const Sensor& sensor, const Window& window) {
  constexpr double level_sigma_db = 2.0;
  Rng rng = stream(seed_, Draw::floor, now.number);
  if (rng.uniform() >= options_.floor_share) return;
  const double level_db = rng.normal(-options_.threshold_db, level_sigma_db);
  const Angle angle = floor_angle(now.travelled_m);
  const double height_m = sensor.mount.z_m > 0.0 ? sensor.mount.z_m : options_.floor_height_m;
  if (level_db < -options_.threshold_db || angle <= Angle{}) return;
  const double delay_s = 2.0 * height_m / sin(angle) / true_m_s_;
  if (delay_s < window.opens_s || delay_s >= window.closes_s) return;
  const Pose2 T_world_sensor = now.T_world_robot * sensor.mount.T_robot_sensor();
  const std::vector<Disc> moving = world_.moving_at(now.time_s);
  const double ground_m = height_m / tan(angle);
  if (world_.first_hit(T_world_sensor.position, unit(T_world_sensor.heading), ground_m, moving)) return;
  arrivals_.push_back({delay_s, EchoCause::floor});
}

void Sonar::add_cross_talk(std::span<const Firing> earlier, const Firing& now, const Sensor& receiver,
                           const Window& window) {
  for (std::size_t k = earlier.size(); k > 0; --k) {
    const double before_s = now.time_s - earlier[k - 1].time_s;
    if (before_s + window.opens_s > memory_s_) return;
    add_paths(earlier[k - 1], receiver, before_s, window);
  }
}

/// Draws the same numbers whatever the options are, so that a change of one leaves the noise of the others as it was.
void Sonar::report(Ping ping, const Window& window, Rng& rng, std::vector<Ping>& pings) {
  const bool dropped = rng.uniform() < options_.dropout_share;
  const bool outlier = rng.uniform() < outlier_share_of_windows_;
  const double outlier_s = rng.uniform(window.opens_s, window.closes_s);
  if (outlier) return pings.push_back(heard(ping, 0.5 * assumed_m_s_ * outlier_s, EchoCause::outlier));
  const std::size_t first = pings.size();
  double deaf_until_s = window.opens_s;
  for (const Arrival& arrival : arrivals_) {
    if (dropped || arrival.delay_s < deaf_until_s) continue;
    const double range_m =
        0.5 * true_m_s_ * arrival.delay_s * (1.0 + options_.range_noise_share * rng.normal(0.0, 1.0));
    ping.echo_index = static_cast<std::uint32_t>(pings.size() - first);
    pings.push_back(heard(ping, range_m * assumed_m_s_ / true_m_s_, arrival.cause));
    deaf_until_s = arrival.delay_s + echo_separation_s;
    if (!options_.later_echoes || pings.size() - first == most_echoes) return;
  }
  if (pings.size() == first) pings.push_back(ping);
}

/// `ping` with an echo at `range_m`, as the robot computes ranges.
Ping Sonar::heard(Ping ping, double range_m, EchoCause cause) const {
  ping.time_of_flight_s = 2.0 * range_m / assumed_m_s_;
  ping.range_m = options_.quantum_m > 0.0 ? quantise(range_m, options_.quantum_m, options_.quantisation) : range_m;
  ping.cause = cause;
  return ping;
}

}  // namespace echoarc::sim
