// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/angle.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "echoarc/core/pose2.hpp"

namespace echoarc {
namespace {

TEST(Angle, SpeaksBothUnits) {
  EXPECT_DOUBLE_EQ(degrees(180.0).rad(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(radians(std::numbers::pi / 4).deg(), 45.0);
}

TEST(Angle, WrapsIntoTheHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(wrap(degrees(-180.0)).deg(), 180.0);
  EXPECT_DOUBLE_EQ(wrap(degrees(180.0)).deg(), 180.0);
  EXPECT_NEAR(wrap(degrees(350.0)).deg(), -10.0, 1e-12);
  EXPECT_NEAR(wrap(degrees(-725.0)).deg(), -5.0, 1e-12);
}

TEST(Pose2, ComposesAndInverts) {
  const Pose2 T_world_robot{{1.0, 2.0}, degrees(90.0)};
  const Pose2 T_robot_sensor{{0.5, 0.0}, degrees(-30.0)};
  const Pose2 T_world_sensor = T_world_robot * T_robot_sensor;
  EXPECT_NEAR(T_world_sensor.position.x, 1.0, 1e-15);
  EXPECT_NEAR(T_world_sensor.position.y, 2.5, 1e-15);
  EXPECT_NEAR(T_world_sensor.heading.deg(), 60.0, 1e-12);
  const Pose2 identity = inverse(T_world_sensor) * T_world_sensor;
  EXPECT_NEAR(norm(identity.position), 0.0, 1e-15);
  EXPECT_NEAR(identity.heading.rad(), 0.0, 1e-15);
}

TEST(Pose2, InterpolatesTheShortWayRound) {
  const Pose2 middle = interpolate({{0, 0}, degrees(170.0)}, {{1, 2}, degrees(-170.0)}, 0.5);
  EXPECT_DOUBLE_EQ(middle.position.x, 0.5);
  EXPECT_DOUBLE_EQ(middle.position.y, 1.0);
  EXPECT_NEAR(wrap(middle.heading).deg(), 180.0, 1e-12);
}

}  // namespace
}  // namespace echoarc
