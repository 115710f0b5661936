// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/echo_paths.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"
#include "oracle/echo_path_oracle.hpp"
#include "support/random_worlds.hpp"

namespace echoarc::sim {
namespace {

std::string text(const EchoPath& p) {
  return std::string(name(p.cause)) + " " + std::to_string(p.length_m) + " m, " + std::to_string(p.departure.deg()) +
         " to " + std::to_string(p.arrival.deg()) + " deg, " + std::to_string(p.gain_db) + " dB, order " +
         std::to_string(p.reflections);
}

/// The same way. Of walls on top of each other the search keeps the louder echo.
bool same(const EchoPath& a, const EchoPath& b, double tolerance) {
  const bool curve = a.cause == EchoCause::curve;
  const auto near = [&](Angle x, Angle y) { return abs(wrap(x - y)).rad() < (curve ? 0.02 : 1e-5); };
  return a.cause == b.cause && a.reflections == b.reflections && std::abs(a.length_m - b.length_m) < tolerance &&
         near(a.departure, b.departure) && near(a.arrival, b.arrival);
}

/// Every path of one list is in the other, and as loud.
void expect_same(std::span<const EchoPath> fast, std::span<const EchoPath> slow, double tolerance,
                 const std::string& what) {
  for (const EchoPath& path : slow)
    EXPECT_TRUE(std::ranges::any_of(fast,
                                    [&](const EchoPath& other) {
                                      return same(path, other, tolerance) &&
                                             other.gain_db >
                                                 path.gain_db - (path.cause == EchoCause::curve ? 0.2 : 1e-6);
                                    }))
        << "missed " << text(path) << " in " << what;
  for (const EchoPath& path : fast)
    EXPECT_TRUE(std::ranges::any_of(slow,
                                    [&](const EchoPath& other) {
                                      return same(path, other, tolerance) &&
                                             std::abs(other.gain_db - path.gain_db) <
                                                 (path.cause == EchoCause::curve ? 0.2 : 1e-6);
                                    }))
        << "invented " << text(path) << " in " << what;
}

void compare(const WorldDescription& description, const Transducer& sender, const Transducer& listener,
             PathLimits limits, const std::vector<Disc>& moving, const std::string& what) {
  const World world = World::make(description).value();
  PathFinder finder(world);
  const auto fast = finder.find(sender, listener, limits, moving);
  const auto slow = oracle::Paths(world, sender, listener, limits, moving).find();
  expect_same(fast, slow, 1e-8, what);
}

TEST(EchoPathOracle, RandomWorlds) {
  Rng rng(1);
  for (int round = 0; round < 60; ++round) {
    const bool rough = round % 3 == 1;
    const WorldDescription world = random_world(rng, 12, rough, round % 4 == 3);
    const std::vector<Disc> moving{{{rng.uniform(-4.0, 4.0), rng.uniform(-4.0, 4.0)}, 0.3}};
    for (const double half_window_deg : {25.0, 80.0, 180.0}) {
      const Transducer sender = random_ear(rng, degrees(half_window_deg));
      Transducer listener = sender;
      if (round % 2 == 1)
        listener = {sender.position + Vec2{0.1, 0.05}, sender.axis + degrees(22.5), sender.half_window};
      compare(world, sender, listener, {.max_order = 3, .max_length_m = 14.0}, moving,
              "round " + std::to_string(round));
    }
  }
}

TEST(EchoPathOracle, Rooms) {
  Rng rng(2);
  for (int round = 0; round < 20; ++round) {
    const WorldDescription world = random_rooms(rng);
    const Transducer sender = random_ear(rng, degrees(round % 2 == 0 ? 25.0 : 180.0));
    compare(world, sender, sender, {.max_order = round % 2 == 0 ? 3 : 2}, {}, "round " + std::to_string(round));
  }
}

TEST(EchoPathOracle, HighOrdersInASmallWorld) {
  Rng rng(3);
  for (int round = 0; round < 10; ++round) {
    const WorldDescription world = random_world(rng, 5, false, false);
    const Transducer sender = random_ear(rng, degrees(180.0));
    const Transducer listener{sender.position + Vec2{0.2, 0.1}, {}, degrees(180.0)};
    compare(world, sender, listener, {.max_order = 6, .max_length_m = 30.0}, {}, "round " + std::to_string(round));
  }
}

TEST(EchoPathOracle, Curves) {
  Rng rng(4);
  SmoothCurve curve;
  for (int i = 0; i <= 1500; ++i) {
    const double x = -1.0 + 2.0 * i / 1500.0;
    curve.points.push_back({x, 1.0 + 0.16 * std::cos(2.6 * x + 0.5) - 0.07 * std::sin(4.3 * x)});
  }
  for (int round = 0; round < 30; ++round) {
    const WorldDescription world{.walls = {{{-2.0, 2.0}, {2.0, 2.5}}, {{0.2, 0.4}, {0.4, 0.5}}}, .curves = {curve}};
    const Transducer sender{
        {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 3.0)}, degrees(rng.uniform(-180.0, 180.0)), degrees(60.0)};
    Transducer listener = sender;
    if (round % 2 == 1) listener.position = sender.position + Vec2{0.1, 0.0};
    const World made = World::make(world).value();
    PathFinder finder(made);
    const auto fast = finder.find(sender, listener, {});
    expect_same(fast, oracle::Paths(made, sender, listener, {}, {}).find(), 3e-5, "round " + std::to_string(round));
  }
}

}  // namespace
}  // namespace echoarc::sim
