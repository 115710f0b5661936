// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "echoarc/nav/global_localisation.hpp"
#include "localise_ray_world.hpp"

namespace echoarc::nav {
namespace {

using testing::even_room;
using testing::grid_of;
using testing::loop;
using testing::odd_room;
using testing::Walls;
using testing::Wanderer;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Pose2 T_world_start{{0.7, 0.7}, {}};

/// Whether a pose is the robot's.
bool right(const PoseEstimate& estimate, const Wanderer& robot) {
  const Pose2& T = robot.T_world_robot();
  return norm(estimate.T_map_robot.position - T.position) < 0.4 &&
         abs(wrap(estimate.T_map_robot.heading - T.heading)) < degrees(15.0);
}

struct Drive {
  std::vector<double> errors_m;  ///< while localised
  std::vector<double> errors_deg;
  int steps = 0;
  int wrong = 0;  ///< steps on which a wrong pose was believed
  double p95_m() const { return percentile(errors_m); }
  double p95_deg() const { return percentile(errors_deg); }

 private:
  static double percentile(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::infinity();
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1))];
  }
};

/// Goes around the loop from place to place until so many steps are made.
Drive drive(GlobalLocalisation& localisation, Wanderer& robot, int steps, std::size_t first_place = 1) {
  Drive drive;
  std::size_t place = first_place;
  for (; drive.steps < steps; ++drive.steps) {
    while (!robot.step_towards(loop()[place % loop().size()])) ++place;
    localisation.update(robot.T_odom_robot(), robot.listen());
    const PoseEstimate& estimate = localisation.estimate();
    if (estimate.state != LocalisationState::localised) continue;
    const Pose2& T = robot.T_world_robot();
    drive.errors_m.push_back(norm(estimate.T_map_robot.position - T.position));
    drive.errors_deg.push_back(abs(wrap(estimate.T_map_robot.heading - T.heading)).deg());
    if (!right(estimate, robot)) ++drive.wrong;
  }
  return drive;
}

/// Few candidates: the rooms are small, and the tests shall be quick.
LocalisationOptions quick() {
  LocalisationOptions options;
  options.search.spacing_m = 0.4;
  options.search.turn = degrees(15.0);
  options.search.kept_of_batch = 30;
  options.search.kept = 200;
  options.search.climbs = 6;
  options.search.window = 100;
  return options;
}

GlobalLocalisation on_map(const Walls& walls, std::uint64_t seed = 1) {
  GlobalLocalisation localisation(quick(), seed);
  localisation.set_map(grid_of(walls));
  return localisation;
}

TEST(Localisation, TracksThroughDriftOverTwentyMetres) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 2);
  localisation.start_at(T_world_start);
  const Drive result = drive(localisation, robot, 290);
  EXPECT_GT(result.errors_m.size(), 0.95 * result.steps);
  EXPECT_LE(result.p95_m(), 0.25);
  EXPECT_LE(result.p95_deg(), 5.0);
  EXPECT_EQ(result.wrong, 0);
  // Odometry alone has gone astray by more than that.
  const Pose2 T_world_believed = T_world_start * robot.T_odom_robot();
  EXPECT_GT(abs(wrap(T_world_believed.heading - robot.T_world_robot().heading)).deg(), 5.0);
}

TEST(Localisation, FindsThePoseInARoomThatLooksDifferentFromEverywhere) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 3);
  EXPECT_EQ(localisation.estimate().state, LocalisationState::lost);
  const Drive result = drive(localisation, robot, 110);
  EXPECT_EQ(localisation.estimate().state, LocalisationState::localised) << localisation.estimate().reason;
  EXPECT_TRUE(right(localisation.estimate(), robot));
  EXPECT_EQ(result.wrong, 0);
}

TEST(Localisation, SaysThatARoomThatLooksTheSameTurnedIsAmbiguous) {
  GlobalLocalisation localisation = on_map(even_room());
  Wanderer robot(even_room(), T_world_start, 3);
  const Drive result = drive(localisation, robot, 110);
  EXPECT_TRUE(result.errors_m.empty());
  const PoseEstimate& estimate = localisation.estimate();
  EXPECT_EQ(estimate.state, LocalisationState::ambiguous) << estimate.reason;
  ASSERT_GE(estimate.clusters.size(), 2U);
  // The two are each other turned by half a turn about the middle of the room.
  const Pose2 T_map_turned{Vec2{5.0, 4.0} - estimate.clusters[1].T_map_robot.position,
                           estimate.clusters[1].T_map_robot.heading + degrees(180.0)};
  EXPECT_LT(norm(T_map_turned.position - estimate.clusters[0].T_map_robot.position), 0.3);
  EXPECT_LT(abs(wrap(T_map_turned.heading - estimate.clusters[0].T_map_robot.heading)), degrees(10.0));
}

TEST(Localisation, FindsARobotThatWasCarriedAway) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 4);
  localisation.start_at(T_world_start);
  EXPECT_EQ(drive(localisation, robot, 40).wrong, 0);
  robot.carry({{3.2, 3.0}, degrees(-100.0)});
  const Drive after = drive(localisation, robot, 160, 6);
  EXPECT_LT(after.wrong, 50);  // until its fit has sunk, over one or two metres and the turn at the beginning
  EXPECT_EQ(localisation.estimate().state, LocalisationState::localised) << localisation.estimate().reason;
  EXPECT_TRUE(right(localisation.estimate(), robot));
}

TEST(Localisation, HypothesesOfALongSearchFollowTheReadingsWhileOdometryDrifts) {
  const LikelihoodMap map(grid_of(odd_room()));
  Wanderer robot(odd_room(), T_world_start, 5);
  PoseSearchOptions options;
  options.batch = 100;
  options.kept_of_batch = 1;
  PoseSearch search(options);
  search.begin(1e6);  // far more than it will get through
  search.add(T_world_start);
  Rng rng(1);
  Pose2 T_map_reckoned = T_world_start;
  std::size_t place = 1;
  for (int n = 0; n < 60; ++n) {
    const Pose2 T_odom_before = robot.T_odom_robot();
    while (!robot.step_towards(loop()[place % loop().size()])) ++place;
    Pose2 T_before_now = inverse(T_odom_before) * robot.T_odom_robot();
    T_before_now.heading = T_before_now.heading + degrees(0.5);  // as from a wheel that is too small
    T_map_reckoned = T_map_reckoned * T_before_now;
    search.move(T_before_now);
    ReadingProbes probes(map, {});
    for (const Reading& reading : robot.listen()) probes.add(reading, robot.T_odom_robot());
    search.step(map, probes, probes, rng);
  }
  const Pose2& T_true = robot.T_world_robot();
  EXPECT_GT(norm(T_map_reckoned.position - T_true.position), 0.5);
  const Pose2& T_best = search.hypotheses().front().T_map_robot;
  EXPECT_LT(norm(T_best.position - T_true.position), 0.2);
  EXPECT_LT(abs(wrap(T_best.heading - T_true.heading)), degrees(6.0));
}

TEST(Localisation, OneSeedGivesTheSameEstimateBitForBit) {
  const auto run = [](std::uint64_t seed) {
    GlobalLocalisation localisation = on_map(odd_room(), seed);
    Wanderer robot(odd_room(), T_world_start, 3);
    drive(localisation, robot, 40);
    const PoseEstimate& e = localisation.estimate();
    return std::array{std::bit_cast<std::uint64_t>(e.T_map_robot.position.x),
                      std::bit_cast<std::uint64_t>(e.T_map_robot.heading.rad()), std::bit_cast<std::uint64_t>(e.fit)};
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(Localisation, CarriesThePoseOnBetweenSteps) {
  GlobalLocalisation localisation = on_map(odd_room());
  localisation.start_at({{1.0, 1.0}, degrees(90.0)}, 0.0, {});
  localisation.update({{5.0, 5.0}, {}}, {});
  localisation.update({{5.05, 5.0}, degrees(2.0)}, {});
  const Pose2& T_map_robot = localisation.estimate().T_map_robot;
  EXPECT_NEAR(T_map_robot.position.x, 1.0, 1e-9);
  EXPECT_NEAR(T_map_robot.position.y, 1.05, 1e-9);
  EXPECT_NEAR(T_map_robot.heading.deg(), 92.0, 1e-9);
}

std::string reason_on(const DenseGrid<CellState>& grid) {
  GlobalLocalisation localisation;
  localisation.set_map(grid);
  Wanderer robot(odd_room(), T_world_start, 3);
  drive(localisation, robot, 30);
  EXPECT_EQ(localisation.estimate().state, LocalisationState::lost);
  return localisation.estimate().reason;
}

TEST(Localisation, SaysWhatIsWrongWithAMap) {
  EXPECT_EQ(reason_on({}), "there is no map");
  const DenseGrid<CellState> unknown({0.05, {}}, 50, 50, CellState::unknown);
  EXPECT_EQ(reason_on(unknown), "the map holds no wall to localise by");
  const DenseGrid<CellState> bare({0.05, {}}, 50, 50, CellState::free);
  EXPECT_EQ(reason_on(bare), "the map holds no wall to localise by");
  const DenseGrid<CellState> solid({0.05, {}}, 50, 50, CellState::occupied);
  EXPECT_EQ(reason_on(solid), "the map holds no free floor to stand on");
  GlobalLocalisation localisation;
  localisation.start_at(T_world_start);
  localisation.update({}, {});
  EXPECT_EQ(localisation.estimate().reason, "there is no map");
}

std::vector<Reading> silent(std::vector<Reading> readings) {
  for (Reading& reading : readings) reading.outcome = NoEcho{};
  return readings;
}

TEST(Localisation, IsLostAfterThreeMetresOfSilence) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 3);
  localisation.start_at(T_world_start);
  std::size_t place = 1;
  for (int n = 0; n < 60; ++n) {
    while (!robot.step_towards(loop()[place % loop().size()])) ++place;
    localisation.update(robot.T_odom_robot(), silent(robot.listen()));
  }
  EXPECT_EQ(localisation.estimate().state, LocalisationState::lost);
  EXPECT_TRUE(localisation.estimate().reason.starts_with("no echo for")) << localisation.estimate().reason;
}

TEST(Localisation, SearchesNothingWhileNothingIsHeard) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 3);
  for (int n = 0; n < 30; ++n) {
    robot.step({{0.1, 0.0}, degrees(30.0)});
    localisation.update(robot.T_odom_robot(), silent(robot.listen()));
  }
  EXPECT_EQ(localisation.estimate().reason, "the pose is not known yet; listening for echoes");
}

TEST(Localisation, PassesOverAPoseThatIsNoNumber) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 3);
  localisation.start_at(T_world_start);
  drive(localisation, robot, 20);
  localisation.update({{nan, 0.0}, {}}, robot.listen());
  EXPECT_EQ(localisation.estimate().state, LocalisationState::lost);
  EXPECT_EQ(localisation.estimate().reason, "the pose of odometry is not finite");
  EXPECT_TRUE(is_finite(localisation.estimate().T_map_robot));
  localisation.start_at({{0.0, nan}, {}});
  EXPECT_EQ(localisation.estimate().state, LocalisationState::lost);
  localisation.start_at(robot.T_world_robot());
  Reading broken;
  broken.outcome = Echo{nan};
  broken.T_world_rx.heading = radians(nan);
  localisation.update(robot.T_odom_robot(), std::vector<Reading>(5, broken));
  const Drive after = drive(localisation, robot, 20, 2);
  EXPECT_EQ(after.errors_m.size(), 20U);
  EXPECT_EQ(after.wrong, 0);
}

TEST(Localisation, ADriveThroughAJumpOfOdometryIsBelievedOnlyLater) {
  GlobalLocalisation localisation = on_map(odd_room());
  Wanderer robot(odd_room(), T_world_start, 3);
  localisation.start_at(T_world_start);
  drive(localisation, robot, 20);
  robot.jump_odometry({{30.0, -20.0}, degrees(120.0)});
  localisation.update(robot.T_odom_robot(), robot.listen());
  EXPECT_EQ(localisation.estimate().state, LocalisationState::lost);
  EXPECT_TRUE(localisation.estimate().reason.starts_with("odometry jumped by")) << localisation.estimate().reason;
  EXPECT_TRUE(right(localisation.estimate(), robot));
  const Drive after = drive(localisation, robot, 100, 1);
  EXPECT_EQ(after.wrong, 0);
  EXPECT_EQ(localisation.estimate().state, LocalisationState::localised) << localisation.estimate().reason;
}

TEST(Localisation, ACorridorsDirectionCorrectsTheHeading) {
  GlobalLocalisation localisation = on_map(odd_room());
  localisation.start_at({{1.0, 1.0}, degrees(4.0)}, 0.0, degrees(5.0));
  localisation.update({}, {});
  for (int n = 0; n < 3; ++n) {
    localisation.correct_heading(degrees(90.0), degrees(0.0), degrees(1.0));
    localisation.update({{0.0, 0.0}, degrees(5.1 * (n + 1))}, {});
    localisation.correct_heading(degrees(-5.1 * (n + 1)), degrees(0.0), degrees(1.0));
  }
  localisation.update({{0.0, 0.0}, degrees(20.4)}, {});
  EXPECT_NEAR(localisation.estimate().T_map_robot.heading.deg(), 20.4, 1.0);
  localisation.correct_heading(degrees(nan), {}, degrees(1.0));
  localisation.correct_heading({}, {}, {});
  EXPECT_TRUE(is_finite(localisation.estimate().T_map_robot));
}

TEST(Localisation, OptionsAreLegal) {
  EXPECT_TRUE(validate(LocalisationOptions{}));
  EXPECT_TRUE(validate(ParticleFilterOptions{}));
  EXPECT_TRUE(validate(MotionNoiseOptions{}));
  EXPECT_TRUE(validate(ReadingModelOptions{}));
  EXPECT_TRUE(validate(PoseSearchOptions{}));
  EXPECT_EQ(name(LocalisationState::ambiguous), "ambiguous");
}

}  // namespace
}  // namespace echoarc::nav
