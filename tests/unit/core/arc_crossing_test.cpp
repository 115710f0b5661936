// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc_crossing.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace echoarc {
namespace {

constexpr double printed_m = 5e-9;
constexpr double printed_deg = 1e-7;

void expect_crossing(const ArcCrossing& found, Vec2 position, double bearing_a, double bearing_b, double angle_deg,
                     const Arc& a, const Arc& b) {
  EXPECT_NEAR(found.position.x, position.x, printed_m);
  EXPECT_NEAR(found.position.y, position.y, printed_m);
  EXPECT_NEAR(wrap(a.axis() + found.t_a).deg(), bearing_a, printed_deg);
  EXPECT_NEAR(wrap(b.axis() + found.t_b).deg(), bearing_b, printed_deg);
  EXPECT_NEAR(found.angle.deg(), angle_deg, printed_deg);
}

TEST(ArcCrossing, V310CirclesOfTheExample) {
  const Angle beam = degrees(22.5);
  const Arc a = Arc::circular({0, 0}, degrees(90.0), 2.0, beam);
  const Arc b = Arc::circular({0.95, 0}, degrees(112.5), 2.1, beam);
  const Arc c = Arc::circular({0.0897, 0}, degrees(90.0), 2.0, beam);
  ASSERT_EQ(crossings(a, b).size(), 1U);
  expect_crossing(crossings(a, b)[0], {0.25921053, 1.98313134}, 82.5532174, 109.2048975, 26.6516801, a, b);
  ASSERT_EQ(crossings(a, c).size(), 1U);
  EXPECT_NEAR(crossings(a, c)[0].position.x, 0.04485, printed_m);
  EXPECT_NEAR(crossings(a, c)[0].position.y, 1.99949706, printed_m);
  EXPECT_NEAR(crossings(a, c)[0].angle.deg(), 2.5699311, printed_deg);
}

TEST(ArcCrossing, V310TwoPoints) {
  const Arc a = Arc::circular({0, 0}, degrees(90.0), 1.0, degrees(60.0));
  const Arc b = Arc::circular({0, 0.5}, degrees(90.0), 0.55, degrees(120.0));
  const ArcCrossings found = crossings(a, b);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].position.x, -0.31975577, printed_m);
  EXPECT_NEAR(found[0].position.y, 0.9475, printed_m);
  EXPECT_NEAR((a.axis() + found[0].t_a).deg(), 108.6481553, printed_deg);
  EXPECT_NEAR((a.axis() + found[1].t_a).deg(), 71.3518447, printed_deg);
  for (const ArcCrossing& crossing : found) EXPECT_NEAR(crossing.angle.deg(), 16.8990938, printed_deg);
}

TEST(ArcCrossing, V310AcrossTheCutOfTheAngles) {
  const Arc a = Arc::circular({0, 0}, degrees(180.0), 2.0, degrees(22.5));
  const Arc b = Arc::circular({0, 0.8}, degrees(-157.5), 2.19, degrees(22.5));
  ASSERT_EQ(crossings(a, b).size(), 1U);
  expect_crossing(crossings(a, b)[0], {-1.99761897, -0.09756250}, -177.2039306, -155.8048457, 21.3990848, a, b);
}

Arc upper_half(Vec2 tx, Vec2 rx, double path_m) {
  return *Arc::elliptical({tx, degrees(90.0)}, {rx, degrees(90.0)}, path_m / 2, degrees(178.0));
}

TEST(ArcCrossing, V311EllipseWithCircleAndEllipse) {
  const Arc ellipse = upper_half({0, 0}, {0.09, 0}, 2.0);
  const Arc circle = Arc::circular({1, 0}, degrees(135.0), 1.05, degrees(30.0));
  for (const bool ellipse_first : {true, false}) {
    const ArcCrossings found = ellipse_first ? crossings(ellipse, circle) : crossings(circle, ellipse);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].position.x, 0.46796454, printed_m);
    EXPECT_NEAR(found[0].position.y, 0.90522830, printed_m);
    EXPECT_NEAR((circle.axis() + (ellipse_first ? found[0].t_b : found[0].t_a)).deg(), 120.4442965, printed_deg);
    EXPECT_NEAR((ellipse.axis() + (ellipse_first ? found[0].t_a : found[0].t_b)).deg(), 64.9558428, printed_deg);
    EXPECT_NEAR(found[0].angle.deg(), 55.4439403, printed_deg);
  }
  const Arc other = upper_half({0.8, 0}, {0.89, 0}, 2.1);
  const ArcCrossings found = crossings(ellipse, other);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR((other.axis() + found[0].t_b).deg(), 116.2565295, printed_deg);
  EXPECT_NEAR(found[0].position.x, 0.38083291, printed_m);
  EXPECT_NEAR(found[0].position.y, 0.94096740, printed_m);
  EXPECT_NEAR(found[0].angle.deg(), 45.8195947, printed_deg);
}

TEST(ArcCrossing, CurvesThatCoincideOrShareTheCentreDoNotCross) {
  const Arc circle = Arc::circular({3, 4}, degrees(10.0), 2.0, degrees(30.0));
  EXPECT_TRUE(crossings(circle, circle).empty());
  EXPECT_TRUE(crossings(circle, Arc::circular({3, 4}, degrees(20.0), 2.0, degrees(30.0))).empty());
  EXPECT_TRUE(crossings(circle, Arc::circular({3, 4}, degrees(20.0), 2.1, degrees(30.0))).empty());
  const Pose2 tx{{3, 4}, degrees(10.0)};
  const Pose2 rx{{3.2, 4.1}, degrees(30.0)};
  const Arc ellipse = *Arc::elliptical(tx, rx, 2.0, degrees(30.0));
  EXPECT_TRUE(crossings(ellipse, ellipse).empty());
  EXPECT_TRUE(crossings(ellipse, *Arc::elliptical(rx, tx, 2.0, degrees(30.0))).empty()) << "foci exchanged";
  EXPECT_TRUE(crossings(ellipse, *Arc::elliptical(tx, rx, 2.1, degrees(30.0))).empty()) << "confocal";
}

TEST(ArcCrossing, CurvesThatTouchDoNotCross) {
  const Arc a = Arc::circular({0, 0}, degrees(0.0), 1.0, degrees(40.0));
  EXPECT_TRUE(crossings(a, Arc::circular({3, 0}, degrees(180.0), 2.0, degrees(40.0))).empty());
  EXPECT_TRUE(crossings(a, Arc::circular({0.5, 0}, degrees(0.0), 0.5, degrees(40.0))).empty());
  // An ellipse of semi-major axis 1 along x and the circle of radius 2 that touches its vertex from outside.
  const Arc ellipse = *Arc::elliptical({{-0.3, 0}, degrees(0.0)}, {{0.3, 0}, degrees(0.0)}, 1.0, degrees(40.0));
  EXPECT_TRUE(crossings(ellipse, Arc::circular({3, 0}, degrees(180.0), 2.0, degrees(40.0))).empty());
  EXPECT_EQ(crossings(ellipse, Arc::circular({2.99, 0}, degrees(180.0), 2.0, degrees(40.0))).size(), 2U);
}

TEST(ArcCrossing, TheEndsBelongToTheArcs) {
  // Both arcs end in (0, 1): axis 12.5 degrees off on either side.
  const Arc a = Arc::circular({0, 0}, degrees(77.5), 1.0, degrees(25.0));
  const Arc b = Arc::circular({1, 1}, degrees(180.0 - 12.5), 1.0, degrees(25.0));
  EXPECT_EQ(crossings(a, b).size(), 1U);
  const Pose2 tx{{-0.25, 0}, degrees(77.5)};
  const Pose2 rx{{0.25, 0}, degrees(77.5)};
  const Arc ellipse = *Arc::elliptical(tx, rx, std::hypot(1.0, 0.25), degrees(25.0));
  EXPECT_EQ(crossings(ellipse, b).size(), 1U);
  EXPECT_EQ(crossings(b, ellipse).size(), 1U);
}

TEST(ArcCrossing, FourPointsOfTwoWideEllipses) {
  // Long flat ellipses across each other; each arc spans 350 degrees.
  const auto wide = [](Vec2 half_foci) {
    Arc arc = *Arc::elliptical({-half_foci, degrees(20.0)}, {half_foci, degrees(20.0)}, 1.0, degrees(170.0));
    arc.set_limits(degrees(-175.0), degrees(175.0));
    return arc;
  };
  const ArcCrossings found = crossings(wide({0.9, 0.0}), wide({0.0, 0.9}));
  ASSERT_EQ(found.size(), 4U);
  for (const ArcCrossing& crossing : found) {
    EXPECT_NEAR(std::abs(crossing.position.x), std::abs(crossing.position.y), 1e-14);
    EXPECT_NEAR(std::abs(crossing.position.x), 0.3995, 1e-3);
  }
}

TEST(ArcCrossing, NumbersWithoutSenseGiveNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Arc plain = Arc::circular({0, 0}, degrees(0.0), 1.0, degrees(40.0));
  const Arc ellipse = *Arc::elliptical({{0, 0}, degrees(0.0)}, {{0.1, 0}, degrees(0.0)}, 1.0, degrees(40.0));
  for (const Vec2 place : {Vec2{nan, 0}, Vec2{1e300, 0}, Vec2{-1e300, 1e300}})
    for (const double range_m : {1e-300, 1.0, 1e200, 1e300}) {
      const Arc strange = Arc::circular(place, degrees(180.0), range_m, degrees(40.0));
      EXPECT_TRUE(crossings(plain, strange).empty());
      EXPECT_TRUE(crossings(ellipse, strange).empty());
      EXPECT_TRUE(crossings(strange, ellipse).empty());
    }
}

TEST(ArcCrossing, HugeAndTinyArcsCrossWhereTheyDo) {
  const Arc huge = Arc::circular({-1e6, 0}, degrees(0.0), 1e6 + 1.0, degrees(25.0));
  const Arc tiny = Arc::circular({1.0, -1e-3}, degrees(90.0), 1e-3, degrees(25.0));
  ASSERT_EQ(crossings(huge, tiny).size(), 1U);
  EXPECT_NEAR(norm(crossings(huge, tiny)[0].position - Vec2{1.0, 0.0}), 0.0, 1e-9);
}

}  // namespace
}  // namespace echoarc
