// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/localisation.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/executor.hpp"
#include "studies/localisation_drive.hpp"

namespace echoarc::studies {
namespace {

using nav::LocalisationState;

/// A room with an alcove, 5 x 4 m, that looks different from everywhere, and a way around in it.
sim::Scene odd_room() {
  sim::Scene scene;
  scene.name = "odd";
  const Vec2 corners[] = {{0.0, 0.0}, {5.0, 0.0}, {5.0, 3.0}, {3.5, 3.0}, {3.5, 4.0}, {0.0, 4.0}};
  for (std::size_t k = 0; k < 6; ++k) scene.world.walls.push_back({.a = corners[k], .b = corners[(k + 1) % 6]});
  scene.robot.radius_m = 0.2;
  scene.robot.sensors = SensorArray::make(ring(16, 0.2, Angle{}, SensorModel{})).value();
  scene.drive.start = {{1.0, 1.0}, Angle{}};
  for (const Vec2 to : {Vec2{4.0, 1.0}, Vec2{4.0, 2.0}, Vec2{2.5, 2.2}, Vec2{2.5, 3.2}, Vec2{1.0, 3.0}, Vec2{1.0, 1.0}})
    scene.drive.legs.push_back({.to = to, .turn = {}, .line = 0});
  scene.odometry.perfect = false;
  return scene;
}

LocalisationRequest request(KnownStart start, double limit_s) {
  LocalisationRequest request;
  request.scene = odd_room();
  request.start = start;
  request.limit_s = limit_s;
  request.laps = 3;
  request.options.search.spacing_m = 0.4;
  request.options.search.turn = degrees(15.0);
  request.options.search.window = 100;
  request.options.search.kept_of_batch = 30;
  request.options.search.kept = 200;
  return request;
}

struct Host {
  InlineExecutor executor;
  StudyHost host;
  Host() {
    host.executor = &executor;
    host.seeds = 1;
  }
};

std::size_t count(const DenseGrid<CellState>& map, CellState state) {
  return static_cast<std::size_t>(std::ranges::count(map.values(), state));
}

TEST(SurfaceMap, WallsAreOccupiedTheRoomIsFreeAndTheRestUnknown) {
  const DenseGrid<CellState> map = surface_map(odd_room().world, {1.0, 1.0}, 0.05);
  const auto at = [&](Vec2 p) { return map.at(map.geometry().cell_of(p)); };
  EXPECT_EQ(at({0.01, 2.0}), CellState::occupied);
  EXPECT_EQ(at({2.0, 2.0}), CellState::free);
  EXPECT_EQ(at({4.5, 3.5}), CellState::unknown) << "behind the alcove";
  EXPECT_NEAR(double(count(map, CellState::free)) * 0.05 * 0.05, 5.0 * 4.0 - 1.5, 18.0 * 0.05);
  EXPECT_NEAR(double(count(map, CellState::occupied)), 18.0 / 0.05, 8.0);
}

TEST(LocalisationDrive, WindowBeginsAtItsLegAndEndsInTime) {
  const sim::Drive whole = odd_room().drive;
  const sim::Drive window = window_of(whole, 1, 1.75);
  EXPECT_EQ(window.start.position, (Vec2{4.0, 1.0}));
  EXPECT_NEAR(window.start.heading.deg(), 0.0, 1e-9) << "as it came there";
  ASSERT_EQ(window.legs.size(), 2U);
  EXPECT_EQ(*window.legs[0].to, (Vec2{4.0, 2.0}));
  EXPECT_NEAR(norm(*window.legs[1].to - Vec2{4.0, 2.0}), 0.75, 1e-9) << "1 m is gone";
  EXPECT_EQ(window_of(whole, 0, 1e6).legs.size(), whole.legs.size());
}

TEST(LocalisationDrive, LapsFollowEachOther) {
  const sim::Drive thrice = repeated(odd_room().drive, 3);
  ASSERT_EQ(thrice.legs.size(), 18U);
  EXPECT_EQ(*thrice.legs[6].to, *thrice.legs[0].to);
}

TEST(LocalisationDrive, AnyLegLeavesEnoughOfTheWay) {
  const sim::Drive drive = odd_room().drive;
  std::set<std::size_t> drawn;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) drawn.insert(any_leg(drive, 3.4, seed));
  // The last two legs are 1.5 m and 2 m long, the four before them 6.5 m.
  EXPECT_EQ(drawn, (std::set<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(any_leg(drive, 1e6, 1), 0U) << "no leg is that far from the end";
}

TEST(LocalisationDrive, OdometryDoesNotNoticeThatTheRobotIsCarriedAway) {
  SimulatedDrive drive;
  for (int k = 0; k <= 10; ++k) {
    drive.log.odometry.push_back({double(k), {{0.1 * k, 0.0}, degrees(5.0 * k)}, 0});
    Reading reading;
    reading.time_s = k;
    reading.T_world_robot = drive.log.odometry.back().T_world_robot;
    drive.readings.push_back(reading);
  }
  drive.log.truth = drive.log.odometry;
  carry_away(drive, 3.0, 4.0);
  ASSERT_EQ(drive.log.odometry.size(), 7U) << "3 to 6 s are gone";
  EXPECT_EQ(drive.log.odometry.back().time_s, 6.0);
  // The pose after the cut is that at which it began, and the steps that follow are what they were.
  EXPECT_LT(norm(drive.log.odometry[3].T_world_robot.position - Vec2{0.3, 0.0}), 1e-12);
  EXPECT_NEAR(drive.log.odometry[4].T_world_robot.heading.deg(), 20.0, 1e-9);
  EXPECT_NEAR(drive.log.truth[3].T_world_robot.position.x, 0.7, 1e-12) << "truth is elsewhere";
  ASSERT_EQ(drive.readings.size(), 7U);
  EXPECT_EQ(drive.readings[4].T_world_robot, drive.log.odometry[4].T_world_robot);
}

TEST(Localising, KeepsThePoseItWasTold) {
  Host host;
  const auto runs = localise_seeds(request(KnownStart::pose, 30.0), host.host);
  ASSERT_TRUE(runs) << runs.error().message;
  const LocalisationRun& run = runs->front();
  EXPECT_NEAR(run.time_s, 30.0, 0.2);
  EXPECT_GT(run.localised_share, 0.95);
  EXPECT_LE(run.error_p95_m, 0.25);
  EXPECT_LE(run.heading_p95_deg, 5.0);
  EXPECT_EQ(run.wrong_claims, 0);
  EXPECT_EQ(run.found_s, 0.0) << "it was told";
  EXPECT_NEAR(double(run.samples.size()), 31.0, 1.0);
  EXPECT_GT(run.travelled_m, 5.0);
}

TEST(Localising, FindsThePoseItWasNotTold) {
  Host host;
  const auto runs = localise_seeds(request(KnownStart::nothing, 50.0), host.host);
  ASSERT_TRUE(runs) << runs.error().message;
  const LocalisationRun& run = runs->front();
  ASSERT_TRUE(run.found_s.has_value()) << run.last_word;
  EXPECT_GT(*run.found_s, 1.0);
  EXPECT_GT(run.ambiguous_share, 0.0);
  EXPECT_EQ(run.wrong_s, 0.0);
  EXPECT_EQ(run.samples.front().state, LocalisationState::lost);
  EXPECT_EQ(run.samples.back().state, LocalisationState::localised) << run.last_word;
}

TEST(Localising, SameSeedSameRunAndOtherSeedsOtherNoise) {
  Host host;
  host.host.seeds = 2;
  const auto first = localise_seeds(request(KnownStart::pose, 8.0), host.host, 5);
  const auto again = localise_seeds(request(KnownStart::pose, 8.0), host.host, 5);
  ASSERT_TRUE(first && again);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ((*first)[k].seed, 5 + k);
    EXPECT_EQ((*first)[k].error_p95_m, (*again)[k].error_p95_m);
    EXPECT_EQ((*first)[k].samples.back().T_map_believed, (*again)[k].samples.back().T_map_believed);
  }
  EXPECT_NE((*first)[0].error_p95_m, (*first)[1].error_p95_m);
}

TEST(Localising, WorksOnAMapThatWasHeard) {
  Host host;
  LocalisationRequest on_heard = request(KnownStart::pose, 12.0);
  on_heard.map = LocalisationMap::evidence;
  const auto runs = localise_seeds(on_heard, host.host);
  ASSERT_TRUE(runs) << runs.error().message;
  EXPECT_LE(runs->front().error_p95_m, 0.25);
  EXPECT_GT(runs->front().localised_share, 0.9) << runs->front().last_word;
}

TEST(Localising, RobotThatWasCarriedAwayIsFoundAgain) {
  Host host;
  LocalisationRequest carried = request(KnownStart::misled, 75.0);
  carried.carry_after_s = 6.0;
  carried.carry_ahead_s = 14.0;
  const auto runs = localise_seeds(carried, host.host);
  ASSERT_TRUE(runs) << runs.error().message;
  const LocalisationRun& run = runs->front();
  ASSERT_TRUE(run.found_s.has_value()) << run.last_word;
  EXPECT_GT(*run.found_s, 1.0) << "since it was carried away";
  EXPECT_GT(run.misled_s, 0.0) << "it cannot know at once";
  EXPECT_LT(run.misled_s, 15.0);
  EXPECT_EQ(run.samples.back().state, LocalisationState::localised) << run.last_word;
}

TEST(Localising, CancellationIsAnError) {
  Host host;
  host.host.cancelled = [] { return true; };
  const auto runs = localise_seeds(request(KnownStart::pose, 5.0), host.host);
  ASSERT_FALSE(runs);
  EXPECT_EQ(runs.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace echoarc::studies
