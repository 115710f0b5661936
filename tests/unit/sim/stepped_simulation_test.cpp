// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/sim/stepped_simulation.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace echoarc::sim {
namespace {

/// Records as text, every bit of every number in it.
struct Written {
  std::string text;
  void number(double value) {
    char buffer[40];
    (void)std::snprintf(buffer, sizeof buffer, " %a", value);
    text += buffer;
  }
  void pose(char kind, const Odometry& of) {
    text += kind;
    for (const double v :
         {of.time_s, of.T_world_robot.position.x, of.T_world_robot.position.y, of.T_world_robot.heading.rad()})
      number(v);
  }
  void operator()(const Odometry& odometry) { pose('o', odometry); }
  void operator()(const TruePose& truth) { pose('t', truth.pose); }
  void operator()(const Ping& ping) {
    text += 'p';
    for (const double v : {ping.time_s, double(ping.tx), double(ping.rx), ping.range_m, double(ping.cause)}) number(v);
  }
  void operator()(const Scan& scan) {
    text += 's';
    number(scan.time_s);
    for (const float range_m : scan.ranges_m) number(double(range_m));
  }
  void operator()(const Poll& poll) {
    text += 'r';
    number(poll.time_s);
    for (const double range_m : poll.ranges_m) number(range_m);
  }
};

std::string written(const std::vector<SteppedRecord>& records) {
  Written all;
  for (const SteppedRecord& record : records) std::visit(all, record);
  return all.text;
}

/// Everything at once: errors of all kinds, drift, a laser, someone who walks about.
Scene busy_scene() {
  Scene scene = room_scene(8, SonarOptions{});
  scene.odometry.perfect = false;
  scene.robot.lasers = {{.id = 3}};
  scene.lasers = {{.laser = 3, .beams = 11, .rate_hz = 7.0}};
  scene.world.moving = {{.radius_m = 0.2, .path = {{0.0, {3.5, 0.5}}, {6.0, {3.5, 2.5}}}}};
  return scene;
}

/// The same commands at the same times, on the way there as many stops as the slice makes.
std::string drive(const Scene& scene, double slice_s, std::uint64_t seed = 7) {
  SteppedSimulation simulation = SteppedSimulation::make(scene, seed).value();
  std::vector<SteppedRecord> records;
  const RobotVelocity commands[] = {
      {0.3, Angle{}}, {0.2, degrees(40.0)}, {-0.3, degrees(10.0)}, {0.0, -degrees(50.0)}, {0.5, Angle{}}};
  const double times_s[] = {0.0, 0.7, 1.503, 2.71, 3.0, 6.0};
  for (std::size_t k = 0; k < 5; ++k) {
    simulation.command(commands[k], 1.0);
    for (double at_s = times_s[k]; at_s < times_s[k + 1]; at_s += slice_s) simulation.advance(at_s, records);
    simulation.advance(times_s[k + 1], records);
  }
  return written(records);
}

TEST(SteppedSimulation, SaysTheSameHoweverItIsSliced) {
  Scene polled = busy_scene();
  polled.polling.polled = true;
  for (const Scene& scene : {busy_scene(), polled}) {
    const std::string whole = drive(scene, 100.0);
    EXPECT_GT(whole.size(), 10'000U);
    for (const double slice_s : {0.001, 0.0037, 0.01, 0.3}) EXPECT_EQ(drive(scene, slice_s), whole) << slice_s;
    EXPECT_NE(drive(scene, 100.0, 8), whole);
  }
}

TEST(SteppedSimulation, AtRestItAgreesWithSimulate) {
  for (const bool polled : {false, true}) {
    Scene scene = busy_scene();
    scene.drive.dwell_s = 6.0;
    scene.drive.facing = degrees(30.0);
    scene.polling.polled = polled;
    const Simulation scripted = simulate(scene, 5).value();
    SteppedSimulation stepped = SteppedSimulation::make(scene, 5).value();
    std::vector<SteppedRecord> records;
    stepped.advance(6.0, records);
    std::vector<SteppedRecord> pings;
    std::vector<SteppedRecord> scans;
    std::vector<SteppedRecord> polls;
    std::vector<SteppedRecord> poses;
    for (const SteppedRecord& record : records) {
      if (std::holds_alternative<Ping>(record)) pings.push_back(record);
      if (std::holds_alternative<Scan>(record)) scans.push_back(record);
      if (std::holds_alternative<Poll>(record)) polls.push_back(record);
      if (std::holds_alternative<Odometry>(record)) poses.push_back(record);
    }
    const Log& log = scripted.log;
    EXPECT_EQ(written(pings), written({log.pings.begin(), log.pings.end()}));
    EXPECT_EQ(written(scans), written({log.scans.begin(), log.scans.end()}));
    EXPECT_EQ(written(poses), written({log.odometry.begin(), log.odometry.end()}));
    ASSERT_GE(log.polls.size(), polls.size());  // of the script until the last time-out
    EXPECT_EQ(written(polls), written({log.polls.begin(), log.polls.begin() + std::ptrdiff_t(polls.size())}));
    EXPECT_EQ(pings.empty(), polled);
    EXPECT_EQ(polls.empty(), !polled);
  }
}

TEST(SteppedSimulation, ATurretLooksAsideOrKeepsItsHeading) {
  Scene scene = room_scene(1);
  scene.drive.facing = degrees(90.0);
  for (const bool keep : {false, true}) {
    scene.drive.keep_heading = keep;
    SteppedSimulation simulation = SteppedSimulation::make(scene, 1).value();
    std::vector<SteppedRecord> records;
    simulation.command({0.3, degrees(20.0)});
    simulation.advance(3.0, records);
    const Pose2 T_world_base = simulation.T_world_base();
    const Pose2 T_world_robot = simulation.T_world_robot();
    EXPECT_GT(T_world_base.heading.deg(), 30.0);
    EXPECT_GT(norm(T_world_base.position - scene.drive.start.position), 0.3);
    EXPECT_EQ(T_world_robot.position, T_world_base.position);
    EXPECT_NEAR(T_world_robot.heading.deg(), keep ? 90.0 : T_world_base.heading.deg() + 90.0, 1e-9);
    EXPECT_EQ(std::get<TruePose>(records[1]).pose.T_world_robot.heading, degrees(90.0));
    EXPECT_NEAR(norm(simulation.T_odom_base().position - T_world_base.position), 0.0, 1e-9);
  }
}

TEST(SteppedSimulation, TheBumperHoldsItAtAWall) {
  SteppedSimulation simulation = SteppedSimulation::make(room_scene(1), 1).value();
  std::vector<SteppedRecord> records;
  simulation.command({0.6, Angle{}});
  simulation.advance(10.0, records);
  EXPECT_TRUE(simulation.touching());
  EXPECT_EQ(simulation.contacts(), 1U);
  EXPECT_LE(simulation.T_world_base().position.x, 3.8);
  EXPECT_GT(simulation.T_world_base().position.x, 3.79);
  EXPECT_LT(std::abs(simulation.velocity().forward_m_s), 0.01);
  const double travelled_m = simulation.travelled_m();
  EXPECT_NEAR(travelled_m, 2.3, 0.01);
  simulation.command({-0.6, Angle{}});
  simulation.advance(12.0, records);
  EXPECT_FALSE(simulation.touching());
  EXPECT_LT(simulation.T_world_base().position.x, 3.5);
  EXPECT_EQ(simulation.contacts(), 1U);
}

TEST(SteppedSimulation, WhoWalksIntoItIsFelt) {
  Scene scene = room_scene(1);
  scene.world.moving = {{.radius_m = 0.2, .path = {{1.0, {3.5, 1.2}}, {5.0, {1.7, 1.2}}, {9.0, {3.5, 1.2}}}}};
  SteppedSimulation simulation = SteppedSimulation::make(scene, 1).value();
  std::vector<SteppedRecord> records;
  simulation.advance(3.0, records);
  EXPECT_EQ(simulation.contacts(), 0U);
  simulation.advance(5.0, records);
  EXPECT_TRUE(simulation.touching());
  const Vec2 before = simulation.T_world_base().position;
  simulation.command({0.3, Angle{}});  // into who stands there
  simulation.advance(5.3, records);
  EXPECT_EQ(simulation.T_world_base().position, before);
  simulation.command({-0.3, Angle{}});
  simulation.advance(7.0, records);
  EXPECT_LT(simulation.T_world_base().position.x, before.x - 0.1);
  EXPECT_FALSE(simulation.touching());
  EXPECT_EQ(simulation.contacts(), 1U);
}

TEST(SteppedSimulation, RefusesWhatSimulateRefuses) {
  Scene scene = room_scene(2);
  scene.file = "room.toml";
  scene.drive.start.position = {0.1, 1.0};
  const auto in_a_wall = SteppedSimulation::make(scene, 1);
  ASSERT_FALSE(in_a_wall);
  EXPECT_EQ(in_a_wall.error().message, simulate(scene, 1).error().message);
  EXPECT_EQ(in_a_wall.error().where, simulate(scene, 1).error().where);
  scene = room_scene(2);
  scene.robot.sensors = {};
  EXPECT_FALSE(SteppedSimulation::make(scene, 1));
  scene = room_scene(2);
  scene.sonar.interval_s = -1.0;
  EXPECT_FALSE(SteppedSimulation::make(scene, 1));
  EXPECT_FALSE(SteppedSimulation::make(room_scene(2), 1, {.speed_m_s = -1.0}));
}

TEST(SteppedSimulation, IgnoresTimesThatAreNone) {
  SteppedSimulation simulation = SteppedSimulation::make(room_scene(2), 1).value();
  std::vector<SteppedRecord> records;
  simulation.advance(1.0, records);
  const std::size_t said = records.size();
  for (const double until_s :
       {0.5, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    simulation.advance(until_s, records);
  EXPECT_EQ(simulation.time_s(), 1.0);
  EXPECT_EQ(records.size(), said);
}

TEST(SimulatedRobot, BrakesAtAnotherDecelerationThanItSpeedsUp) {
  SimulatedRobot robot(Pose2{});
  robot.command({0.6, Angle{}}, 1.5);
  robot.step(1.0);
  EXPECT_NEAR(robot.velocity().forward_m_s, 0.3, 1e-9);
  robot.step(1.0);
  robot.command({-0.3, Angle{}}, 1.5);
  robot.step(0.4);  // from 0.6 to rest
  EXPECT_NEAR(robot.velocity().forward_m_s, 0.0, 1e-9);
  robot.step(0.5);  // and back at the limit
  EXPECT_NEAR(robot.velocity().forward_m_s, -0.15, 1e-9);
  robot.command({0.0, Angle{}});
  robot.step(0.25);
  EXPECT_NEAR(robot.velocity().forward_m_s, -0.075, 1e-9);
}

}  // namespace
}  // namespace echoarc::sim
