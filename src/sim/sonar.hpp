// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/sim/acoustics.hpp"
#include "echoarc/sim/echo_paths.hpp"
#include "echoarc/sim/sonar_options.hpp"
#include "echoarc/sim/world.hpp"

namespace echoarc::sim {

/// One transmission: who fired, when, and where the robot was.
struct Firing {
  std::uint64_t number = 0;  ///< counts firings from 0; noise is drawn by it
  double time_s = 0.0;
  std::size_t sensor = 0;  ///< place in the array
  Pose2 T_world_robot;
  double travelled_m = 0.0;
};

/// The sonars of a robot: what they say after a firing. Depends on the firings alone, not on the order in which they
/// are asked about. One per thread.
class Sonar {
 public:
  /// All must outlive it; the array has at least one sensor, the options are valid.
  Sonar(const World& world, const SensorArray& array, const SonarOptions& options, std::uint64_t seed);

  /// How long a ping can still be heard after it was fired.
  [[nodiscard]] double memory_s() const { return memory_s_; }

  /// Appends what every listening sensor reports of `now`: the first echo or the sensor's word for none, then later
  /// echoes if they are wanted. `earlier` are the firings before it, in order; those older than `memory_s` are not
  /// looked at. Pings come with their time of flight as measured, NaN where nothing was heard.
  void listen(std::span<const Firing> earlier, const Firing& now, std::vector<Ping>& pings);

  /// Pings whose search for paths met its bound.
  [[nodiscard]] std::uint64_t truncated() const { return finder_.truncated(); }

 private:
  /// Something that crosses a receiver's threshold.
  struct Arrival {
    double delay_s = 0.0;  // since the ping whose window it is
    EchoCause cause = EchoCause::unknown;
  };
  struct Window {
    double opens_s = 0.0;
    double closes_s = 0.0;
  };

  void listen_with(std::size_t receiver, std::span<const Firing> earlier, const Firing& now, std::vector<Ping>& pings);
  [[nodiscard]] Window window_of(const Sensor& receiver) const;
  void add_paths(const Firing& fired, const Sensor& receiver, double before_s, const Window& window);
  void add_cross_talk(std::span<const Firing> earlier, const Firing& now, const Sensor& receiver, const Window& window);
  void add_floor(const Firing& now, const Sensor& sensor, const Window& window);
  [[nodiscard]] Angle floor_angle(double travelled_m) const;
  void report(Ping ping, const Window& window, Rng& rng, std::vector<Ping>& pings);
  [[nodiscard]] Ping heard(Ping ping, double range_m, EchoCause cause) const;

  const World& world_;
  std::span<const Sensor> sensors_;
  SonarOptions options_;
  std::uint64_t seed_;
  double true_m_s_;     // speed of sound in the air
  double assumed_m_s_;  // and as the robot takes it
  double farthest_m_;   // longer paths are never heard
  double memory_s_;
  double outlier_share_of_windows_;
  Acoustics acoustics_;
  PathFinder finder_;
  std::vector<Arrival> arrivals_;
};

}  // namespace echoarc::sim
