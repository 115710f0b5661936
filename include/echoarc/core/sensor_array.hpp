// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/core/pose2.hpp"
#include "echoarc/core/result.hpp"

namespace echoarc {

using SensorId = std::uint32_t;

/// How a sensor spells "I heard nothing". `automatic` looks at the recorded values and says what it decided.
struct NoEchoRule {
  enum class Kind { automatic, inf, nan, zero, max, above };
  Kind kind = Kind::automatic;
  double above_m = 0.0;  ///< for `above`: values at or above this are no echo

  friend bool operator==(const NoEchoRule&, const NoEchoRule&) = default;
};

/// Where a sensor sits on the robot: position in metres and REP 103 roll, pitch, yaw. Its x axis is the acoustic axis.
struct Mount {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  Angle roll{};
  Angle pitch{};
  Angle yaw{};

  /// The mount seen from above: what the planar methods use.
  [[nodiscard]] Pose2 T_robot_sensor() const { return {{x_m, y_m}, yaw}; }
  friend bool operator==(const Mount&, const Mount&) = default;
};

/// What the maker of a transducer states. Beam width is the full angle.
struct SensorModel {
  std::string preset;  ///< name of the preset the numbers came from; empty when they were given one by one
  Angle beam_width = degrees(25.0);
  double range_min_m = 0.15;
  double range_max_m = 10.7;
  double trusted_range_m = 3.0;  ///< to this range silence counts as free space: a slanted wall is silent, too
  NoEchoRule no_echo;

  friend bool operator==(const SensorModel&, const SensorModel&) = default;
};

struct Sensor {
  SensorId id = 0;
  Mount mount;
  SensorModel model;

  friend bool operator==(const Sensor&, const Sensor&) = default;
};

/// The sonars of a robot, in order of id; ids are unique.
class SensorArray {
 public:
  static constexpr std::size_t max_sensors = 1024;

  SensorArray() = default;
  /// Sorts by id. Errors: duplicate ids, more than `max_sensors`, a beam outside (0, 180) degrees, ranges that are not
  /// 0 <= min < max <= 1000 m, a mount further than 1000 m away or not finite.
  [[nodiscard]] static Result<SensorArray> make(std::vector<Sensor> sensors);

  [[nodiscard]] const Sensor* find(SensorId id) const;
  [[nodiscard]] std::span<const Sensor> sensors() const { return sensors_; }
  [[nodiscard]] std::size_t size() const { return sensors_.size(); }
  [[nodiscard]] bool empty() const { return sensors_.empty(); }

  friend bool operator==(const SensorArray&, const SensorArray&) = default;

 private:
  std::vector<Sensor> sensors_;
};

/// `count` sensors on a circle around the robot's centre, looking outward, ids from 0; sensor 0 at `start`,
/// counter-clockwise.
[[nodiscard]] std::vector<Sensor> ring(int count, double radius_m, Angle start, const SensorModel& model);
/// `count` sensors side by side, `spacing_m` apart, looking along +x from `x_m`; sensor 0 is the rightmost.
[[nodiscard]] std::vector<Sensor> row(int count, double spacing_m, double x_m, const SensorModel& model);

struct SensorPreset {
  std::string_view name;
  std::string_view description;
  std::string_view source;
  Angle beam_width;
  double range_min_m;
  double range_max_m;
  double trusted_range_m;
  NoEchoRule no_echo;
};

/// Transducers one can buy: `polaroid-6500`, `hc-sr04`, ... with the datasheet's numbers.
[[nodiscard]] std::span<const SensorPreset> sensor_presets();
[[nodiscard]] std::optional<SensorModel> sensor_preset(std::string_view name);

struct ArrayPreset {
  std::string_view name;
  std::string_view description;
  std::string_view source;
};

/// Whole arrays of the literature: `nomad200`, `nomad200_front3`, `nomad200_front5`, `scout2`, `nomad_choset`, `b14r`.
[[nodiscard]] std::span<const ArrayPreset> array_presets();
[[nodiscard]] std::optional<SensorArray> array_preset(std::string_view name);

}  // namespace echoarc
