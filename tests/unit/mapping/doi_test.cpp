// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "mapping/doi/providers.hpp"
#include "mapping/doi/sort_by_key.hpp"
#include "mapping/doi/survivors.hpp"
#include "support/v53_scene.hpp"

namespace echoarc::doi {
namespace {

// V3.2 of the method specification.
TEST(Spread, WorkedNumbers) {
  const WeightedPoint points[] = {{{0, 0}}, {{1, 0.1}}, {{2, -0.1}}, {{3, 0.2}}, {{4, 0}}};
  const Spread spread = spread_of(points);
  EXPECT_NEAR(spread.smaller, 0.01019897, 5e-9);
  EXPECT_NEAR(spread.larger, 2.00020103, 5e-9);
  EXPECT_NEAR(wrap(2.0 * (spread.across - degrees(90.575875))).deg(), 0.0, 1e-6) << "modulo 180 degrees";
  EXPECT_EQ(spread.weight, 5.0);
}

TEST(Spread, WeightsCountAsRepetitions) {
  const WeightedPoint weighted[] = {{{0, 0}, 3.0}, {{2, 1}, 1.0}, {{4, 0}, 2.0}};
  const WeightedPoint repeated[] = {{{0, 0}}, {{0, 0}}, {{0, 0}}, {{2, 1}}, {{4, 0}}, {{4, 0}}};
  EXPECT_NEAR(spread_of(weighted).larger, spread_of(repeated).larger, 1e-12);
  EXPECT_NEAR(spread_of(weighted).smaller, spread_of(repeated).smaller, 1e-12);
  EXPECT_NEAR(spread_of(weighted).across.rad(), spread_of(repeated).across.rad(), 1e-12);
}

TEST(SortByKey, IsASortWhetherKeysAreCloseOrFarApart) {
  for (const std::int32_t apart : {1, 1'000'000}) {
    std::vector<Cell> cells;
    for (std::int32_t k = 0; k < 200; ++k) cells.push_back({k * 7919 % 31, (k * 104729 % 41 - 20) * apart});
    std::vector<Cell> sorted = cells;
    std::ranges::sort(sorted, [](Cell a, Cell b) { return a < b; });
    sort_by_key(cells, [](Cell c) { return std::int64_t(c.j); }, [](Cell a, Cell b) { return a.i < b.i; });
    EXPECT_EQ(cells, sorted);
  }
}

using Lines = std::map<std::uint64_t, std::vector<Cell>>;

LineVisitor into(Lines& lines) {
  return [&lines](std::uint64_t line, std::span<const LineCell> cells) {
    for (const LineCell& c : cells) lines[line].push_back(c.cell);
  };
}

std::vector<LineCell> block(std::int32_t width, std::int32_t height) {
  std::vector<LineCell> cells;
  for (std::int32_t j = 0; j < height; ++j)
    for (std::int32_t i = 0; i < width; ++i) cells.push_back({{i, j}, 1});
  return cells;
}

TEST(AxisLines, ColumnsUpAndDownAndRows) {
  Lines up;
  axis_lines(block(3, 2), {0.5, 0.5}, unit(degrees(90.0)), into(up));
  EXPECT_EQ(up, (Lines{{0, {{0, 0}, {0, 1}}}, {1, {{1, 0}, {1, 1}}}, {2, {{2, 0}, {2, 1}}}}));
  Lines down;
  axis_lines(block(1, 3), {0.5, 0.5}, unit(degrees(-90.0)), into(down));
  EXPECT_EQ(down, (Lines{{0, {{0, 2}, {0, 1}, {0, 0}}}}));
  Lines right;
  axis_lines(block(2, 1), {0.5, 0.5}, unit(degrees(0.0)), into(right));
  EXPECT_EQ(right, (Lines{{0, {{0, 0}, {1, 0}}}}));
}

TEST(AxisLines, ObliqueLinesHoldEveryCellOnce) {
  Lines lines;
  axis_lines(block(20, 20), {0.5, 0.5}, unit(degrees(33.0)), into(lines));
  std::size_t cells = 0;
  for (const auto& [line, on_line] : lines) {
    cells += on_line.size();
    for (std::size_t k = 1; k < on_line.size(); ++k) {
      const Vec2 step{double(on_line[k].i - on_line[k - 1].i), double(on_line[k].j - on_line[k - 1].j)};
      EXPECT_GT(dot(step, unit(degrees(33.0))), 0.0) << "ordered outward";
      EXPECT_LE(std::abs(dot(step, unit(degrees(123.0)))), 1.0) << "one cell wide";
    }
  }
  EXPECT_EQ(cells, 400U);
}

/// Stops whose nearest echo is left (L), right (R) or missing (-); lower case: the log names the side.
std::vector<DoiHistory::Stop> stops(std::string_view pattern) {
  std::vector<DoiHistory::Stop> stops;
  for (const char c : pattern) {
    DoiHistory::Stop stop{.scan = std::uint32_t(stops.size())};
    if (c == 'L') stop.nearest_left_m = 1.0;
    if (c == 'R') stop.nearest_right_m = 1.0;
    if (c == 'l') stop.wall = WallSide::left;
    if (c == 'r') stop.wall = WallSide::right;
    stops.push_back(stop);
  }
  return stops;
}

std::string sides(std::string_view pattern) {
  std::string text;
  for (const WallSide side : followed_sides(stops(pattern), 3))
    text += side == WallSide::left ? 'L' : side == WallSide::right ? 'R' : '?';
  return text;
}

TEST(FollowedSides, ChangeAfterThreeStopsInARow) {
  EXPECT_EQ(sides("LLRRLRRRL"), "LLLLLLLRR");
  EXPECT_EQ(sides("-LL-R-R-RR"), "?LLLLLLLRR") << "stops without an echo say nothing";
  EXPECT_EQ(sides("--"), "??");
}

TEST(FollowedSides, TheLogHasTheLastWord) {
  EXPECT_EQ(sides("LLrLLL"), "LLRRRL");
  EXPECT_EQ(sides("rL"), "RR");
}

Reading reading_at(Pose2 T_world_robot, Angle yaw, std::uint32_t scan) {
  Reading reading = test::monostatic_reading(T_world_robot, Echo{1.0});
  reading.T_world_tx.heading = reading.T_world_rx.heading = T_world_robot.heading + yaw;
  reading.scan = scan;
  reading.range_max_m = 4.0;
  return reading;
}

DoiHistory history_of(const std::vector<Reading>& readings) {
  DoiHistory history(true, true, 0.01);
  for (const Reading& reading : readings) history.add(reading, *arc_of(reading));
  return history;
}

TEST(DoiHistory, KeepsTheNearestEchoOfEachSide) {
  std::vector<Reading> readings{reading_at({}, degrees(90.0), 0), reading_at({}, degrees(-90.0), 0),
                                reading_at({}, degrees(0.0), 0), reading_at({}, degrees(100.0), 0)};
  readings[1].outcome = Echo{0.8};
  readings[2].outcome = Echo{0.2};  // looks ahead: on no side
  readings[3].outcome = Echo{0.7};
  const DoiHistory history = history_of(readings);
  ASSERT_EQ(history.stops().size(), 1U);
  EXPECT_EQ(history.stops()[0].nearest_left_m, 0.7);
  EXPECT_EQ(history.stops()[0].nearest_right_m, 0.8);
  EXPECT_EQ(history.path().size(), 1U);
  EXPECT_EQ(history.sights().size(), 4U);
  EXPECT_FALSE(history.has_wall_labels());
}

/// Counts of 1 in every cell of a square of 2 m around the origin.
VoteGrid::Counts full_square() {
  VoteGrid::Counts counts({.cell_m = 0.05, .origin = {}}, 1 << 24);
  EXPECT_TRUE(counts.ensure_cells({-64, -64, 64, 64}));
  for (std::int32_t j = -20; j < 20; ++j)
    for (std::int32_t i = -20; i < 20; ++i) counts.at({i, j}) = 1;
  return counts;
}

struct PathCase {
  const char* name;
  Angle heading;  ///< of the robot, which moves along +x
  WallSide side;
  double y_sign;  ///< where the cells of the lines must lie; 0: on both sides
};

TEST(PathLines, LeaveThePathOnTheFollowedSide) {
  const PathCase cases[] = {{"left of a robot driving forward", degrees(0.0), WallSide::left, 1.0},
                            {"right of a robot driving forward", degrees(0.0), WallSide::right, -1.0},
                            {"left of a robot driving backwards", degrees(180.0), WallSide::left, -1.0},
                            {"side not known", degrees(0.0), WallSide::unknown, 0.0}};
  const VoteGrid::Counts counts = full_square();
  for (const PathCase& c : cases) {
    std::vector<Reading> readings;
    for (int k = 0; k < 5; ++k)
      readings.push_back(reading_at({{-0.52 + 0.2 * k, 0.013}, c.heading}, degrees(90.0), std::uint32_t(k)));
    const DoiHistory history = history_of(readings);
    const std::vector<WallSide> sides(history.stops().size(), c.side);
    RayLines rays(counts, 1);
    int above = 0;
    int below = 0;
    path_lines(rays, history, sides, true, 0.05, 0.10, [&](std::uint64_t, std::span<const LineCell> line) {
      ASSERT_FALSE(line.empty());
      (line.back().cell.j > 0 ? above : below) += 1;
      for (const LineCell& on_line : line) EXPECT_EQ(on_line.cell.i, line.front().cell.i) << c.name;
    });
    EXPECT_EQ(above, c.y_sign >= 0.0 ? 17 : 0) << c.name;
    EXPECT_EQ(below, c.y_sign <= 0.0 ? 17 : 0) << c.name;
  }
}

TEST(PathLines, ARobotThatStandsHasNoPath) {
  const VoteGrid::Counts counts = full_square();
  RayLines rays(counts, 1);
  const DoiHistory standing = history_of({reading_at({}, degrees(90.0), 0), reading_at({}, degrees(90.0), 1)});
  const DoiHistory empty = history_of({});
  const auto refuse = [](std::uint64_t, std::span<const LineCell>) { FAIL(); };
  path_lines(rays, standing, named_sides(standing.stops()), true, 0.05, 0.1, refuse);
  path_lines(rays, empty, {}, true, 0.05, 0.1, refuse);
  EXPECT_EQ(vantage_points(standing.path(), 1.0).size(), 1U);
  EXPECT_TRUE(vantage_points(empty.path(), 1.0).empty());
}

TEST(SightLines, FollowTheAxisToTheSensorsLimit) {
  const VoteGrid::Counts counts = full_square();
  RayLines rays(counts, 1);
  const DoiHistory::Sight sight{{-0.62, 0.02}, {1.0, 0.0}, 0.5, 1.0};
  Lines lines;
  sight_lines(rays, std::span(&sight, 1), into(lines));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front(), (Cell{-13, 0}));
  EXPECT_EQ(lines[0].back(), (Cell{7, 0}));
  EXPECT_EQ(lines[0].size(), 21U);
}

TEST(PolarLines, SeeEveryCellAround) {
  const VoteGrid::Counts counts = full_square();
  RayLines rays(counts, 1);
  CellSet seen;
  std::uint64_t last = 0;
  polar_lines(rays, {0.013, 0.017}, degrees(0.5), 4.0, [&](std::uint64_t line, std::span<const LineCell> cells) {
    last = line;
    for (const LineCell& c : cells) seen.insert(c.cell);
  });
  EXPECT_EQ(last, 719U);
  EXPECT_EQ(seen.size(), 1600U);
}

TEST(VantagePoints, LieOnThePathAtTheirSpacing) {
  std::vector<Reading> readings;
  for (int k = 0; k <= 5; ++k) readings.push_back(reading_at({{0.5 * k, 0.0}, {}}, degrees(90.0), std::uint32_t(k)));
  const std::vector<Vec2> points = vantage_points(history_of(readings).path(), 1.0);
  EXPECT_EQ(points, (std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}}));
}

TEST(Supported, NeedsASecondViewWithinReach) {
  const std::vector<Cell> views[] = {{{0, 0}, {10, 0}, {20, 0}}, {{2, -2}, {13, 0}, {30, 0}}, {{20, 0}}};
  EXPECT_EQ(supported(views, 2), (std::vector<Cell>{{2, -2}, {0, 0}, {20, 0}}));
  EXPECT_TRUE(supported(std::span(views).first(1), 2).empty());
}

TEST(WindowLines, RunAcrossAWallAndAwayFromTheSensors) {
  std::vector<LineCell> wall;
  for (std::int32_t i = 0; i < 60; ++i)
    for (std::int32_t j = 20; j < 23; ++j) wall.push_back({{i, j}, 5});
  const GridGeometry geometry{.cell_m = 0.01, .origin = {}};
  const DoiHistory::Sight above[] = {{{0.3, 1.2}, {0.0, -1.0}, 1.0, 4.0}};
  Lines lines;
  const CellSet covered = window_lines(wall, geometry, above, {60, 30, 0.5, 20.0}, into(lines));
  EXPECT_EQ(covered.size(), wall.size());
  for (const auto& [line, cells] : lines) {
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells[0].j, 22) << "from the sensors, which are above";
    EXPECT_EQ(cells[2].j, 20);
    EXPECT_EQ(cells[0].i, cells[2].i) << "whole columns";
  }
}

TEST(WindowLines, RefuseRoundAndThinWindows) {
  const GridGeometry geometry{.cell_m = 0.01, .origin = {}};
  const std::vector<LineCell> round = block(30, 30);
  const auto refuse = [](std::uint64_t, std::span<const LineCell>) { FAIL(); };
  EXPECT_TRUE(window_lines(round, geometry, {}, {60, 60, 0.5, 20.0}, refuse).empty());
  const std::vector<LineCell> thin = block(19, 1);
  EXPECT_TRUE(window_lines(thin, geometry, {}, {60, 60, 0.5, 20.0}, refuse).empty());
}

}  // namespace
}  // namespace echoarc::doi
