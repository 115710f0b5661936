// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/pose2.hpp"
#include "echoarc/core/rng.hpp"
#include "echoarc/nav/voronoi_tracer.hpp"

namespace echoarc::nav {
namespace {

TracerOptions unlimited() {
  TracerOptions options;
  options.correction_limit_m_s = 100.0;
  return options;
}

// V7.2
TEST(VoronoiControl, WorkedNumbers) {
  const Vec2 x{0.3, 0.1};
  const TraceControl control = trace_control(x, {0.3, 1.0}, {0.0, -1.2}, {1.0, 0.0}, unlimited());
  EXPECT_NEAR(control.difference_m, -0.434166, 1e-6);
  EXPECT_NEAR(control.gradient.x, -0.224860, 1e-6);
  EXPECT_NEAR(control.gradient.y, -1.974391, 1e-6);
  EXPECT_NEAR(control.tangent.x, 0.993577, 1e-6);
  EXPECT_NEAR(control.tangent.y, -0.113157, 1e-6);
  EXPECT_NEAR(control.correction_m_s.x, -0.024723, 1e-6);
  EXPECT_NEAR(control.correction_m_s.y, -0.217083, 1e-6);
  const Vec2 after = x + control.correction_m_s;
  EXPECT_NEAR(after.x, 0.275277, 1e-6);
  EXPECT_NEAR(after.y, -0.117083, 1e-6);
  EXPECT_NEAR(norm(after - Vec2{0.3, 1.0}) - norm(after - Vec2{0.0, -1.2}), 0.0, 5e-5);
}

TEST(VoronoiControl, GoesOnInTheDirectionOfBefore) {
  const Vec2 x{0.0, 0.0};
  EXPECT_NEAR(trace_control(x, {0, 1}, {0, -1}, {1, 0.2}).tangent.x, 1.0, 1e-12);
  EXPECT_NEAR(trace_control(x, {0, 1}, {0, -1}, {-1, 0.2}).tangent.x, -1.0, 1e-12);
}

TEST(VoronoiControl, CorrectionIsCutToItsLimit) {
  const TraceControl control = trace_control({0, 0}, {0, 3}, {0, -1}, {1, 0});
  EXPECT_NEAR(control.correction_m_s.y, 0.2, 1e-12);  // away from the nearer one
  EXPECT_NEAR(control.correction_m_s.x, 0.0, 1e-12);
}

TEST(VoronoiControl, TwoObstaclesInOneDirectionAreDrivenAlongTheirBisector) {
  const TraceControl control = trace_control({0, 0}, {2, 0.01}, {1, -0.01}, {-1, 0});
  EXPECT_NEAR(control.tangent.x, -1.0, 1e-3);
  EXPECT_EQ(control.correction_m_s, Vec2{});
}

TEST(VoronoiControl, StandingOnAnObstacleGivesFiniteNumbers) {
  const TraceControl control = trace_control({1, 1}, {1, 1}, {2, 1}, {0, 0});
  EXPECT_TRUE(is_finite(control.tangent));
  EXPECT_EQ(control.correction_m_s, Vec2{});
}

RC_GTEST_PROP(VoronoiControlProperty, TangentIsAcrossTheGradientAndCorrectionAlongIt, (std::uint64_t seed)) {
  Rng rng(seed);
  const auto place = [&] { return Vec2{rng.uniform(-3, 3), rng.uniform(-3, 3)}; };
  const Vec2 x = place();
  const Vec2 c1 = place();
  const Vec2 c2 = place();
  const Vec2 before = unit(radians(rng.uniform(-3, 3)));
  const TraceControl control = trace_control(x, c1, c2, before, unlimited());
  RC_PRE(norm(control.gradient) > 0.1 && norm(x - c1) > 0.01 && norm(x - c2) > 0.01);
  RC_ASSERT(std::abs(dot(control.tangent, control.gradient)) < 1e-9);
  RC_ASSERT(std::abs(norm(control.tangent) - 1.0) < 1e-9);
  RC_ASSERT(dot(control.tangent, before) >= 0.0);
  // To first order the correction of one second takes away the whole difference.
  RC_ASSERT(std::abs(dot(control.correction_m_s, control.gradient) + control.difference_m) < 1e-9);
}

RC_GTEST_PROP(VoronoiControlProperty, TurnsAndMovesWithTheWorld, (std::uint64_t seed)) {
  Rng rng(seed);
  const auto place = [&] { return Vec2{rng.uniform(-3, 3), rng.uniform(-3, 3)}; };
  const Pose2 T_b_a{place(), radians(rng.uniform(-3, 3))};
  const Vec2 x = place();
  const Vec2 c1 = place();
  const Vec2 c2 = place();
  const Vec2 before = unit(radians(rng.uniform(-3, 3)));
  const TraceControl in_a = trace_control(x, c1, c2, before);
  RC_PRE(norm(in_a.gradient) > 0.1 && std::abs(dot(in_a.tangent, before)) > 1e-6);
  const TraceControl in_b = trace_control(T_b_a * x, T_b_a * c1, T_b_a * c2, rotate(before, T_b_a.heading));
  RC_ASSERT(norm(rotate(in_a.tangent, T_b_a.heading) - in_b.tangent) < 1e-9);
  RC_ASSERT(norm(rotate(in_a.correction_m_s, T_b_a.heading) - in_b.correction_m_s) < 1e-9);
}

}  // namespace
}  // namespace echoarc::nav
