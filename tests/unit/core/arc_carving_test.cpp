// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc_carving.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

constexpr Angle beam = degrees(22.5);

struct Left {
  CarveOutcome outcome = CarveOutcome::unchanged;
  double begin_deg = 0.0;  ///< bearings, world
  double end_deg = 0.0;
  Vec2 point;
  double bound_m = 0.0;
};

Left left_of(const Arc& older, const Arc& newer, double guard_m = 0.0) {
  const Carving carving = carve(older, FreeSector(newer, guard_m));
  Arc arc = older;
  arc.set_limits(carving.t_begin, carving.t_end);
  return {carving.outcome, (older.axis() + carving.t_begin).deg(), (older.axis() + carving.t_end).deg(),
          arc.point_at(0.5 * (carving.t_begin + carving.t_end)), max_error_m(arc)};
}

void expect_carved(const Left& left, double begin_deg, double end_deg, Vec2 point) {
  EXPECT_EQ(left.outcome, CarveOutcome::carved);
  EXPECT_NEAR(left.begin_deg, begin_deg, 5e-5);
  EXPECT_NEAR(left.end_deg, end_deg, 5e-5);
  EXPECT_NEAR(left.point.x, point.x, 5e-6);
  EXPECT_NEAR(left.point.y, point.y, 5e-6);
}

// V3.18 of the method specification.
TEST(ArcCarving, ErrorBound) {
  const auto bound_m = [](double range_m, Angle width) { return max_error_m(Arc::circular({}, {}, range_m, width)); };
  EXPECT_NEAR(bound_m(1.0, beam), 0.196034, 5e-7);
  EXPECT_NEAR(bound_m(2.54, beam), 0.497927, 5e-7);
  EXPECT_NEAR(bound_m(2.54, degrees(10.0)), 0.221586, 5e-7);
  EXPECT_NEAR(bound_m(3.0, degrees(4.0)), 0.104714, 5e-7);
}

// V3.19: the older arc stands at (0, 0), looks up, r = 2 m.
class CarvingTable : public testing::Test {
 protected:
  Arc older_ = Arc::circular({0, 0}, degrees(90.0), 2.0, beam);
  static Arc newer(Vec2 sensor, double range_m, double axis_deg = 90.0, Angle width = beam) {
    return Arc::circular(sensor, degrees(axis_deg), range_m, width);
  }
};

TEST_F(CarvingTable, C1FrontOfTheNewerReadingCuts) {
  const Left left = left_of(older_, newer({0.2, 0}, 2.0));
  expect_carved(left, 87.1340, 101.25, {-0.14620, 1.99465});
  EXPECT_NEAR(left.end_deg - left.begin_deg, 14.1160, 5e-5);
  EXPECT_NEAR(left.bound_m, 0.24621, 5e-6);
}

TEST_F(CarvingTable, C1bGuardKeepsMore) {
  expect_carved(left_of(older_, newer({0.2, 0}, 2.0), 0.0127), 83.4945, 101.25, {-0.08278, 1.99829});
}

TEST_F(CarvingTable, C2IdenticalReadingsLeaveEachOtherWhole) {
  EXPECT_EQ(left_of(older_, older_).outcome, CarveOutcome::unchanged);
}

TEST_F(CarvingTable, C3CoveredArcsAreRemoved) {
  EXPECT_EQ(left_of(older_, newer({0, -0.001}, 3.0, 90.0, degrees(24.0))).outcome, CarveOutcome::removed_full);
  EXPECT_EQ(left_of(older_, newer({0, 0}, 2.5)).outcome, CarveOutcome::removed_full) << "only end points survive";
}

TEST_F(CarvingTable, C4CloserSensorSplits) {
  EXPECT_EQ(left_of(older_, newer({0, 1.5}, 0.8)).outcome, CarveOutcome::removed_split);
}

TEST_F(CarvingTable, C5EdgeOfTheBeamCuts) {
  const Left left = left_of(older_, newer({0.5, 0}, 3.0, 112.5));
  expect_carved(left, 78.75, 87.0566, {0.24709, 1.98468});
  EXPECT_NEAR(left.bound_m, 0.14495, 5e-6);
}

TEST_F(CarvingTable, C6ShorterReadingDoesNotReach) {
  EXPECT_EQ(left_of(older_, newer({0.2, 0}, 1.5)).outcome, CarveOutcome::unchanged);
}

TEST_F(CarvingTable, C7AcrossTheSeamOfAngles) {
  const Arc older = Arc::circular({0, 0}, degrees(180.0), 2.0, beam);
  expect_carved(left_of(older, newer({0, 0.2}, 2.0, 180.0)), 177.1340, 191.25, {-1.99465, -0.14620});
  const Arc other_name = Arc::circular({0, 0}, degrees(-180.0), 2.0, beam);
  expect_carved(left_of(other_name, newer({0, 0.2}, 2.0, 180.0)), -182.8660, -168.75, {-1.99465, -0.14620});
}

TEST_F(CarvingTable, C8NeighbouringBeamsOnlyTouch) {
  EXPECT_EQ(left_of(older_, newer({0, 0}, 3.0, 112.5)).outcome, CarveOutcome::unchanged);
}

TEST_F(CarvingTable, C9OverlappingBeamsCarve) {
  const Arc wide = newer({0, 0}, 2.0, 90.0, degrees(25.0));
  expect_carved(left_of(wide, newer({0, 0}, 3.0, 112.5, degrees(25.0))), 77.5, 100.0, {0.04363, 1.99952});
}

TEST_F(CarvingTable, Sequence) {
  Carving carving = carve(older_, FreeSector(newer({0.2, 0}, 2.0)));
  older_.set_limits(carving.t_begin, carving.t_end);
  carving = carve(older_, FreeSector(newer({-0.3, 0}, 2.0)));
  ASSERT_EQ(carving.outcome, CarveOutcome::carved);
  EXPECT_NEAR(carving.t_begin.deg() + 90.0, 87.1340, 5e-5);
  EXPECT_NEAR(carving.t_end.deg() + 90.0, 94.3012, 5e-5);
  older_.set_limits(carving.t_begin, carving.t_end);
  EXPECT_EQ(carve(older_, FreeSector(newer({0.05, 0}, 2.2))).outcome, CarveOutcome::removed_full);
}

// V3.20: a specular wall at D = r = 2 m, twelve parallel sensors 0.1 m apart.
TEST(ArcCarving, StopsAlongASpecularWall) {
  std::vector<Arc> arcs;
  for (int k = 0; k < 12; ++k) {
    arcs.push_back(Arc::circular({0.1 * k, 0}, degrees(90.0), 2.0, beam));
    for (std::size_t i = 0; i + 1 < arcs.size(); ++i) {
      const Carving carving = carve(arcs[i], FreeSector(arcs.back()));
      ASSERT_LE(carving.outcome, CarveOutcome::carved);
      arcs[i].set_limits(carving.t_begin, carving.t_end);
    }
  }
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i) {
    EXPECT_NEAR(arcs[i].t_begin().deg(), -1.433, 5e-4) << i;
    EXPECT_EQ(arcs[i].t_end(), degrees(11.25)) << i;
  }
  EXPECT_EQ(arcs.back().t_begin(), degrees(-11.25));
}

// No carving between parallel sensors at a specular wall once sqrt(2 D g) / D exceeds sin(phi / 2).
TEST(ArcCarving, GuardEndsCarvingOfParallelSensors) {
  const double guard_m = 0.02;
  const double d = 1.0;
  ASSERT_GT(std::sqrt(2.0 * d * guard_m) / d, sin(0.5 * beam));
  const Arc older = Arc::circular({}, degrees(90.0), d, beam);
  for (int mm = 1; mm < 400; ++mm) {
    const FreeSector newer(Arc::circular({0.001 * mm, 0}, degrees(90.0), d, beam), guard_m);
    EXPECT_EQ(carve(older, newer).outcome, CarveOutcome::unchanged) << mm << " mm";
  }
}

TEST(ArcCarving, EllipseWithCoincidentFociIsTheCircle) {
  const Pose2 tx{{0.2, 0}, degrees(90.0)};
  const Pose2 rx{{0.2 + 2e-9, 0}, degrees(90.0)};
  const Arc circle = Arc::circular({0, 0}, degrees(90.0), 2.0, beam);
  const Carving carving = carve(circle, FreeSector(*Arc::elliptical(tx, rx, 2.0, beam)));
  ASSERT_EQ(carving.outcome, CarveOutcome::carved);
  EXPECT_NEAR(carving.t_begin.deg() + 90.0, 87.1340, 5e-5);
}

TEST(ArcCarving, EllipticalReadingsOfOneWallCarveLikeCircles) {
  // Pairs of foci 0.2 m apart, parallel to a wall at 2 m; half paths are those of the specular echo.
  const auto pair_at = [](double x) {
    const double half_path_m = std::hypot(2.0, 0.1);
    return *Arc::elliptical({{x - 0.1, 0}, degrees(90.0)}, {{x + 0.1, 0}, degrees(90.0)}, half_path_m, beam);
  };
  const Arc older = pair_at(0.0);
  EXPECT_EQ(carve(older, FreeSector(older)).outcome, CarveOutcome::unchanged);
  const Carving carving = carve(older, FreeSector(pair_at(0.1)));
  ASSERT_EQ(carving.outcome, CarveOutcome::carved);
  // Equal ellipses a step apart meet above the middle of the step.
  EXPECT_NEAR(older.point_at(carving.t_begin).x, 0.05, 1e-7);
  EXPECT_EQ(carving.t_end, older.t_end());
}

TEST(ArcCarving, StandsHostileGeometry) {
  const Arc older = Arc::circular({}, {}, 2.0, degrees(179.9));
  for (const double range_m : {1e-12, 1e-3, 2.0, 1e6, 1e150})
    for (const double width_deg : {1e-6, 25.0, 179.999})
      for (const Vec2 sensor : {Vec2{}, Vec2{2.0, 0.0}, Vec2{1e6, -1e6}, Vec2{1e-12, 0.0}})
        for (const double guard_m : {0.0, 0.5, 10.0}) {
          const Arc newer = Arc::circular(sensor, degrees(33.0), range_m, degrees(width_deg));
          for (const auto& [a, b] : {std::pair{older, newer}, std::pair{newer, older}}) {
            const Carving carving = carve(a, FreeSector(b, guard_m));
            EXPECT_GE(carving.t_begin, a.t_begin());
            EXPECT_LE(carving.t_end, a.t_end());
            EXPECT_LE(carving.t_begin, carving.t_end);
          }
        }
}

}  // namespace
}  // namespace echoarc
