// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/nav/path.hpp"
#include "echoarc/nav/progress_watch.hpp"
#include "echoarc/nav/replanner.hpp"
#include "unit/nav/plan_maps.hpp"

namespace echoarc::nav {
namespace {

using State = Replanner::State;

/// A room of 4 m with a robot in its lower left corner that is to go to the right.
struct Room {
  explicit Room(const ReplannerOptions& options = {}) : replanner(options, {}, {}) {
    costs.update(map);
    replanner.set_goals({{{3.55, 0.55}, 0.0}});
  }
  void update(double time_s) {
    costs.update(map);
    replanner.update(costs, T_world_base, time_s);
  }

  DenseGrid<CellState> map = free_map(40, 40);
  CostMap costs{{}, 0.2};
  Pose2 T_world_base{{0.55, 0.55}, {}};
  Replanner replanner;
};

TEST(Replanner, PlansOnceWhileThePathIsClear) {
  Room room({.period_s = 5.0});
  for (double time_s = 0.0; time_s < 4.9; time_s += 0.1) room.update(time_s);
  EXPECT_EQ(room.replanner.state(), State::ready);
  EXPECT_EQ(room.replanner.plans(), 1U);
  occupy(room.map, {{0.0, 3.0}, {4.0, 3.1}});
  room.update(4.9);
  EXPECT_EQ(room.replanner.plans(), 1U) << "what does not cut the path does not matter";
  room.update(5.1);
  EXPECT_EQ(room.replanner.plans(), 2U) << "every period";
}

TEST(Replanner, PlansAnewWhenTheMapCutsThePath) {
  Room room;
  room.update(0.0);
  occupy(room.map, {{2.0, 0.0}, {2.1, 2.0}});
  room.update(0.1);
  EXPECT_EQ(room.replanner.cuts(), 1U);
  EXPECT_EQ(room.replanner.plans(), 2U);
  ASSERT_EQ(room.replanner.state(), State::ready);
  EXPECT_TRUE(path_cost(room.costs.cost_per_m(), room.replanner.path()));
  occupy(room.map, {{2.0, 2.0}, {2.1, 4.0}});
  room.update(0.2);
  EXPECT_EQ(room.replanner.state(), State::failed);
  EXPECT_EQ(room.replanner.fault(), PlanFault::unreachable);
  EXPECT_TRUE(room.replanner.path().empty());
  occupy(room.map, {{2.0, 1.0}, {2.1, 2.0}}, CellState::free);
  room.update(0.3);
  EXPECT_EQ(room.replanner.state(), State::failed) << "it is not tried again at once";
  room.update(0.8);
  EXPECT_EQ(room.replanner.state(), State::ready);
}

TEST(Replanner, PlansAnewWhenTheRobotHasLeftThePath) {
  Room room({.off_path_m = 0.5});
  room.update(0.0);
  room.T_world_base.position = {0.55, 3.55};
  room.update(0.1);
  ASSERT_EQ(room.replanner.state(), State::ready);
  EXPECT_EQ(room.replanner.plans(), 2U);
  EXPECT_EQ(room.replanner.path().front(), room.T_world_base.position);
}

TEST(Replanner, SpreadsALongSearchOverSteps) {
  Room room({.expansions = 100});
  occupy(room.map, {{2.0, 0.0}, {2.1, 3.0}});
  room.update(0.0);
  EXPECT_EQ(room.replanner.state(), State::planning);
  int steps = 1;
  while (room.replanner.state() == State::planning && steps < 100) room.update(0.1 * steps++);
  EXPECT_EQ(room.replanner.state(), State::ready);
  EXPECT_GT(steps, 3);
}

TEST(Replanner, DrivesOnWhileThePeriodsPlanIsMade) {
  Room room({.period_s = 1.0, .expansions = 100});
  occupy(room.map, {{2.0, 0.0}, {2.1, 3.0}});
  double time_s = 0.0;
  for (; room.replanner.state() != State::ready; time_s += 0.1) room.update(time_s);
  for (int k = 0; k < 50; ++k, time_s += 0.1) {
    room.update(time_s);
    ASSERT_EQ(room.replanner.state(), State::ready) << time_s;
  }
  EXPECT_GT(room.replanner.plans(), 2U);
}

TEST(Replanner, AnObstacleBesideTheRobotIsNoCutOfTheWayOut) {
  Room room;
  room.update(0.0);
  room.map.at({6, 5}) = CellState::occupied;  // beside the robot: it stands in its inflation now
  room.update(0.1);
  ASSERT_EQ(room.replanner.state(), State::ready);
  const std::size_t plans = room.replanner.plans();
  for (double time_s = 0.2; time_s < 2.0; time_s += 0.1) {
    room.map.at({20, 39}) = time_s < 1.0 ? CellState::free : CellState::occupied;
    room.update(time_s);
  }
  EXPECT_EQ(room.replanner.plans(), plans) << "one way out is enough";
}

TEST(Replanner, AWayOutOfAPocketIsNoCut) {
  Room room;
  room.costs.drive_through(room.T_world_base.position, room.T_world_base.position);
  occupy(room.map, {{0.0, 0.0}, {1.3, 1.3}}, CellState::unknown);
  for (double time_s = 0.0; time_s < 3.0; time_s += 0.1) room.update(time_s);
  EXPECT_EQ(room.replanner.state(), State::ready);
  EXPECT_EQ(room.replanner.plans(), 1U);
}

TEST(Replanner, WithoutAGoalItIsIdle) {
  Room room;
  room.replanner.set_goals({});
  room.update(0.0);
  EXPECT_EQ(room.replanner.state(), State::idle);
  EXPECT_EQ(room.replanner.plans(), 0U);
}

RC_GTEST_PROP(ReplannerProperty, ThePathIsAlwaysClearOnTheMapOfNow, (std::uint64_t seed)) {
  Rng rng(seed);
  Room room({.expansions = int(100 + rng.below(2000))});
  for (int k = 0; k < 40; ++k) {
    if (rng.uniform() < 0.5)
      room.map.at({std::int32_t(10 + rng.below(20)), std::int32_t(rng.below(40))}) =
          rng.uniform() < 0.8 ? CellState::occupied : CellState::free;
    room.update(0.1 * k);
    if (room.replanner.state() == State::ready && room.costs.cost_per_m().at({5, 5}) > 0.0F)
      RC_ASSERT(path_cost(room.costs.cost_per_m(), room.replanner.path()).has_value());
  }
}

TEST(ProgressWatch, TellsStandingFromGettingOn) {
  ProgressWatch watch(20.0);
  double remaining_m = 30.0;
  for (double time_s = 0.0; time_s < 60.0; time_s += 1.0, remaining_m -= 0.02)
    ASSERT_FALSE(watch.stalled(time_s, remaining_m)) << time_s << ": slowly, but it moves";
  for (double time_s = 60.0; time_s < 75.0; time_s += 1.0) ASSERT_FALSE(watch.stalled(time_s, remaining_m));
  EXPECT_TRUE(watch.stalled(85.0, remaining_m));
  watch.reset();
  EXPECT_FALSE(watch.stalled(86.0, remaining_m));
}

TEST(ProgressWatch, DetoursGiveTimeButNotForEver) {
  ProgressWatch watch(20.0);
  EXPECT_FALSE(watch.stalled(0.0, 5.0));
  EXPECT_FALSE(watch.stalled(19.0, 9.0));
  EXPECT_FALSE(watch.stalled(38.0, 8.95)) << "the longer way began at 19 s";
  EXPECT_TRUE(watch.stalled(40.0, 8.95));
  watch.reset();
  double stalled_s = 0.0;
  for (double time_s = 0.0; time_s < 1000.0 && stalled_s == 0.0; time_s += 5.0)
    if (watch.stalled(time_s, int(time_s / 5.0) % 2 == 0 ? 5.0 : 6.0)) stalled_s = time_s;
  EXPECT_GT(stalled_s, 20.0) << "two ways that take turns";
}

}  // namespace
}  // namespace echoarc::nav
