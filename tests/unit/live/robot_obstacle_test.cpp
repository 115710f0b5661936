// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/rng.hpp"
#include "robot_fixture.hpp"

namespace echoarc::live {
namespace {

struct Drives {
  int touched = 0;
  double travelled_m = 0.0;
};

/// Drives of somebody who pays no heed to where the walls are. Who only looks ahead has to look around first.
Drives drive_at_random(std::string_view name, int count, bool look_around) {
  Drives drives;
  for (int k = 1; k <= count; ++k) {
    sim::Scene scene = scene_named(name);
    scene.world.moving.clear();
    Driven driven(scene, static_cast<std::uint64_t>(k));
    Rng rng(static_cast<std::uint64_t>(k));
    if (look_around) driven.drive(9.0, 0.0, degrees(45.0));
    for (int leg = 0; leg < 12; ++leg) {
      const double duration_s = rng.uniform(0.5, 5.0);
      const double forward_m_s = rng.uniform(0.1, 0.6);
      const double turn_deg = rng.uniform(-60.0, 60.0);
      driven.drive(duration_s, forward_m_s, degrees(rng.uniform() < 0.5 ? 0.0 : turn_deg));
    }
    if (driven.simulation().contacts() > 0) ++drives.touched;
    drives.travelled_m += driven.simulation().travelled_m();
  }
  return drives;
}

TEST(Obstacles, WhoDrivesAtRandomTouchesNoWall) {
  const Drives demo = drive_at_random("demo", 50, true);
  EXPECT_EQ(demo.touched, 0);
  EXPECT_GT(demo.travelled_m, 50.0);
  const Drives corridor = drive_at_random("person", 50, false);
  EXPECT_EQ(corridor.touched, 0);
  EXPECT_GT(corridor.travelled_m, 100.0);
  const Drives t_world = drive_at_random("t-world", 50, false);
  EXPECT_EQ(t_world.touched, 0);
  EXPECT_GT(t_world.travelled_m, 100.0);
}

TEST(Obstacles, AWallAheadStopsTheRobotWithItsReason) {
  Driven driven(plain_room());
  driven.drive(20.0, 0.6, Angle{});
  EXPECT_EQ(driven.speed_m_s(), 0.0);
  EXPECT_EQ(driven.control().state().mode, Mode::drive);
  EXPECT_EQ(driven.control().state().reason, Reason::obstacle);
  EXPECT_TRUE(driven.control().state().limited_by_obstacle);
  EXPECT_NEAR(driven.place().x, 6.0 - 0.2 - 0.1, 0.03);
  // Backwards it may go, and there is a wall, too.
  driven.drive(2.0, -0.3, Angle{});
  EXPECT_LT(driven.speed_m_s(), -0.2);
  driven.drive(25.0, -0.6, Angle{});
  EXPECT_EQ(driven.speed_m_s(), 0.0);
  EXPECT_NEAR(driven.place().x, 0.2 + 0.1, 0.03);
  EXPECT_EQ(driven.simulation().contacts(), 0U);
}

TEST(Obstacles, PushingOnDoesNotWearAWallOff) {
  Driven driven(plain_room());
  driven.drive(120.0, 0.6, Angle{});
  EXPECT_EQ(driven.simulation().contacts(), 0U);
}

}  // namespace
}  // namespace echoarc::live
