// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What a simulated log holds besides pings: lasers, polled registers, moving discs, wall notes, odometry.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "echoarc/core/pose_track.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "unit/sim/small_scene.hpp"

namespace echoarc::sim {
namespace {

Simulation run(const Scene& scene, std::uint64_t seed = 1) {
  Result<Simulation> simulation = simulate(scene, seed);
  EXPECT_TRUE(simulation) << (simulation ? "" : simulation.error().message);
  return simulation ? std::move(*simulation) : Simulation{};
}

Scene laser_scene() {
  Scene scene = room_scene(1);
  scene.robot.lasers = {{.id = 3, .mount = {.x_m = 0.1}, .range_min_m = 0.1, .range_max_m = 2.0}};
  scene.lasers = {{.laser = 3, .angle_min = Angle{}, .angle_step = degrees(90.0), .beams = 4}};
  scene.world.materials.push_back({.name = "glass", .laser_ok = false});
  return scene;
}

TEST(SimulatedLaser, SeesTheNearestSurface) {
  Scene scene = laser_scene();
  scene.lasers[0].noise_m = scene.lasers[0].noise_share = 0.0;
  const std::vector<Scan> scans = run(scene).log.scans;
  ASSERT_EQ(scans.size(), 1U);
  ASSERT_EQ(scans[0].ranges_m.size(), 4U);
  EXPECT_EQ(scans[0].laser, 3U);
  EXPECT_TRUE(std::isnan(scans[0].ranges_m[0])) << "2.4 m is out of its range";
  EXPECT_NEAR(scans[0].ranges_m[1], 1.8, 1e-6);
  EXPECT_NEAR(scans[0].ranges_m[2], 1.6, 1e-6);
  EXPECT_NEAR(scans[0].ranges_m[3], 1.2, 1e-6);
  scene.world.walls[2].material = 1;
  EXPECT_TRUE(std::isnan(run(scene).log.scans[0].ranges_m[1])) << "glass returns nothing";
}

TEST(SimulatedLaser, NoiseGrowsWithTheRange) {
  Scene scene = laser_scene();
  scene.lasers[0].angle_step = Angle{};
  scene.lasers[0].angle_min = degrees(90.0);
  scene.lasers[0].beams = 10'000;
  const Simulation simulation = run(scene);
  double chi_square = 0.0;
  for (const float range_m : simulation.log.scans.at(0).ranges_m) {
    const double z = (static_cast<double>(range_m) - 1.8) / (0.005 + 0.005 * 1.8);
    chi_square += z * z;
  }
  EXPECT_NEAR(chi_square, 10'000.0, 4.0 * std::sqrt(20'000.0));
}

TEST(SimulatedLaser, ScansAtItsRateOrOnceAStop) {
  Scene scene = laser_scene();
  scene.drive.dwell_s = 1.0;
  EXPECT_EQ(run(scene).log.scans.size(), 6U) << "5 Hz over a second, both ends";
  scene.drive.dwell_s = 0.0;
  scene.drive.legs = {{.turn = degrees(30.0)}};
  scene.drive.stop_turn = degrees(10.0);
  EXPECT_EQ(run(scene).log.scans.size(), 4U);
}

TEST(Simulate, MovingDiscsAreWhereTheyAreAtThePing) {
  Scene scene = room_scene(1);
  scene.world.moving = {{.radius_m = 0.1, .path = {{0.0, {3.5, 1.2}}, {2.0, {2.5, 1.2}}}}};
  scene.drive.dwell_s = 3.0;
  for (const Ping& ping : run(scene).log.pings) {
    EXPECT_EQ(ping.cause, EchoCause::disc);
    EXPECT_NEAR(ping.range_m, 3.5 - 0.5 * std::min(ping.time_s, 2.0) - 0.1 - 1.65, 1e-9);
  }
  scene.world.moving[0].path[1].centre.x = 1.6;
  const Result<Simulation> hit = simulate(scene, 1);
  ASSERT_FALSE(hit);
  EXPECT_NE(hit.error().message.find("a moving disc hits the robot after"), std::string::npos);
}

TEST(Simulate, PolledRegistersLeadBackToTheFirings) {
  Scene scene = driving_scene(16, SonarOptions{});
  scene.polling = {.polled = true, .rate_hz = 100.0};
  const Simulation simulation = run(scene);
  EXPECT_TRUE(simulation.log.pings.empty());
  ASSERT_GT(simulation.log.polls.size(), 600U);
  ASSERT_EQ(simulation.log.polls[0].ranges_m.size(), 16U);
  const SensedLog sensed = sense(simulation.log);
  ASSERT_GT(sensed.readings.size(), simulation.polled_pings.size() / 2);
  PoseTrack truth;
  for (const Odometry& pose : simulation.log.truth) EXPECT_FALSE(truth.push(pose));
  std::size_t attributed = 0;
  for (const Reading& reading : sensed.readings) {
    const auto nearest = std::ranges::min_element(simulation.polled_pings, {}, [&](const Ping& ping) {
      return ping.rx == reading.rx ? std::abs(ping.time_s - reading.time_s) : 1e9;
    });
    const auto place = truth.at(nearest->time_s);
    if (std::abs(nearest->time_s - reading.time_s) > 0.04) continue;
    ++attributed;
    EXPECT_LT(norm(std::get<Pose2>(place).position - reading.T_world_robot.position), 0.0125);
    const auto range_m = echo_range_m(reading.outcome);
    EXPECT_EQ(range_m.has_value(), std::isfinite(nearest->range_m));
    EXPECT_EQ(range_m.value_or(nearest->range_m), nearest->range_m);
  }
  EXPECT_EQ(attributed, sensed.readings.size());
}

TEST(Simulate, StampedPingsOfAPolledSceneAreTheSame) {
  Scene scene = driving_scene(4, SonarOptions{});
  const std::vector<Ping> pings = run(scene).log.pings;
  scene.polling.polled = true;
  const std::vector<Ping> polled = run(scene).polled_pings;
  ASSERT_EQ(pings.size(), polled.size());
  for (std::size_t k = 0; k < pings.size(); ++k) {
    EXPECT_EQ(pings[k].time_s, polled[k].time_s);
    EXPECT_EQ(pings[k].range_m, polled[k].range_m);
  }
}

TEST(Simulate, StopsSayOnWhichSideTheWallIs) {
  Scene scene = driving_scene(1);
  scene.drive.stop_step_m = 0.5;
  EXPECT_TRUE(run(scene).log.walls.empty());
  scene.drive.facing = degrees(90.0);
  std::vector<WallNote> walls = run(scene).log.walls;
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_EQ(walls[0].side, WallSide::left);
  scene.drive.facing = degrees(-90.0);
  walls = run(scene).log.walls;
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_EQ(walls[0].side, WallSide::right);
}

TEST(Simulate, OdometryCoversEveryPingAndIsExactAtStops) {
  Scene scene = driving_scene(3);
  scene.drive.stop_step_m = 0.25;
  const Simulation simulation = run(scene);
  EXPECT_EQ(simulation.report.firings, 27U);
  for (const Reading& reading : sense(simulation.log).readings) {
    const double steps = (reading.T_world_robot.position.x - 1.0) / 0.25;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
  }
  EXPECT_EQ(sense(simulation.log).readings.size(), 27U);
  scene.odometry.perfect = false;
  const Simulation drifted = run(scene);
  ASSERT_EQ(drifted.log.odometry.size(), drifted.log.truth.size());
  EXPECT_EQ(drifted.log.odometry.front().T_world_robot, drifted.log.truth.front().T_world_robot);
  EXPECT_GT(norm(drifted.log.odometry.back().T_world_robot.position - drifted.log.truth.back().T_world_robot.position),
            1e-3);
}

}  // namespace
}  // namespace echoarc::sim
