// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What tangent consensus gives where it has little to go by: docs/methods/consensus.md, "Little to go by", states it.

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/mapping/consensus.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

PointMap map_of(const std::vector<Reading>& readings, const ConsensusOptions& options = {}) {
  Consensus method(options);
  InlineExecutor executor;
  method.insert(readings, executor);
  method.finish(executor);
  return method.map();
}

/// A square room of mirrors, its walls at +-half_m: the nearest wall that the sensor meets at a right angle within 12
/// degrees of its axis answers, with 5 mm of noise.
class MirrorRoom {
 public:
  explicit MirrorRoom(double half_m) : half_m_(half_m) {}

  void hear(const Pose2& T_world_sensor, std::vector<Reading>& readings) {
    constexpr Angle beam = degrees(12.0);
    std::optional<double> nearest_m;
    for (int wall = 0; wall < 4; ++wall) {
      const Angle normal = degrees(90.0 * wall);
      if (abs(wrap(normal - T_world_sensor.heading)) > beam) continue;
      const double range_m = half_m_ - dot(unit(normal), T_world_sensor.position) + rng_.normal(0.0, 0.005);
      if (!nearest_m || range_m < *nearest_m) nearest_m = range_m;
    }
    if (!nearest_m) return;
    readings.push_back(test::monostatic_reading(T_world_sensor, Echo{*nearest_m}));
    readings.back().ping = readings.size() - 1;
  }

  /// Distance from the nearest wall.
  [[nodiscard]] double off_m(Vec2 p) const { return std::abs(half_m_ - std::max(std::abs(p.x), std::abs(p.y))); }

 private:
  double half_m_;
  Rng rng_{11};
};

/// One place, one direction, ranges that scatter by more than step A passes over: arcs that agree at every bearing
/// alike know no more than the beam, and reinforce its middle. A `thin_range_m` above the noise leaves one arc, and no
/// point.
TEST(ConsensusLimits, StandingStillGivesTheMiddleOfTheBeamAtMost) {
  Rng rng(5);
  std::vector<Reading> readings;
  for (std::size_t k = 0; k < 300; ++k) {
    readings.push_back(test::monostatic_reading({{1.0, 2.0}, degrees(30.0)}, Echo{1.5 + rng.normal(0.0, 0.03)}));
    readings.back().ping = k;
  }
  const PointMap map = map_of(readings);
  for (const MapPoint& point : map.points()) {
    if (point.label == PointLabel::zone) continue;  // beside it
    EXPECT_NEAR(abs(wrap(bearing(point.position - Vec2{1.0, 2.0}) - degrees(30.0))).deg(), 0.0, 0.5);
  }
  ConsensusOptions options;
  options.thin_range_m = 0.25;
  EXPECT_TRUE(map_of(readings, options).empty());
}

/// On the spot every wall answers from its foot alone. There it is found.
TEST(ConsensusLimits, SpinningFindsTheFeetOfTheWalls) {
  MirrorRoom room(1.5);
  std::vector<Reading> readings;
  for (int k = 0; k < 720; ++k) room.hear({{0.3, -0.2}, degrees(1.0 * k)}, readings);
  const PointMap map = map_of(readings);
  std::size_t walls = 0;
  for (const MapPoint& point : map.points()) {
    if (point.label == PointLabel::link) continue;
    EXPECT_LT(room.off_m(point.position), 0.1);
    ++walls;
  }
  EXPECT_GT(walls, 20U);
}

/// One sensor, abreast, along a wall.
TEST(ConsensusLimits, OneSensorAlongAWallFindsIt) {
  MirrorRoom room(1.5);
  std::vector<Reading> readings;
  for (int k = 0; k < 60; ++k) room.hear({{-0.8 + 0.025 * k, 0.3}, degrees(86.0)}, readings);
  const PointMap map = map_of(readings);
  EXPECT_GT(map.size(), 30U);
  for (const MapPoint& point : map.points()) EXPECT_LT(room.off_m(point.position), 0.05);
}

/// One sensor that drives straight at a wall hears it all the time, and from one bearing.
TEST(ConsensusLimits, OneSensorTowardsAWallFindsItAhead) {
  MirrorRoom room(1.5);
  std::vector<Reading> readings;
  for (int k = 0; k < 40; ++k) room.hear({{-0.5 + 0.03 * k, 0.1}, degrees(0.0)}, readings);
  const PointMap map = map_of(readings);
  EXPECT_FALSE(map.empty());
  for (const MapPoint& point : map.points()) EXPECT_LT(room.off_m(point.position), 0.1);
}

}  // namespace
}  // namespace echoarc
