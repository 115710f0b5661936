// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/live/obstacles.hpp"
#include "echoarc/sensing/no_echo.hpp"

namespace echoarc::live {

struct LocalMapOptions {
  double reach_m = 2.0;
  double memory_s = 30.0;
  double spacing_m = 0.04;
  int doubts = 2;

  static constexpr auto fields() {
    using O = LocalMapOptions;
    return std::tuple{
        field("reach_m", &O::reach_m,
              {.unit = "m", .min = 0.1, .max = 100.0, .doc = "what is further from the robot is forgotten"}),
        field("memory_s", &O::memory_s,
              {.unit = "s", .min = 0.1, .max = 86'400.0, .doc = "what was not heard for so long is forgotten"}),
        field("spacing_m", &O::spacing_m,
              {.unit = "m", .min = 0.005, .max = 1.0, .doc = "between neighbouring points along an arc"}),
        field("doubts", &O::doubts,
              {.min = 1, .max = 100, .doc = "so many readings that hear through a point make it forgotten"})};
  }
};

/// What stands around a robot, as its newest echoes tell: every echo puts points along its whole arc, for it may have
/// come from anywhere on it; readings that hear through a point take it away. Meant for braking, not for maps: it
/// believes in every obstacle until it is contradicted.
class LocalMap final : public Obstacles {
 public:
  LocalMap() = default;
  explicit LocalMap(const RobotDescription& robot, const LocalMapOptions& options = {});

  /// In the order of time, as they come.
  void add(const Odometry& odometry);
  void add(const Ping& ping);
  void add(const Poll& poll);

  /// The free way of a disc from its rim along the arc it drives on, at the most `look_m`; none: nothing stands in it.
  /// What is within the disc already counts for motions towards it alone. A turn on the spot is always free.
  /// With more than one of `least_hits`, what only a single echo tells of does not count: it may be noise.
  [[nodiscard]] std::optional<double> free_along(const Pose2& T_world_base, const RobotVelocity& velocity,
                                                 double hull_radius_m, int least_hits = 1) const override;
  static constexpr double look_m = 3.0;

  [[nodiscard]] std::vector<Vec2> points() const;

 private:
  struct Point {
    Vec2 place;
    double time_s = 0.0;
    int doubts = 0;  // readings that heard through it since
    int hits = 0;
  };

  void hear(std::size_t sensor, double time_s, double raw_m);
  void add_arc(const Sensor& sensor, const Pose2& T_world_sensor, double range_m, double time_s);
  void hear_through(const Sensor& sensor, const Pose2& T_world_sensor, double free_m, bool silent);
  [[nodiscard]] bool doubtful(Point& point, bool too_near) const;
  [[nodiscard]] int heard_before(Vec2 place, double time_s) const;
  [[nodiscard]] int hits_around(Vec2 place) const;
  void forget(double time_s);
  [[nodiscard]] std::uint64_t cell_of(Vec2 place) const;

  LocalMapOptions options_;
  RobotDescription robot_;
  std::vector<NoEchoDecision> decisions_;  // by sensor
  std::optional<Pose2> T_world_robot_;
  std::unordered_map<std::uint64_t, Point> points_;  // by the cell of side `spacing_m` they lie in
  std::vector<double> registers_m_;                  // of polled sensors
  std::vector<double> registers_s_;                  // when they were last heeded
};

}  // namespace echoarc::live
