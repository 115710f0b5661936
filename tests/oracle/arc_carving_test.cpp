// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/arc_carving.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"

namespace echoarc {
namespace {

/// Sensors within a metre, looking roughly one way, so that most pairs overlap; every third arc is elliptical.
Arc random_arc(Rng& rng) {
  const Pose2 tx{{rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)}, degrees(150.0 + rng.uniform(0.0, 60.0))};
  const double range_m = rng.uniform(0.5, 3.0);
  const Angle beam = degrees(rng.uniform(5.0, 80.0));
  if (rng.below(3) != 0) return Arc::circular(tx.position, tx.heading, range_m, beam);
  const Pose2 rx{tx.position + Vec2{rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4)},
                 tx.heading + degrees(rng.uniform(-60.0, 60.0))};
  return Arc::elliptical(tx, rx, range_m, beam).value_or(Arc::circular(tx.position, tx.heading, range_m, beam));
}

/// eq. 3.2 as it stands, open: +1 inside, -1 outside, 0 too close to the boundary to say.
int side(const Arc& newer, double guard_m, Vec2 p) {
  constexpr double slack = 1e-7;
  const double path_m = norm(p - newer.transmitter()) + norm(p - newer.receiver());
  const double before_front = newer.range_m() - guard_m - 0.5 * path_m;
  const double before_edge =
      newer.half_width().rad() - std::abs(wrap(bearing(p - newer.centre()) - newer.axis()).rad());
  const double inside = std::min(before_front, before_edge);
  return inside > slack ? 1 : inside < -slack ? -1 : 0;
}

/// What dense sampling says: how many separate pieces are outside F, and whether the arc is touched at all.
struct Sampled {
  int kept_pieces = 0;
  bool touched = false;
};

Sampled sample(const Arc& older, const Arc& newer, double guard_m, int count) {
  Sampled sampled;
  int last = 1;
  for (int k = 0; k <= count; ++k) {
    const Angle t = older.t_begin() + (double(k) / count) * (older.t_end() - older.t_begin());
    const int now = side(newer, guard_m, older.point_at(t));
    if (now == 0) continue;
    if (now < 0 && last > 0) ++sampled.kept_pieces;
    sampled.touched |= now > 0;
    last = now;
  }
  return sampled;
}

bool agrees(const Carving& carving, const Sampled& sampled) {
  switch (carving.outcome) {
    case CarveOutcome::unchanged: return !sampled.touched;
    case CarveOutcome::carved: return sampled.touched && sampled.kept_pieces == 1;
    case CarveOutcome::removed_full: return sampled.kept_pieces == 0;
    case CarveOutcome::removed_split: return sampled.touched && sampled.kept_pieces >= 2;
  }
  return false;
}

struct Case {
  Arc older;
  Arc newer;
  double guard_m = 0.0;
};

Case random_case(std::uint64_t seed) {
  Rng rng(seed);
  Case c{random_arc(rng), random_arc(rng), rng.below(2) == 0 ? 0.0 : rng.uniform(0.0, 0.1)};
  if (rng.below(2) == 0) {  // already carved once
    const Angle h = c.older.half_width();
    c.older.set_limits(rng.uniform(-1.0, -0.1) * h, rng.uniform(0.1, 1.0) * h);
  }
  return c;
}

RC_GTEST_PROP(ArcCarvingOracle, OutcomeIsThatOfDenseSampling, (std::uint64_t seed)) {
  const Case c = random_case(seed);
  const Carving carving = carve(c.older, FreeSector(c.newer, c.guard_m));
  bool agree = false;
  for (const int count : {2'000, 200'000, 5'000'000}) {  // finer where a piece is too short for the first samples
    agree = agrees(carving, sample(c.older, c.newer, c.guard_m, count));
    if (agree) break;
  }
  RC_ASSERT(agree);
}

RC_GTEST_PROP(ArcCarvingOracle, WhatIsLeftIsExactlyOutside, (std::uint64_t seed)) {
  const Case c = random_case(seed);
  const Carving carving = carve(c.older, FreeSector(c.newer, c.guard_m));
  RC_ASSERT(carving.t_begin >= c.older.t_begin());
  RC_ASSERT(carving.t_end <= c.older.t_end());
  RC_PRE(carving.outcome == CarveOutcome::carved);
  const FreeSector sector(c.newer, c.guard_m);
  const Angle step = radians(1e-7);
  // The new end lies on the boundary: just inside what is left is outside F, just beyond it is inside.
  for (const auto& [end, outwards, old_end] :
       {std::tuple{carving.t_begin, -step, c.older.t_begin()}, std::tuple{carving.t_end, step, c.older.t_end()}}) {
    if (end == old_end) continue;
    RC_ASSERT(!sector.contains(c.older.point_at(end - outwards)));
    RC_ASSERT(sector.contains(c.older.point_at(end + outwards)) || carving.t_end - carving.t_begin < 2 * step);
  }
}

RC_GTEST_PROP(ArcCarvingProperty, CarvingTwiceByTheSameReadingChangesNothingMore, (std::uint64_t seed)) {
  Case c = random_case(seed);
  const FreeSector sector(c.newer, c.guard_m);
  const Carving carving = carve(c.older, sector);
  RC_PRE(carving.outcome == CarveOutcome::carved);
  c.older.set_limits(carving.t_begin, carving.t_end);
  RC_ASSERT(carve(c.older, sector).outcome == CarveOutcome::unchanged);
}

RC_GTEST_PROP(ArcCarvingProperty, BoundsHoldTheSectorAndReachTellsTheTruth, (std::uint64_t seed)) {
  const Case c = random_case(seed);
  const FreeSector sector(c.newer, c.guard_m);
  Rng rng(seed);
  for (int k = 0; k < 200; ++k) {
    const Vec2 p{rng.uniform(-4.0, 4.0), rng.uniform(-4.0, 4.0)};
    const bool in_box = p.x >= sector.bounds().low.x && p.x <= sector.bounds().high.x && p.y >= sector.bounds().low.y &&
                        p.y <= sector.bounds().high.y;
    RC_ASSERT(in_box || !sector.contains(p));
  }
  if (sector.out_of_reach(c.older)) RC_ASSERT(!sample(c.older, c.newer, c.guard_m, 2'000).touched);
}

}  // namespace
}  // namespace echoarc
