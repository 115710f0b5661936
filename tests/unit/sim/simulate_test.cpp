// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/sensing/sensing.hpp"
#include "unit/sim/small_scene.hpp"

namespace echoarc::sim {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

Simulation run(const Scene& scene, std::uint64_t seed = 1) {
  Result<Simulation> simulation = simulate(scene, seed);
  if (!simulation) throw std::runtime_error(simulation.error().message);
  return std::move(*simulation);
}

/// `scene` is refused with these words, at this place.
void expect_error(const Scene& scene, std::string_view words, std::string_view where = "") {
  const Result<Simulation> simulation = simulate(scene, 1);
  ASSERT_FALSE(simulation) << words;
  EXPECT_NE(simulation.error().message.find(words), std::string::npos) << simulation.error().message;
  EXPECT_EQ(simulation.error().where, where);
  EXPECT_FALSE(simulation.error().remedy.empty());
}

TEST(Simulate, RestingRobotHearsTheWallsHeadOn) {
  const Simulation simulation = run(room_scene(4));
  const std::vector<Ping>& pings = simulation.log.pings;
  ASSERT_EQ(pings.size(), 4U) << "one round";
  const double expected_m[] = {4.0 - 1.5, 3.0 - 1.2, 1.5, 1.2};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(pings[k].tx, k);
    EXPECT_EQ(pings[k].rx, k);
    EXPECT_DOUBLE_EQ(pings[k].time_s, 0.04 * static_cast<double>(k));
    EXPECT_NEAR(pings[k].range_m, expected_m[k] - 0.15, 1e-9);
    EXPECT_EQ(pings[k].cause, EchoCause::wall);
    EXPECT_TRUE(std::isnan(pings[k].time_of_flight_s));
  }
  EXPECT_EQ(simulation.report.firings, 4U);
  EXPECT_EQ(simulation.report.windows, 4U);
  EXPECT_EQ(simulation.report.echoes[static_cast<std::size_t>(EchoCause::wall)], 4U);
  EXPECT_EQ(simulation.report.silent_windows, 0U);
}

TEST(Simulate, SilenceIsSpeltAsTheSensorSpellsIt) {
  Scene scene = room_scene(1);
  scene.world.walls.clear();
  const auto word_of = [&](NoEchoRule rule) {
    SensorModel model;
    model.no_echo = rule;
    scene.robot.sensors = SensorArray::make(ring(1, 0.15, Angle{}, model)).value();
    const Simulation simulation = run(scene);
    EXPECT_EQ(simulation.report.silent_windows, 1U);
    EXPECT_EQ(simulation.log.pings.front().cause, EchoCause::unknown);
    const SensedLog sensed = sense(simulation.log);
    EXPECT_EQ(sensed.readings.size(), 1U);
    EXPECT_TRUE(is_no_echo(sensed.readings.at(0).outcome));
    return simulation.log.pings.front().range_m;
  };
  EXPECT_EQ(word_of({}), inf);
  EXPECT_EQ(word_of({NoEchoRule::Kind::inf}), inf);
  EXPECT_TRUE(std::isnan(word_of({NoEchoRule::Kind::nan})));
  EXPECT_EQ(word_of({NoEchoRule::Kind::zero}), 0.0);
  EXPECT_EQ(word_of({NoEchoRule::Kind::max}), 10.7);
  EXPECT_EQ(word_of({NoEchoRule::Kind::above, 5.11}), 5.11);
}

TEST(Simulate, PingsOfADriveLieWhereTheTruthPutsThem) {
  const Simulation simulation = run(driving_scene(4));
  const SensedLog sensed = sense(simulation.log);
  ASSERT_EQ(sensed.readings.size(), simulation.log.pings.size());
  ASSERT_GT(sensed.readings.size(), 100U);
  std::size_t ahead = 0;
  for (const Reading& reading : sensed.readings) {
    if (reading.rx != 0) continue;
    ++ahead;
    // 0.2 mm: the poses in between are on a parabola while the robot speeds up, and on a line in the log.
    EXPECT_NEAR(echo_range_m(reading.outcome).value_or(-1.0), 4.0 - reading.T_world_rx.position.x, 2e-4);
  }
  EXPECT_GT(ahead, 25U);
  EXPECT_NEAR(simulation.report.path_m, 2.0, 1e-12);
  EXPECT_NEAR(simulation.report.duration_s, 2.0 / 0.3 + 0.3 / 0.5, 1e-9);
}

TEST(Simulate, RefusesWhatMakesNoSense) {
  Scene scene = room_scene(4);
  scene.robot.sensors = {};
  expect_error(scene, "no sensors");
  scene = room_scene(4);
  scene.sonar.range_noise_share = -0.1;
  expect_error(scene, "range_noise_share", "sonar.range_noise_share");
  scene = driving_scene(4);
  scene.drive.legs.push_back({.to = Vec2{3.9, 1.2}, .line = 17});
  expect_error(scene, "runs into a surface, at (3.801, 1.2) m", "line 17");
  scene.file = "room.toml";
  expect_error(scene, "runs into a surface", "room.toml:17");
  scene = room_scene(4);
  scene.drive.start.position = {0.1, 1.0};
  expect_error(scene, "starts in a surface, at (0.1, 1) m");
  scene = room_scene(4);
  scene.lasers = {{.laser = 7}};
  expect_error(scene, "no laser 7");
  scene = room_scene(4);
  scene.polling.polled = true;
  scene.sonar.listening = Listening::all;
  expect_error(scene, "all sensors listen");
  scene = driving_scene(4);
  scene.polling.polled = true;
  scene.drive.stop_step_m = 0.1;
  expect_error(scene, "this drive stops");
  scene = room_scene(4);
  scene.world.walls.push_back({.a = {1.0, 1.0}, .b = {1.0, 1.0}, .line = 9});
  expect_error(scene, "no length", "line 9");
}

TEST(Simulate, WorkIsBounded) {
  Scene scene = room_scene(16);
  scene.drive.dwell_s = 86'400.0;
  scene.sonar.listening = Listening::all;
  expect_error(scene, "10 million");
  scene = room_scene(16);
  scene.drive.dwell_s = 80'000.0;
  scene.odometry.rate_hz = 1000.0;
  expect_error(scene, "odometry records");
  scene = room_scene(16);
  scene.drive.dwell_s = 80'000.0;
  scene.polling = {.polled = true, .rate_hz = 1000.0};
  expect_error(scene, "polls");
  scene = room_scene(1);
  scene.robot.lasers = {{.id = 0}};
  scene.lasers = {{.beams = 100'000, .rate_hz = 1000.0}};
  scene.drive.dwell_s = 1000.0;
  expect_error(scene, "10^9 beams");
}

TEST(Simulate, AnswersItsHost) {
  std::vector<double> shares;
  const Result<Simulation> watched =
      simulate(driving_scene(4), 1, {.progress = [&](double share) { shares.push_back(share); }});
  ASSERT_TRUE(watched);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  const Result<Simulation> stopped = simulate(driving_scene(4), 1, {.cancelled = [] { return true; }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

/// Everything random, rounded to 1e-6 and hashed (FNV-1a).
std::uint64_t fingerprint(const Simulation& simulation) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&](double value) {
    const auto rounded = static_cast<std::uint64_t>(std::isfinite(value) ? std::llround(1e6 * value) : -1);
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((rounded >> (8 * byte)) & 0xff)) * 0x100000001b3ULL;
  };
  for (const Ping& ping : simulation.log.pings)
    for (const double value : {ping.time_s, double(ping.tx), double(ping.rx), ping.range_m, double(ping.cause)})
      add(value);
  for (const Odometry& pose : simulation.log.odometry) {
    add(pose.T_world_robot.position.x);
    add(pose.T_world_robot.position.y);
    add(pose.T_world_robot.heading.rad());
  }
  for (const Scan& scan : simulation.log.scans)
    for (const float range_m : scan.ranges_m) add(range_m);
  return hash;
}

Scene noisy_scene() {
  Scene scene = driving_scene(4, SonarOptions{.listening = Listening::all});
  scene.world.discs = {{.centre = {2.0, 2.3}, .radius_m = 0.2}};
  scene.odometry.perfect = false;
  scene.robot.lasers = {{.id = 0}};
  scene.lasers = {{.beams = 9, .rate_hz = 1.0}};
  return scene;
}

TEST(Simulate, TheSameSeedGivesTheSameLog) {
  const std::uint64_t first = fingerprint(run(noisy_scene(), 42));
  EXPECT_EQ(first, fingerprint(run(noisy_scene(), 42)));
  EXPECT_NE(first, fingerprint(run(noisy_scene(), 43)));
  // Pinned, so that a change of the physics does not go unnoticed. The commit that changes it says why.
  EXPECT_EQ(first, 13317245218198512750ULL);
}

}  // namespace
}  // namespace echoarc::sim
