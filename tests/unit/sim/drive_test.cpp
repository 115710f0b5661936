// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "sim/drive_plan.hpp"
#include "sim/firing_schedule.hpp"
#include "sim/speed_profile.hpp"
#include "unit/sim/small_scene.hpp"

namespace echoarc::sim {
namespace {

void expect_pose(const Pose2& actual, Vec2 position, double heading_deg) {
  EXPECT_NEAR(actual.position.x, position.x, 1e-9);
  EXPECT_NEAR(actual.position.y, position.y, 1e-9);
  EXPECT_NEAR(wrap(actual.heading - degrees(heading_deg)).deg(), 0.0, 1e-9);
}

TEST(SpeedProfile, TrapezoidWhereFullSpeedIsReached) {
  const SpeedProfile profile(2.0, 0.5, 0.25);  // 2 s and 0.5 m to speed up, as much to slow down
  EXPECT_DOUBLE_EQ(profile.duration_s(), 2.0 + 2.0 + 2.0);
  EXPECT_DOUBLE_EQ(profile.way_at(1.0), 0.125);
  EXPECT_DOUBLE_EQ(profile.way_at(2.0), 0.5);
  EXPECT_DOUBLE_EQ(profile.way_at(3.0), 1.0);
  EXPECT_DOUBLE_EQ(profile.way_at(5.0), 1.875);
  EXPECT_EQ(profile.way_at(-1.0), 0.0);
  EXPECT_EQ(profile.way_at(7.0), 2.0);
}

TEST(SpeedProfile, TriangleWhereItIsNot) {
  const SpeedProfile profile(0.25, 10.0, 1.0);  // half a second up, half a second down
  EXPECT_DOUBLE_EQ(profile.duration_s(), 1.0);
  EXPECT_DOUBLE_EQ(profile.way_at(0.5), 0.125);
}

RC_GTEST_PROP(SpeedProfile, KeepsItsLimitsAndInverts, ()) {
  const double way = *rc::gen::inRange(1, 5000) / 1000.0;
  const double speed = *rc::gen::inRange(1, 2000) / 1000.0;
  const double acceleration = *rc::gen::inRange(1, 3000) / 1000.0;
  const SpeedProfile profile(way, speed, acceleration);
  constexpr int steps = 50;
  const double step_s = profile.duration_s() / steps;
  double before = 0.0;
  double speed_before = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const double now = profile.way_at(k * step_s);
    const double mean_speed = (now - before) / step_s;
    RC_ASSERT(mean_speed >= -1e-12 && mean_speed <= speed * (1.0 + 1e-9));
    RC_ASSERT(std::abs(mean_speed - speed_before) <= acceleration * step_s * (1.0 + 1e-6) + 1e-9);
    RC_ASSERT(std::abs(profile.time_at(now) - k * step_s) <= 1e-4 * profile.duration_s());
    before = now;
    speed_before = mean_speed;
  }
  RC_ASSERT(std::abs(before - way) <= 1e-12);
}

TEST(PlanDrive, TurnsIntoEveryLegAndFacesAside) {
  const Drive drive{.start = {{0.0, 0.0}, Angle{}},
                    .legs = {{.to = Vec2{1.0, 0.0}}, {.to = Vec2{1.0, 2.0}}, {.turn = degrees(-90.0)}},
                    .facing = degrees(90.0)};
  const Result<DrivePlan> plan = plan_drive(drive, 0.2);
  ASSERT_TRUE(plan);
  const Trajectory& way = plan->trajectory;
  expect_pose(way.at(0.0), {0.0, 0.0}, 90.0);
  expect_pose(way.end(), {1.0, 2.0}, 90.0);
  EXPECT_DOUBLE_EQ(way.length_m(), 3.0);
  ASSERT_EQ(way.moves().size(), 4U) << "line, turn, line, turn";
  EXPECT_NEAR(way.end_s(), (1.0 / 0.3 + 0.6) + (2.0 / 0.3 + 0.6) + 2.0 * (90.0 / 45.0 + 0.5), 1e-9);
  expect_pose(way.at(way.moves()[1].begin_s + 1.25), {1.0, 0.0}, 90.0 + 45.0);
  expect_pose(way.at(way.moves()[3].begin_s), {1.0, 2.0}, 180.0);
  EXPECT_TRUE(plan->stops_s.empty());
  EXPECT_NEAR(way.travelled_m(way.moves()[2].begin_s), 1.0, 1e-12);
}

TEST(PlanDrive, KeepsItsHeadingWhereItIsTold) {
  const Drive drive{.start = {{0.0, 0.0}, degrees(30.0)},
                    .legs = {{.to = Vec2{1.0, 0.0}}, {.to = Vec2{1.0, 2.0}}},
                    .keep_heading = true};
  const Result<DrivePlan> plan = plan_drive(drive, 0.2);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->trajectory.moves().size(), 2U);
  for (int k = 0; k < 20; ++k) EXPECT_DOUBLE_EQ(plan->trajectory.at(0.5 * k).heading.deg(), 30.0);
}

TEST(PlanDrive, SixtyStepsAreSixtyOneStops) {
  const Drive along{.start = {{-0.75, 0.0}, Angle{}}, .legs = {{.to = Vec2{0.75, 0.0}}}, .stop_step_m = 0.025};
  Result<DrivePlan> plan = plan_drive(along, 0.2);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->stops_s.size(), 61U);
  for (std::size_t k = 0; k < 61; ++k) {
    const double stop_s = plan->stops_s[k];
    expect_pose(plan->trajectory.at(stop_s), {-0.75 + 0.025 * static_cast<double>(k), 0.0}, 0.0);
    expect_pose(plan->trajectory.at(stop_s + 0.2), {-0.75 + 0.025 * static_cast<double>(k), 0.0}, 0.0);
  }
  const Drive around{
      .start = {{0.0, 0.0}, degrees(60.0)}, .legs = {{.turn = degrees(60.0)}}, .stop_turn = degrees(1.0)};
  plan = plan_drive(around, 0.2);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->stops_s.size(), 61U);
  for (std::size_t k = 0; k < 61; ++k)
    expect_pose(plan->trajectory.at(plan->stops_s[k]), {0.0, 0.0}, 60.0 + static_cast<double>(k));
}

TEST(PlanDrive, StepsGoOnOverTheEndsOfLegs) {
  const Drive drive{
      .start = {{0.0, 0.0}, Angle{}}, .legs = {{.to = Vec2{0.25, 0.0}}, {.to = Vec2{0.25, 0.25}}}, .stop_step_m = 0.1};
  const Result<DrivePlan> plan = plan_drive(drive, 0.2);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->stops_s.size(), 6U);
  expect_pose(plan->trajectory.at(plan->stops_s[2]), {0.2, 0.0}, 0.0);
  expect_pose(plan->trajectory.at(plan->stops_s[3]), {0.25, 0.05}, 90.0);
  expect_pose(plan->trajectory.at(plan->stops_s[5]), {0.25, 0.25}, 90.0);
}

TEST(PlanDrive, RefusesLegsThatLeadNowhere) {
  const auto fault = [](const DriveLeg& leg, double step_m = 0.0) {
    const Result<DrivePlan> plan =
        plan_drive({.start = {{0.0, 0.0}, Angle{}}, .legs = {leg}, .stop_step_m = step_m}, 0.2);
    if (plan) return std::string("none");
    EXPECT_EQ(plan.error().where, "line 5");
    EXPECT_FALSE(plan.error().remedy.empty());
    return plan.error().message;
  };
  EXPECT_EQ(fault({.to = Vec2{0.0, 1e-7}, .line = 5}), "a leg has no length");
  EXPECT_EQ(fault({.line = 5}), "a leg is either a straight line or a turn");
  EXPECT_EQ(fault({.to = Vec2{1.0, 0.0}, .turn = degrees(1.0), .line = 5}),
            "a leg is either a straight line or a turn");
  EXPECT_EQ(fault({.turn = Angle{}, .line = 5}), "a turn has no angle, or more than a thousand rounds");
  EXPECT_EQ(fault({.turn = degrees(std::nan("")), .line = 5}), "a turn has no angle, or more than a thousand rounds");
  EXPECT_EQ(fault({.to = Vec2{std::nan(""), 0.0}, .line = 5}), "a leg ends out of the world");
  EXPECT_EQ(fault({.to = Vec2{1e9, 0.0}, .line = 5}), "a leg ends out of the world");
  EXPECT_EQ(fault({.to = Vec2{1e4, 0.0}, .line = 5}, 1e-4), "the drive has more than 10 million stops");
}

TEST(FiringSchedule, SensorAfterSensor) {
  const Result<DrivePlan> plan = plan_drive({.start = {{0.0, 0.0}, Angle{}}, .legs = {{.to = Vec2{1.0, 0.0}}}}, 0.2);
  ASSERT_TRUE(plan);
  const Result<FiringSchedule> schedule = FiringSchedule::make(*plan, 5, 0.04, 1.0);
  ASSERT_TRUE(schedule);
  EXPECT_NEAR(schedule->end_s(), 1.0 / 0.3 + 0.6 + 1.0, 1e-12);
  EXPECT_EQ(schedule->count(), static_cast<std::uint64_t>(schedule->end_s() / 0.04) + 1);
  for (std::uint64_t k = 0; k < schedule->count(); ++k) {
    const Firing firing = schedule->firing(k);
    EXPECT_EQ(firing.sensor, k % 5);
    EXPECT_DOUBLE_EQ(firing.time_s, 0.04 * static_cast<double>(k));
    EXPECT_EQ(firing.T_world_robot, plan->trajectory.at(firing.time_s));
  }
}

TEST(FiringSchedule, OneRoundAStopAndOnAndOnAfterTheLast) {
  const double rest_s = 3 * 0.04;
  const Result<DrivePlan> plan =
      plan_drive({.start = {{0.0, 0.0}, Angle{}}, .legs = {{.to = Vec2{0.5, 0.0}}}, .stop_step_m = 0.25}, rest_s);
  ASSERT_TRUE(plan);
  const Result<FiringSchedule> schedule = FiringSchedule::make(*plan, 3, 0.04, 0.1);
  ASSERT_TRUE(schedule);
  ASSERT_EQ(schedule->count(), 3U * 3U + 2U);
  EXPECT_DOUBLE_EQ(schedule->firing(4).time_s, plan->stops_s[1] + 0.04);
  expect_pose(schedule->firing(5).T_world_robot, {0.25, 0.0}, 0.0);
  EXPECT_DOUBLE_EQ(schedule->firing(9).time_s, plan->trajectory.end_s());
  EXPECT_EQ(schedule->firing(10).sensor, 1U);
}

TEST(FiringSchedule, TenMillionFiringsAreEnough) {
  const Result<DrivePlan> plan = plan_drive({.start = {{0.0, 0.0}, Angle{}}}, 0.2);
  ASSERT_TRUE(plan);
  const Result<FiringSchedule> schedule = FiringSchedule::make(*plan, 5, 0.001, 86'400.0);
  ASSERT_FALSE(schedule);
  EXPECT_NE(schedule.error().message.find("10 million"), std::string::npos);
}

TEST(CheckClearance, FindsTheThinnestWallOnTheWay) {
  WorldDescription description;
  description.walls = {{.a = {5.0, 0.2}, .b = {5.0, 0.21}}};
  const Result<World> world = World::make(description);
  ASSERT_TRUE(world);
  const Result<DrivePlan> plan = plan_drive({.start = {{0.0, 0.0}, Angle{}}, .legs = {{.to = Vec2{9.0, 0.0}}}}, 0.2);
  ASSERT_TRUE(plan);
  EXPECT_TRUE(check_clearance(*world, plan->trajectory, 0.19));
  const Result<void> hit = check_clearance(*world, plan->trajectory, 0.25);
  ASSERT_FALSE(hit);
  EXPECT_NE(hit.error().message.find("(4.85"), std::string::npos) << hit.error().message;
}

}  // namespace
}  // namespace echoarc::sim
