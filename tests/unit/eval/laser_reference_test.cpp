// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/eval/reference.hpp"

namespace echoarc {
namespace {

constexpr float no_return = std::numeric_limits<float>::quiet_NaN();

/// A robot that stands at (1, 1) looking along +y, its laser 0.1 m ahead of its centre, looking ahead as well.
Log standing_robot() {
  Log log;
  log.source = "standing";
  LaserMount laser;
  laser.id = 7;
  laser.mount.x_m = 0.1;
  log.robot.lasers.push_back(laser);
  for (const double t : {0.0, 10.0}) log.odometry.push_back({t, {{1.0, 1.0}, degrees(90.0)}, 0});
  return log;
}

/// Beams to the right, ahead, to the left, behind.
Scan scan_at(double time_s, std::vector<float> ranges_m) {
  return {time_s, 7, degrees(-90.0), degrees(90.0), std::move(ranges_m), 0};
}

TEST(LaserReference, PlacesReturnsThroughPoseAndMount) {
  Log log = standing_robot();
  // Seen from (1, 1.1): right hits (3.025, 1.1), left (0.025, 1.1).
  for (int k = 0; k < 3; ++k) log.scans.push_back(scan_at(k, {2.025F, no_return, 0.975F}));
  LaserReferenceOptions options;
  options.cell_m = 0.5;
  const auto reference = laser_reference(log, options);
  ASSERT_TRUE(reference) << reference.error().message;
  ASSERT_EQ(reference->points.size(), 2U);
  EXPECT_EQ(reference->points.points()[0], (Vec2{0.25, 1.25}));
  EXPECT_EQ(reference->points.points()[1], (Vec2{3.25, 1.25}));
  EXPECT_EQ(reference->points.cell_m(), 0.5);
  EXPECT_EQ(reference->spacing_m, 0.5);
  EXPECT_NE(reference->provenance.find("standing"), std::string::npos);
}

TEST(LaserReference, AsksForThreeReturnsPerCell) {
  Log log = standing_robot();
  log.scans.push_back(scan_at(0.0, {2.01F, no_return, 0.49F}));
  log.scans.push_back(scan_at(1.0, {2.02F, no_return, 0.48F}));
  EXPECT_FALSE(laser_reference(log)) << "two returns in either cell";
  log.scans.push_back(scan_at(2.0, {2.03F, no_return, no_return}));
  const auto reference = laser_reference(log);
  ASSERT_TRUE(reference);
  ASSERT_EQ(reference->points.size(), 1U);
  EXPECT_NEAR(reference->points.points()[0].x, 3.025, 1e-9);
}

TEST(LaserReference, LeavesOutRangesThatAreNoReturn) {
  Log log = standing_robot();
  log.robot.lasers[0].range_min_m = 0.3;
  for (const float range : {6.0F, 7.0F, 0.0F, -1.0F, 0.2F, std::numeric_limits<float>::infinity(), no_return})
    for (int k = 0; k < 3; ++k) log.scans.push_back(scan_at(k, {range}));
  EXPECT_FALSE(laser_reference(log)) << "6 m and beyond, or below the laser's smallest range";
  for (int k = 0; k < 3; ++k) log.scans.push_back(scan_at(k, {5.99F}));
  ASSERT_TRUE(laser_reference(log));
  log.robot.lasers[0].range_max_m = 5.0;
  EXPECT_FALSE(laser_reference(log)) << "the laser cannot see that far";
}

TEST(LaserReference, InterpolatesThePoseOfAScan) {
  Log log = standing_robot();
  log.odometry = {{0.0, {{0.0, 0.0}, {}}, 0}, {1.0, {{4.0, 0.0}, {}}, 0}};
  Scan ahead = scan_at(0.75, {1.01F, 1.01F, 1.01F});
  ahead.angle_min = ahead.angle_step = Angle{};
  log.scans.push_back(ahead);
  const auto reference = laser_reference(log);
  ASSERT_TRUE(reference);
  ASSERT_EQ(reference->points.size(), 1U);
  EXPECT_NEAR(reference->points.points()[0].x, 4.125, 1e-9) << "3 m of odometry, 0.1 m of mount, 1.01 m of range";
}

TEST(LaserReference, SaysWhatIsMissing) {
  Log log = standing_robot();
  EXPECT_EQ(laser_reference(log).error().code, ErrorCode::not_found) << "no scan";
  log.scans.push_back(scan_at(0.0, {1.0F, 1.0F, 1.0F}));
  LaserReferenceOptions bad;
  bad.cell_m = 0.0;
  EXPECT_FALSE(laser_reference(log, bad));

  Log undescribed = log;
  undescribed.robot.lasers.clear();
  EXPECT_NE(laser_reference(undescribed).error().message.find("laser 7"), std::string::npos);
  Log unplaced = log;
  unplaced.odometry.clear();
  EXPECT_NE(laser_reference(unplaced).error().message.find("odometry"), std::string::npos);
  Log elsewhen = log;
  elsewhen.scans[0].time_s = 99.0;
  EXPECT_FALSE(laser_reference(elsewhen)) << "no scan has a pose";
}

TEST(LaserReference, StopsAtItsMemoryLimit) {
  Log log = standing_robot();
  log.odometry = {{0.0, {{0.0, 0.0}, {}}, 0}, {1.0, {{1e7, 1e7}, {}}, 0}};
  log.scans.push_back(scan_at(0.0, {1.0F}));
  log.scans.push_back(scan_at(1.0, {1.0F}));
  const auto reference = laser_reference(log);
  ASSERT_FALSE(reference);
  EXPECT_EQ(reference.error().code, ErrorCode::too_large);
}

}  // namespace
}  // namespace echoarc
