// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Crossings of arcs against dense sampling and bisection.

#include "echoarc/core/arc_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

/// Walks along `b` and looks where the half path seen from `a` passes its range: every change of sign is bisected.
std::vector<ArcCrossing> sampled_crossings(const Arc& a, const Arc& b, int intervals) {
  const auto off = [&](Angle t) { return a.half_path_m(b.point_at(t)) - a.range_m(); };
  std::vector<ArcCrossing> found;
  const Angle width = b.t_end() - b.t_begin();
  for (int k = 0; k < intervals; ++k) {
    Angle low = b.t_begin() + width * (double(k) / intervals);
    Angle high = b.t_begin() + width * (double(k + 1) / intervals);
    const bool low_inside = off(low) < 0.0;
    if (low_inside == (off(high) < 0.0)) continue;
    for (int step = 0; step < 60; ++step) {
      const Angle middle = 0.5 * (low + high);
      ((off(middle) < 0.0) == low_inside ? low : high) = middle;
    }
    const Vec2 p = b.point_at(low);
    if (!a.contains_bearing(bearing(p - a.centre()))) continue;
    const Angle t_a = wrap(bearing(p - a.centre()) - a.axis());
    const double cosine = std::min(1.0, std::abs(dot(a.normal_at(t_a), b.normal_at(low))));
    found.push_back({p, t_a, low, radians(std::acos(cosine))});
  }
  return found;
}

Arc random_arc(Rng& rng, bool elliptical, Angle half_turn) {
  const Pose2 tx{{rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)}, degrees(rng.uniform(-180, 180))};
  const double range_m = rng.uniform(0.6, 3.0);
  const Angle beam = rng.uniform(0.05, 1.0) * half_turn;
  if (!elliptical) return Arc::circular(tx.position, tx.heading, range_m, beam);
  const Pose2 rx = tx * Pose2{{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4)}, degrees(rng.uniform(-60, 60))};
  return *Arc::elliptical(tx, rx, range_m, beam);
}

/// Whether a pair is one that rounding, not geometry, decides: curves that nearly touch, points at an end.
bool delicate(const std::vector<ArcCrossing>& found, const Arc& a, const Arc& b) {
  constexpr Angle flat = degrees(0.3);
  constexpr Angle margin = radians(1e-7);
  return std::ranges::any_of(found, [&](const ArcCrossing& c) {
    return c.angle < flat || c.t_a - a.t_begin() < margin || a.t_end() - c.t_a < margin ||
           c.t_b - b.t_begin() < margin || b.t_end() - c.t_b < margin;
  });
}

/// The same pair with its arcs drawn 0.1 degrees longer: shows crossings just beyond an end.
std::vector<ArcCrossing> around(Arc a, Arc b, int intervals) {
  for (Arc* arc : {&a, &b}) arc->set_limits(arc->t_begin() - degrees(0.1), arc->t_end() + degrees(0.1));
  return sampled_crossings(a, b, intervals);
}

void compare(bool a_elliptical, bool b_elliptical, std::uint64_t seed) {
  Rng rng(seed);
  int compared = 0;
  int crossed = 0;
  for (int k = 0; k < 2000; ++k) {
    const Arc a = random_arc(rng, a_elliptical, degrees(170.0));
    const Arc b = random_arc(rng, b_elliptical, degrees(170.0));
    constexpr int intervals = 800;
    std::vector<ArcCrossing> expected = sampled_crossings(a, b, intervals);
    const ArcCrossings exact = crossings(a, b);
    std::vector<ArcCrossing> found(exact.begin(), exact.end());
    if (delicate(found, a, b) || delicate(around(a, b, intervals), a, b)) continue;
    std::ranges::sort(found, {}, [](const ArcCrossing& c) { return c.t_b.rad(); });
    ASSERT_EQ(found.size(), expected.size()) << k;
    ++compared;
    for (std::size_t n = 0; n < found.size(); ++n) {
      ++crossed;
      EXPECT_LT(norm(found[n].position - expected[n].position), 1e-11) << k;
      EXPECT_NEAR(found[n].t_a.rad(), expected[n].t_a.rad(), 1e-11) << k;
      EXPECT_NEAR(found[n].t_b.rad(), expected[n].t_b.rad(), 1e-11) << k;
      EXPECT_NEAR(found[n].angle.rad(), expected[n].angle.rad(), 1e-7) << k;  // acos is coarse near 0
    }
  }
  EXPECT_GT(compared, 1500);
  EXPECT_GT(crossed, 150);
}

TEST(ArcCrossingOracle, CircleAndCircle) {
  compare(false, false, 1);
}
TEST(ArcCrossingOracle, EllipseAndCircle) {
  compare(true, false, 2);
}
TEST(ArcCrossingOracle, CircleAndEllipse) {
  compare(false, true, 3);
}
TEST(ArcCrossingOracle, EllipseAndEllipse) {
  compare(true, true, 4);
}

}  // namespace
}  // namespace echoarc
