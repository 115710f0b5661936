// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// What holds in every world, whatever stands in it.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "echoarc/sim/echo_paths.hpp"
#include "support/random_worlds.hpp"

namespace echoarc::sim {
namespace {

std::vector<EchoPath> find(const WorldDescription& description, const Transducer& sender, const Transducer& listener) {
  const World world = World::make(description).value();
  PathFinder finder(world);
  const auto found = finder.find(sender, listener, {.max_order = 3, .max_length_m = 14.0});
  return {found.begin(), found.end()};
}

bool near(Angle a, Angle b) {
  return abs(wrap(a - b)).rad() < 1e-6;
}

bool has(const std::vector<EchoPath>& paths, const EchoPath& wanted) {
  return std::ranges::any_of(paths, [&](const EchoPath& p) {
    return p.cause == wanted.cause && p.reflections == wanted.reflections &&
           std::abs(p.length_m - wanted.length_m) < 1e-8 && std::abs(p.gain_db - wanted.gain_db) < 1e-6 &&
           near(p.departure, wanted.departure) && near(p.arrival, wanted.arrival);
  });
}

TEST(EchoPathLaws, SwappingBothEndsTurnsEveryPathAround) {
  Rng rng(11);
  for (int round = 0; round < 40; ++round) {
    const WorldDescription world = random_world(rng, 12, round % 2 == 1, false);
    const Transducer sender = random_ear(rng, degrees(60.0));
    const Transducer listener{sender.position + Vec2{0.2, -0.1}, sender.axis + degrees(20.0), degrees(70.0)};
    const auto there = find(world, sender, listener);
    const auto back = find(world, listener, sender);
    EXPECT_EQ(there.size(), back.size());
    for (EchoPath path : there) {
      std::swap(path.departure, path.arrival);
      EXPECT_TRUE(has(back, path)) << name(path.cause) << " of " << path.length_m << " m, round " << round;
    }
  }
}

TEST(EchoPathLaws, MovingTheWorldMovesItsEchoesAlong) {
  Rng rng(12);
  for (int round = 0; round < 40; ++round) {
    const WorldDescription world = random_world(rng, 12, round % 2 == 1, round % 3 == 0);
    const Transducer ear = random_ear(rng, degrees(70.0));
    const Angle turn = degrees(rng.uniform(-180.0, 180.0));
    const Vec2 shift{rng.uniform(-50.0, 50.0), rng.uniform(-50.0, 50.0)};
    const auto moved = [&](Vec2 p) { return shift + p.x * unit(turn) + p.y * perpendicular(unit(turn)); };
    WorldDescription other = world;
    for (Wall& wall : other.walls) {
      wall.a = moved(wall.a);
      wall.b = moved(wall.b);
    }
    for (Disc& disc : other.discs) disc.centre = moved(disc.centre);
    const Transducer other_ear{moved(ear.position), ear.axis + turn, ear.half_window};
    const auto before = find(world, ear, ear);
    const auto after = find(other, other_ear, other_ear);
    EXPECT_EQ(before.size(), after.size()) << "round " << round;
    for (EchoPath path : before) {
      path.departure += turn;
      path.arrival += turn;
      EXPECT_TRUE(has(after, path)) << name(path.cause) << " of " << path.length_m << " m, round " << round;
    }
  }
}

TEST(EchoPathLaws, NoPathIsShorterThanTheWayBetweenBothEndsNorGrows) {
  Rng rng(13);
  for (int round = 0; round < 20; ++round) {
    const Transducer sender = random_ear(rng, degrees(180.0));
    const Transducer listener{sender.position + Vec2{0.5, 0.3}, {}, degrees(180.0)};
    for (const EchoPath& path : find(random_world(rng, 12, true, false), sender, listener)) {
      EXPECT_GE(path.length_m, norm(listener.position - sender.position) - 1e-12);
      EXPECT_LE(path.gain_db, 0.0);
    }
  }
}

TEST(EchoPathLaws, APingDoesNotDependOnThoseBefore) {
  Rng rng(14);
  const World world = World::make(random_world(rng, 40, true, true)).value();
  PathFinder used(world);
  for (int round = 0; round < 50; ++round) {
    const Transducer ear = random_ear(rng, degrees(round % 5 == 0 ? 180.0 : 25.0));
    PathFinder fresh(world);
    const auto one = used.find(ear, ear, {});
    const auto other = fresh.find(ear, ear, {});
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].length_m, other[i].length_m);
      EXPECT_EQ(one[i].departure, other[i].departure);
      EXPECT_EQ(one[i].gain_db, other[i].gain_db);
      EXPECT_GE(one[i].length_m, one[i == 0 ? 0 : i - 1].length_m);
    }
  }
}

}  // namespace
}  // namespace echoarc::sim
