// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

constexpr Angle half_beam = degrees(12.5);
const Pose2 tx_v17{{0.0, 0.0}, degrees(90.0)};
const Pose2 rx_v17{{0.09, 0.0}, degrees(90.0)};

/// Bearing of the arc's end as the transmitter sees it.
double from_transmitter_deg(const Arc& arc, Angle t) {
  return bearing(arc.point_at(t) - arc.transmitter()).deg();
}

// V1.7 of the method specification: T=(0,0), R=(0.09,0), path 2.
TEST(Arc, EllipseWorkedNumbers) {
  const Arc arc = *Arc::elliptical(tx_v17, rx_v17, 1.0, 2 * half_beam);
  EXPECT_NEAR(arc.semi_minor_m(), 0.998986987, 5e-10);
  EXPECT_NEAR(arc.point_at(degrees(77.5 - 90)).x, 0.261231, 5e-7);
  EXPECT_NEAR(arc.point_at(degrees(77.5 - 90)).y, 0.975353, 5e-7);
  EXPECT_NEAR(arc.midpoint().x, 0.045, 1e-12);
  EXPECT_NEAR(arc.midpoint().y, 0.998987, 5e-7);
  EXPECT_NEAR(arc.point_at(degrees(12.5)).x, -0.171231, 5e-7);
  EXPECT_EQ(arc.t_begin(), -half_beam);
  EXPECT_EQ(arc.t_end(), half_beam);
  const Vec2 p{0.510473, 0.884165};  // alpha = 60 degrees
  EXPECT_NEAR(arc.half_path_m(p), 1.0, 1e-6);
  EXPECT_NEAR(bearing(p - arc.receiver()).deg(), 64.566138, 1e-4);
}

TEST(Arc, BothPolicyIsTheOverlapOfTheBeams) {
  const Arc arc = *Arc::elliptical(tx_v17, rx_v17, 1.0, 2 * half_beam, BeamPolicy::both);
  EXPECT_NEAR(from_transmitter_deg(arc, arc.t_begin()), 77.5, 1e-9);
  EXPECT_NEAR(from_transmitter_deg(arc, arc.t_end()), 97.419428, 1e-6);
}

TEST(Arc, EitherPolicyIsTheHullOfTheBeams) {
  const Arc arc = *Arc::elliptical(tx_v17, rx_v17, 1.0, 2 * half_beam, BeamPolicy::either);
  EXPECT_NEAR(from_transmitter_deg(arc, arc.t_begin()), 72.517316, 1e-6);
  EXPECT_NEAR(from_transmitter_deg(arc, arc.t_end()), 102.5, 1e-9);
}

// V1.8: neighbours on the Nomad ring.
Pose2 on_nomad_ring(Angle at) {
  return {0.23 * unit(at), at};
}

TEST(Arc, StrictOverlapOfNomadNeighbours) {
  const Pose2 tx = on_nomad_ring(degrees(-11.25));
  const Pose2 rx = on_nomad_ring(degrees(11.25));
  const auto overlap = [&](double range_m) {
    return Arc::elliptical(tx, rx, range_m, 2 * half_beam, BeamPolicy::both);
  };
  EXPECT_FALSE(overlap(1.5));
  EXPECT_FALSE(overlap(2.0568));
  EXPECT_TRUE(overlap(2.0570));
  const struct {
    double range_m, begin_deg, end_deg;
  } rows[] = {{2.2, 1.0873, 1.25}, {3.0, 0.4640, 1.25}, {5.0, -0.2217, 1.25}};
  for (const auto& row : rows) {
    const auto arc = overlap(row.range_m);
    ASSERT_TRUE(arc) << row.range_m;
    EXPECT_NEAR(from_transmitter_deg(*arc, arc->t_begin()), row.begin_deg, 1e-4);
    EXPECT_NEAR(from_transmitter_deg(*arc, arc->t_end()), row.end_deg, 1e-4);
  }
}

TEST(Arc, RefusesImpossibleBistaticGeometry) {
  EXPECT_FALSE(Arc::elliptical(tx_v17, rx_v17, 0.045, 2 * half_beam)) << "path equal to the distance of the foci";
  EXPECT_FALSE(Arc::elliptical(tx_v17, {{0.09, 0}, degrees(181.0)}, 1.0, 2 * half_beam)) << "axes 91 degrees apart";
  EXPECT_TRUE(Arc::elliptical(tx_v17, {{0.09, 0}, degrees(180.0)}, 1.0, 2 * half_beam));
}

TEST(Arc, CircleMembershipAcrossTheSeam) {
  const Arc arc = Arc::circular({0, 0}, degrees(180.0), 2.0, degrees(22.5));
  EXPECT_TRUE(arc.contains_bearing(degrees(-168.75)));
  EXPECT_TRUE(arc.contains_bearing(degrees(168.75)));
  EXPECT_FALSE(arc.contains_bearing(degrees(-168.7)));
  EXPECT_NEAR(arc.length_m(), 2.0 * degrees(22.5).rad(), 1e-15);
}

Pose2 arbitrary_pose(Rng& rng) {
  return {{rng.uniform(-5, 5), rng.uniform(-5, 5)}, degrees(rng.uniform(-180, 180))};
}

RC_GTEST_PROP(ArcProperty, CoincidingFociGiveTheCircle, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 pose = arbitrary_pose(rng);
  const double range_m = rng.uniform(0.2, 10.0);
  const Angle beam = degrees(rng.uniform(1.0, 90.0));
  const Arc circle = Arc::circular(pose.position, pose.heading, range_m, beam);
  const Pose2 nearby{pose.position + 1e-8 * unit(pose.heading), pose.heading};
  for (const BeamPolicy policy : {BeamPolicy::bisector, BeamPolicy::both, BeamPolicy::either}) {
    const auto same = Arc::elliptical(pose, pose, range_m, beam, policy);
    const auto close = Arc::elliptical(pose, nearby, range_m, beam, policy);
    RC_ASSERT(same.has_value() && close.has_value());
    for (const double s : {-1.0, -0.3, 0.0, 0.8, 1.0}) {
      const Angle t = s * circle.half_width();
      RC_ASSERT(norm(same->point_at(t) - circle.point_at(t)) <= 1e-12);
      RC_ASSERT(norm(close->point_at(t) - circle.point_at(t)) <= 2e-8);
    }
  }
}

RC_GTEST_PROP(ArcProperty, PointsKeepThePathLengthAndReflectEvenly, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 tx = arbitrary_pose(rng);
  const Pose2 rx{tx.position + Vec2{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)},
                 tx.heading + degrees(rng.uniform(-60, 60))};
  const auto arc = Arc::elliptical(tx, rx, rng.uniform(0.5, 6.0), degrees(rng.uniform(5, 60)));
  RC_ASSERT(arc.has_value());
  for (const double s : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
    const Angle t = s * arc->half_width();
    const Vec2 p = arc->point_at(t);
    RC_ASSERT(std::abs(arc->half_path_m(p) - arc->range_m()) < 1e-12);
    RC_ASSERT(arc->contains_bearing(bearing(p - arc->centre())));
    // Numerical tangent against the analytic one.
    const Vec2 step = arc->point_at(t + radians(1e-6)) - arc->point_at(t - radians(1e-6));
    RC_ASSERT(std::abs(dot(step, arc->normal_at(t))) < 1e-6 * norm(step));
    RC_ASSERT(dot(step, arc->tangent_at(t)) > 0.0);
  }
}

RC_GTEST_PROP(ArcProperty, LengthAndBoundsAgreeWithAFinePolyline, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 tx = arbitrary_pose(rng);
  const Pose2 rx{tx.position + Vec2{rng.uniform(-0.3, 0.3), 0.05}, tx.heading + degrees(rng.uniform(-60, 60))};
  const auto arc = Arc::elliptical(tx, rx, rng.uniform(0.5, 6.0), degrees(rng.uniform(5, 170)));
  RC_ASSERT(arc.has_value());
  constexpr int steps = 4000;
  const Box box = arc->bounds();
  double length = 0.0;
  Box seen{arc->point_at(arc->t_begin()), arc->point_at(arc->t_begin())};
  Vec2 previous = seen.low;
  for (int k = 0; k <= steps; ++k) {
    const Vec2 p = arc->point_at(arc->t_begin() + (double(k) / steps) * (arc->t_end() - arc->t_begin()));
    length += norm(p - previous);
    previous = p;
    seen.low = {std::min(seen.low.x, p.x), std::min(seen.low.y, p.y)};
    seen.high = {std::max(seen.high.x, p.x), std::max(seen.high.y, p.y)};
  }
  RC_ASSERT(std::abs(arc->length_m() - length) < 1e-6 * length);
  RC_ASSERT(box.low.x <= seen.low.x + 1e-12 && box.low.x > seen.low.x - 1e-4);
  RC_ASSERT(box.low.y <= seen.low.y + 1e-12 && box.low.y > seen.low.y - 1e-4);
  RC_ASSERT(box.high.x >= seen.high.x - 1e-12 && box.high.x < seen.high.x + 1e-4);
  RC_ASSERT(box.high.y >= seen.high.y - 1e-12 && box.high.y < seen.high.y + 1e-4);
}

RC_GTEST_PROP(ArcProperty, CircleBoundsAreThoseOfAFinePolyline, (std::uint64_t seed)) {
  Rng rng(seed);
  const Pose2 sensor = arbitrary_pose(rng);
  Arc arc = Arc::circular(sensor.position, sensor.heading, rng.uniform(0.5, 6.0), degrees(rng.uniform(5, 179)));
  arc.set_limits(rng.uniform(-1.0, 0.0) * arc.half_width(), rng.uniform(0.0, 1.0) * arc.half_width());
  const Box box = arc.bounds();
  Box seen{arc.point_at(arc.t_begin()), arc.point_at(arc.t_begin())};
  for (int k = 0; k <= 4000; ++k) {
    const Vec2 p = arc.point_at(arc.t_begin() + (k / 4000.0) * (arc.t_end() - arc.t_begin()));
    seen.low = {std::min(seen.low.x, p.x), std::min(seen.low.y, p.y)};
    seen.high = {std::max(seen.high.x, p.x), std::max(seen.high.y, p.y)};
  }
  RC_ASSERT(box.low.x <= seen.low.x + 1e-12 && box.low.x > seen.low.x - 1e-5);
  RC_ASSERT(box.low.y <= seen.low.y + 1e-12 && box.low.y > seen.low.y - 1e-5);
  RC_ASSERT(box.high.x >= seen.high.x - 1e-12 && box.high.x < seen.high.x + 1e-5);
  RC_ASSERT(box.high.y >= seen.high.y - 1e-12 && box.high.y < seen.high.y + 1e-5);
}

}  // namespace
}  // namespace echoarc
