// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "echoarc/live/navigator.hpp"
#include "unit/live/robot_fixture.hpp"

namespace echoarc::live {
namespace {

/// Says the same for so many steps, then ends.
class Fixed final : public nav::Strategy {
 public:
  Fixed(const RobotVelocity& wanted, int steps, nav::Status end) : wanted_(wanted), steps_(steps), end_(end) {}
  [[nodiscard]] std::string_view name() const override { return "fixed"; }
  [[nodiscard]] nav::Steering update(const nav::Surroundings& surroundings) override {
    seen_points = surroundings.points.size();
    map_version = surroundings.map_version;
    if (steps_-- > 0) return {.wanted = wanted_, .reason = "going", .followed = WallSide::left};
    return {.status = end_, .reason = "it is over"};
  }
  std::size_t seen_points = 0;
  std::uint64_t map_version = 0;

 private:
  RobotVelocity wanted_;
  int steps_;
  nav::Status end_;
};

LiveRobot navigated(const NavigatorOptions& options = {}) {
  auto source = SimulatedSource::make(plain_room(), 1).value();
  Navigator navigator = Navigator::make(source->description(), options).value();
  return LiveRobot(std::move(source), {}, std::move(navigator));
}

void run(LiveRobot& robot, double from_s, double to_s, std::vector<Record>& records) {
  constexpr double step_s = 0.02;
  for (double time_s = from_s + step_s; time_s < to_s; time_s += step_s)
    ASSERT_TRUE(robot.step(time_s, time_s, records));
}

TEST(Navigator, StrategySeesPointsAndMapAndItsWishIsDriven) {
  LiveRobot robot = navigated();
  auto strategy = std::make_unique<Fixed>(RobotVelocity{0.2, Angle{}}, 1000, nav::Status::finished);
  const Fixed& watched = *strategy;
  robot.navigate(std::move(strategy));
  std::vector<Record> records;
  run(robot, 0.0, 6.0, records);
  EXPECT_EQ(robot.control()->state().mode, Mode::navigate);
  EXPECT_EQ(mode_name(robot.control()->state()), "fixed");
  EXPECT_EQ(robot.control()->state().detail, "going");
  EXPECT_GT(watched.seen_points, 20U);
  EXPECT_GT(watched.map_version, 2U);
  EXPECT_NEAR(robot.T_world_true()->position.x, 2.1, 0.2);
}

TEST(Navigator, WallAheadStopsWhateverTheStrategyWants) {
  LiveRobot robot = navigated();
  robot.navigate(std::make_unique<Fixed>(RobotVelocity{0.5, Angle{}}, 10'000, nav::Status::finished));
  std::vector<Record> records;
  run(robot, 0.0, 30.0, records);
  EXPECT_GT(robot.T_world_true()->position.x, 5.0);
  EXPECT_LT(robot.T_world_true()->position.x, 5.8 - 0.05);  // the hull stands before the wall
  EXPECT_EQ(robot.velocity().forward_m_s, 0.0);
}

TEST(Navigator, EndOfTheStrategyIsToldWithItsReason) {
  for (const auto& [status, reason] :
       {std::pair{nav::Status::finished, Reason::finished}, std::pair{nav::Status::failed, Reason::failed}}) {
    LiveRobot robot = navigated();
    robot.navigate(std::make_unique<Fixed>(RobotVelocity{0.2, Angle{}}, 10, status));
    std::vector<Record> records;
    run(robot, 0.0, 4.0, records);
    const ControlState& state = robot.control()->state();
    EXPECT_EQ(state.mode, Mode::stand);
    EXPECT_EQ(state.reason, reason);
    EXPECT_EQ(state.strategy, "fixed");
    EXPECT_EQ(state.detail, "it is over");
    EXPECT_EQ(robot.velocity().forward_m_s, 0.0);
  }
}

TEST(Navigator, FollowedWallIsNotedInTheLogOnceAndEndsWithTheMode) {
  LiveRobot robot = navigated();
  robot.navigate(std::make_unique<Fixed>(RobotVelocity{0.1, Angle{}}, 10, nav::Status::finished));
  std::vector<Record> records;
  run(robot, 0.0, 3.0, records);
  std::vector<WallSide> sides;
  for (const Record& record : records)
    if (const auto* note = std::get_if<WallNote>(&record)) sides.push_back(note->side);
  EXPECT_EQ(sides, (std::vector{WallSide::left, WallSide::unknown}));
}

TEST(Navigator, MapsWhileNobodyNavigates) {
  LiveRobot robot = navigated();
  std::vector<Record> records;
  run(robot, 0.0, 3.0, records);
  const std::uint64_t version = robot.navigator()->map().version();
  EXPECT_GT(version, 2U);
  run(robot, 3.0, 6.0, records);
  EXPECT_GT(robot.navigator()->map().version(), version);
}

TEST(Navigator, StopAndDriverTakeOver) {
  LiveRobot robot = navigated();
  std::vector<Record> records;
  robot.navigate(std::make_unique<Fixed>(RobotVelocity{0.2, Angle{}}, 1000, nav::Status::finished));
  run(robot, 0.0, 1.0, records);
  robot.control()->stop();
  run(robot, 1.0, 2.0, records);
  EXPECT_EQ(robot.control()->state().reason, Reason::stopped);
  EXPECT_EQ(robot.velocity().forward_m_s, 0.0);
  robot.navigate(std::make_unique<Fixed>(RobotVelocity{0.2, Angle{}}, 1000, nav::Status::finished));
  run(robot, 2.0, 3.0, records);
  robot.control()->drive({-0.1, Angle{}}, 3.0);
  run(robot, 3.0, 3.2, records);
  EXPECT_EQ(robot.control()->state().mode, Mode::drive);
}

TEST(Navigator, WishThatIsNoNumberIsAHalt) {
  LiveRobot robot = navigated();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  robot.navigate(std::make_unique<Fixed>(RobotVelocity{nan, radians(nan)}, 1000, nav::Status::finished));
  std::vector<Record> records;
  run(robot, 0.0, 1.0, records);
  EXPECT_EQ(robot.T_world_true()->position, (Vec2{1.0, 2.0}));
}

TEST(Navigator, EveryMethodGivesSurroundings) {
  for (const MethodEntry& entry : catalog()) {
    LiveRobot robot = navigated({.method = std::string(entry.name), .map = PlanningMap::points});
    auto strategy = std::make_unique<Fixed>(RobotVelocity{0.1, Angle{}}, 1000, nav::Status::finished);
    const Fixed& watched = *strategy;
    robot.navigate(std::move(strategy));
    std::vector<Record> records;
    run(robot, 0.0, 4.0, records);
    EXPECT_GT(watched.map_version, 0U) << entry.name;
    // Some have nothing to show of four seconds: certainty, company or crossings are what they ask for.
    const bool patient =
        entry.name == "bu" || entry.name == "mp" || entry.name == "atm_mod" || entry.name == "consensus_evidence";
    EXPECT_TRUE(patient || watched.seen_points > 0U) << entry.name;
  }
}

TEST(Navigator, UnknownMethodIsRefused) {
  const auto source = SimulatedSource::make(plain_room(), 1).value();
  const auto refused = Navigator::make(source->description(), {.method = "no_such"});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("method"), std::string::npos);
}

TEST(NavigationGrid, GrowsWithoutForgettingAndKeepsItsCellsInPlace) {
  EvidenceGridOptions options;
  options.cell_m = 0.1;
  EvidenceGrid evidence(options);
  Reading reading;
  reading.outcome = Echo{1.55};
  InlineExecutor executor;
  for (int k = 0; k < 20; ++k) evidence.insert({&reading, 1}, executor);
  NavigationGrid grid(0.1);
  const Box near{{-0.5, -0.5}, {2.0, 0.5}};
  ASSERT_TRUE(grid.cover(near));
  grid.take(evidence, near);
  const auto state = [&](Vec2 place) { return grid.cells().at(grid.cells().geometry().cell_of(place)); };
  EXPECT_EQ(state({1.55, 0.05}), CellState::occupied);
  EXPECT_EQ(state({0.55, 0.05}), CellState::free);
  EXPECT_EQ(state({1.95, 0.05}), CellState::unknown);
  const std::uint64_t version = grid.version();
  grid.take(evidence, near);
  EXPECT_EQ(grid.version(), version) << "nothing changed";
  ASSERT_TRUE(grid.cover({{-40.0, -3.0}, {30.0, 60.0}}));
  EXPECT_EQ(state({1.55, 0.05}), CellState::occupied);
  EXPECT_EQ(state({0.55, 0.05}), CellState::free);
  EXPECT_GT(grid.version(), version);
  const double offset = grid.cells().geometry().origin.x / 0.1;
  EXPECT_NEAR(offset, std::round(offset), 1e-6);
}

TEST(NavigationGrid, RefusesWhatIsOutOfAllProportion) {
  NavigationGrid grid(0.1);
  EXPECT_FALSE(grid.cover({{0.0, 0.0}, {1e6, 1e6}}));
  EXPECT_FALSE(grid.cover({{0.0, 0.0}, {std::nan(""), 1.0}}));
  EXPECT_TRUE(grid.cells().empty());
}

TEST(NavigationGrid, PointsAreOccupiedAndTheRestUnknown) {
  NavigationGrid grid(0.1);
  const std::vector<Vec2> points{{0.05, 0.05}, {25.0, -3.0}};
  grid.take(points);
  for (const Vec2 point : points)
    EXPECT_EQ(grid.cells().at(grid.cells().geometry().cell_of(point)), CellState::occupied);
  EXPECT_EQ(std::ranges::count(grid.cells().values(), CellState::occupied), 2);
  EXPECT_EQ(std::ranges::count(grid.cells().values(), CellState::free), 0);
}

}  // namespace
}  // namespace echoarc::live
