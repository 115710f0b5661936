// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "sim/sonar.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "echoarc/core/speed_of_sound.hpp"
#include "unit/sim/small_scene.hpp"

namespace echoarc::sim {
namespace {

/// Two sensors in one place that look along +x at a wall `wall_m` away, and nothing else.
Scene two_ears(double wall_m, const SonarOptions& sonar) {
  Scene scene;
  scene.world.walls = {{.a = {wall_m, -20.0}, .b = {wall_m, 20.0}}};
  const SensorModel model{.range_min_m = 0.05};
  scene.robot.sensors = SensorArray::make({{0, {}, model}, {1, {}, model}}).value();
  scene.sonar = sonar;
  return scene;
}

/// One sensor 2 m before a wall that fires `count` times.
Scene long_look(int count, const SonarOptions& sonar) {
  Scene scene = two_ears(2.0, sonar);
  scene.robot.sensors = SensorArray::make({{0, {}, SensorModel{.range_min_m = 0.05}}}).value();
  scene.drive.dwell_s = (count - 1) * sonar.interval_s;
  return scene;
}

std::vector<Ping> pings_of(const Scene& scene, std::uint64_t seed = 1) {
  const Result<Simulation> simulation = simulate(scene, seed);
  EXPECT_TRUE(simulation) << (simulation ? "" : simulation.error().message);
  return simulation ? simulation->log.pings : std::vector<Ping>{};
}

std::size_t heard(const std::vector<Ping>& pings, EchoCause cause) {
  return static_cast<std::size_t>(std::ranges::count(pings, cause, &Ping::cause));
}

// Ping A at 0, B 40 ms later: a path of A of 14, 15 and 20 m ends in B's window.
TEST(Sonar, LateEchoesOfOnePingFallIntoTheWindowOfTheNext) {
  const std::pair<double, double> cases[] = {{7.0, 0.133507}, {7.5, 0.633507}, {10.0, 3.133507}};
  for (const auto& [wall_m, ghost_m] : cases) {
    const std::vector<Ping> pings = pings_of(two_ears(wall_m, exact_sonar()));
    ASSERT_EQ(pings.size(), 2U);
    EXPECT_TRUE(std::isinf(pings[0].range_m)) << "its window is over when the echo comes";
    EXPECT_NEAR(pings[1].range_m, ghost_m, 5e-7);
    EXPECT_EQ(pings[1].cause, EchoCause::cross_talk);
    EXPECT_EQ(pings[1].tx, 1U) << "the robot cannot know better";
  }
}

TEST(Sonar, WithoutCrossTalkEveryPingHasItsFullTime) {
  SonarOptions sonar = exact_sonar();
  sonar.cross_talk = false;
  for (const Ping& ping : pings_of(two_ears(7.0, sonar))) {
    EXPECT_NEAR(ping.range_m, 7.0, 1e-9);
    EXPECT_EQ(ping.cause, EchoCause::wall);
  }
  sonar.cross_talk = true;
  sonar.interval_s = 0.1;  // longer than the time-out of 62 ms: nothing is still in flight
  for (const Ping& ping : pings_of(two_ears(7.0, sonar))) EXPECT_EQ(ping.cause, EchoCause::wall);
}

TEST(Sonar, NothingIsHeardWhileTheReceiverIsBlanked) {
  EXPECT_NEAR(pings_of(two_ears(0.27, exact_sonar())).at(0).range_m, 0.27, 1e-9);
  Scene scene = two_ears(0.27, exact_sonar());
  scene.robot.sensors = SensorArray::make({{0, {}, SensorModel{.range_min_m = 0.3}}}).value();
  EXPECT_TRUE(std::isinf(pings_of(scene).at(0).range_m));
}

TEST(Sonar, AllSensorsListen) {
  Scene scene = two_ears(2.0, exact_sonar());
  scene.sonar.listening = Listening::all;
  const std::vector<Ping> pings = pings_of(scene);
  ASSERT_EQ(pings.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(pings[k].tx, k / 2);
    EXPECT_EQ(pings[k].rx, k % 2);
    EXPECT_NEAR(pings[k].range_m, 2.0, 1e-9) << "half of the path";
  }
}

TEST(Sonar, LaterEchoesAreKeptWhereTheyAreWanted) {
  Scene scene = room_scene(1);
  scene.sonar.later_echoes = true;
  const std::vector<Ping> pings = pings_of(scene);
  ASSERT_GT(pings.size(), 1U);
  for (std::size_t k = 0; k < pings.size(); ++k) {
    EXPECT_EQ(pings[k].echo_index, k);
    EXPECT_EQ(pings[k].time_s, pings[0].time_s);
    EXPECT_GT(pings[k].range_m, k > 0 ? pings[k - 1].range_m + 0.07 : 0.0);
  }
  scene.sonar.later_echoes = false;
  const std::vector<Ping> first = pings_of(scene);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].range_m, pings[0].range_m);
}

// [Silver04] App. B: eps = 22.5 deg and 0.26035 m make 0.680327 m.
TEST(Sonar, FloorIsHeardAtItsSlantRange) {
  SonarOptions sonar = exact_sonar();
  sonar.floor_share = 1.0;
  sonar.pitch_sigma = Angle{};
  Scene scene = long_look(400, sonar);
  scene.world.walls.clear();
  const std::vector<Ping> pings = pings_of(scene);
  const std::size_t floors = heard(pings, EchoCause::floor);
  EXPECT_NEAR(static_cast<double>(floors), 200.0, 40.0) << "half of them are loud enough";
  for (const Ping& ping : pings) EXPECT_NEAR(ping.cause == EchoCause::floor ? ping.range_m : 0.680327, 0.680327, 5e-7);
  scene.world.walls = {{.a = {0.2, -0.4}, .b = {0.8, 0.2}}};  // at 45 degrees: no echo, but nothing behind it either
  EXPECT_EQ(heard(pings_of(scene), EchoCause::floor), 0U);
}

TEST(Sonar, FloorTiltsWithThePitchOfTheRobot) {
  SonarOptions sonar = exact_sonar();
  sonar.floor_share = 1.0;
  Scene scene = long_look(1, sonar);
  scene.world.walls.clear();
  scene.drive.legs = {{.to = Vec2{60.0, 0.0}}};
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (const Ping& ping : pings_of(scene)) {
    if (ping.cause != EchoCause::floor) continue;
    const double tilt_deg = radians(std::asin(0.26035 / ping.range_m)).deg() - 22.5;
    sum += tilt_deg;
    squares += tilt_deg * tilt_deg;
    ++count;
  }
  ASSERT_GT(count, 1000.0);
  // 200 stretches of 0.3 m that hardly know of one another.
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.7 / std::sqrt(200.0));
  EXPECT_NEAR(std::sqrt(squares / count), 0.7, 4.0 * 0.7 / std::sqrt(400.0));
}

TEST(Sonar, RangesComeInSteps) {
  SonarOptions sonar = exact_sonar();
  sonar.quantum_m = inch_m;
  const auto range_m = [&](double wall_m) { return pings_of(two_ears(wall_m, sonar)).at(0).range_m; };
  EXPECT_NEAR(range_m(1.000), 0.9906, 1e-9);
  EXPECT_NEAR(range_m(1.013), 1.0160, 1e-9);
  EXPECT_NEAR(range_m(2.500), 2.4892, 1e-9);
  sonar.quantisation = Quantisation::truncate;
  EXPECT_NEAR(range_m(1.013), 0.9906, 1e-9);
}

TEST(Sonar, WrongTemperatureStretchesRanges) {
  SonarOptions sonar = exact_sonar();
  sonar.temperature_k = 303.0;
  const Result<Simulation> simulation = simulate(two_ears(2.0, sonar), 1);
  ASSERT_TRUE(simulation);
  EXPECT_NEAR(simulation->log.pings.at(0).range_m, 2.0 * 343.3247 / 349.1343, 1e-6);
  EXPECT_EQ(simulation->log.temperature_k, 293.0) << "what the robot thinks";
}

TEST(Sonar, RangeNoiseIsNormal) {
  SonarOptions sonar = exact_sonar();
  sonar.range_noise_share = 0.01;
  constexpr int count = 4000;
  double chi_square = 0.0;
  double sum = 0.0;
  for (const Ping& ping : pings_of(long_look(count, sonar))) {
    const double z = (ping.range_m - 2.0) / 0.02;
    chi_square += z * z;
    sum += z;
  }
  EXPECT_NEAR(chi_square, count, 4.0 * std::sqrt(2.0 * count));
  EXPECT_NEAR(sum, 0.0, 4.0 * std::sqrt(count));
}

TEST(Sonar, DropoutsAndOutliersComeAsOftenAsStated) {
  SonarOptions sonar = exact_sonar();
  sonar.dropout_share = 0.2;
  sonar.outlier_share = 0.1;
  constexpr double count = 4000.0;
  const std::vector<Ping> pings = pings_of(long_look(4000, sonar));
  ASSERT_EQ(static_cast<double>(pings.size()), count);
  const auto expect_share = [&](std::size_t seen, double share) {
    EXPECT_NEAR(static_cast<double>(seen), share * count, 4.0 * std::sqrt(share * (1.0 - share) * count));
  };
  expect_share(heard(pings, EchoCause::outlier), 0.1);
  expect_share(heard(pings, EchoCause::unknown), 0.9 * 0.2);
  expect_share(heard(pings, EchoCause::wall), 0.9 * 0.8);
  // Uniform over the window: tenths are as full as one another, chi-square with 9 degrees of freedom.
  const double closes_m = 0.5 * 0.04 * speed_of_sound_m_s(293.0);
  std::vector<double> tenths(10, 0.0);
  for (const Ping& ping : pings)
    if (ping.cause == EchoCause::outlier)
      ++tenths.at(static_cast<std::size_t>((ping.range_m - 0.05) / (closes_m - 0.05) * 10.0));
  const double each = std::accumulate(tenths.begin(), tenths.end(), 0.0) / 10.0;
  double chi_square = 0.0;
  for (const double tenth : tenths) chi_square += (tenth - each) * (tenth - each) / each;
  EXPECT_LT(chi_square, 27.9) << "one in a thousand";
}

/// Pings that are heard in both runs have the same range.
void expect_same_noise(const std::vector<Ping>& a, const std::vector<Ping>& b) {
  ASSERT_EQ(a.size(), b.size());
  std::size_t compared = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].cause != EchoCause::wall || b[k].cause != EchoCause::wall) continue;
    EXPECT_EQ(a[k].range_m, b[k].range_m);
    ++compared;
  }
  EXPECT_GT(compared, a.size() / 4);
}

TEST(Sonar, OneOptionLeavesTheNoiseOfTheOthersAsItWas) {
  const Scene plain = driving_scene(4, SonarOptions{});
  const std::vector<Ping> pings = pings_of(plain);
  Scene changed = plain;
  changed.sonar.dropout_share = 0.4;
  expect_same_noise(pings, pings_of(changed));
  changed = plain;
  changed.sonar.outlier_share = 0.4;
  expect_same_noise(pings, pings_of(changed));
  changed = plain;
  changed.sonar.floor_share = 0.5;
  expect_same_noise(pings, pings_of(changed));
  changed = plain;
  changed.odometry.perfect = false;
  expect_same_noise(pings, pings_of(changed));
  changed = plain;
  changed.sonar.listening = Listening::all;
  std::vector<Ping> own = pings_of(changed);
  std::erase_if(own, [](const Ping& ping) { return ping.tx != ping.rx; });
  expect_same_noise(pings, own);
}

}  // namespace
}  // namespace echoarc::sim
