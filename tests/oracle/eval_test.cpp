// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// Scores against their definitions, written down naively.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "echoarc/core/rng.hpp"
#include "echoarc/eval/correct_detection.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/eval/wall_distance.hpp"

namespace echoarc {
namespace {

double naive_distance_m(Vec2 query, const PointSet& set) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Vec2 p : set.points()) nearest_m = std::min(nearest_m, norm(p - query));
  return nearest_m;
}

/// Points on a lattice of `step_m`, so that ties and equal points abound, or off it.
PointSet random_points(Rng& rng, std::size_t count, double extent_m, double step_m) {
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k) {
    Vec2 p{rng.uniform(-extent_m, extent_m), rng.uniform(-extent_m, extent_m)};
    if (step_m > 0.0) p = {step_m * std::round(p.x / step_m), step_m * std::round(p.y / step_m)};
    points.push_back(p);
  }
  return *PointSet::make(std::move(points));
}

RC_GTEST_PROP(EvalOracle, NearestPointIsTheNearestOfAll, ()) {
  Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const double step_m = *rc::gen::element(0.0, 0.05, 1.0);
  const PointSet set = random_points(rng, 1 + rng.below(400), 5.0, step_m);
  const PointSet queries = random_points(rng, 50, 8.0, step_m);
  const std::vector<double> fast_m = nearest_distances_m(queries, set);
  for (std::size_t k = 0; k < queries.size(); ++k)
    RC_ASSERT(std::abs(fast_m[k] - naive_distance_m(queries.points()[k], set)) <= 1e-12);
}

/// The strips of `LineFamily`, each asked of each point; a cell lies on the line of its centre and on lines whose
/// middle it reaches.
bool naive_on_line(Vec2 p, double cell_m, const LineFamily& family, int k) {
  const double along = dot(p - family.corner, family.along);
  const double across = dot(p - family.corner, family.across);
  if (along < 0.0) return false;
  const double middle = (k + 0.5) * family.width_m;
  const bool centre_inside = across >= k * family.width_m && across < (k + 1) * family.width_m;
  return centre_inside || (cell_m > family.width_m && middle >= across - cell_m / 2 && middle < across + cell_m / 2);
}

bool naive_full(const PointSet& set, const DirectionSet& directions, const LineFamily& family, int k) {
  return std::any_of(set.points().begin(), set.points().end(), [&](Vec2 p) {
    const Box& region = directions.region;
    return p.x >= region.low.x && p.x < region.high.x && p.y >= region.low.y && p.y < region.high.y &&
           naive_on_line(p, set.cell_m(), family, k);
  });
}

PointSet naive_near(const PointSet& map, const PointSet& reference, double tolerance_m) {
  std::vector<Vec2> near;
  for (const Vec2 p : map.points())
    if (naive_distance_m(p, reference) <= tolerance_m) near.push_back(p);
  return *(map.cell_m() > 0.0 ? PointSet::of_cells(near, map.cell_m()) : PointSet::make(near));
}

CorrectDetection naive_detection(const PointSet& map, const PointSet& reference, const DirectionSet& directions,
                                 double tolerance_m) {
  CorrectDetection score;
  const PointSet near = naive_near(map, reference, tolerance_m);
  for (const LineFamily& family : directions.families)
    for (int k = 0; k < family.count; ++k) {
      const bool truth = naive_full(reference, directions, family, k);
      ++(truth ? score.full : score.empty);
      if (truth && naive_full(near, directions, family, k)) ++score.correct_full;
      if (!truth && !naive_full(map, directions, family, k)) ++score.correct_empty;
    }
  return score;
}

RC_GTEST_PROP(EvalOracle, DetectionRatiosAreWhatCountingGives, ()) {
  Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const double cell_m = *rc::gen::element(0.0, 0.1, 0.25);
  const PointSet loose = random_points(rng, rng.below(40), 1.2, 0.0);
  const std::vector<Vec2> centres(loose.points().begin(), loose.points().end());
  const PointSet map = cell_m > 0.0 ? *PointSet::of_cells(centres, cell_m) : loose;
  const Reference reference{random_points(rng, 1 + rng.below(40), 1.2, 0.0), 0.0, "random"};
  const Box region{{-1.0, -0.8}, {0.9, 1.0}};
  DirectionSet directions = axis_directions(region, {0.1, 0.2}, degrees(rng.uniform(-180.0, 180.0)), 0.07);
  const std::vector<WallSpan> walls = {{{-0.5, -0.5}, {0.6, -0.4}, 0.2}};
  directions.families.push_back(wall_directions(walls, region, 0.05).families.front());
  const double tolerance_m = rng.uniform(0.0, 0.4);

  const auto paper = correct_detection(map, reference, directions);
  RC_ASSERT(paper.has_value());
  RC_ASSERT(*paper == naive_detection(map, reference.points, directions, 1e300));
  const auto tolerant = correct_detection(map, reference, directions, tolerance_m);
  RC_ASSERT(tolerant.has_value());
  RC_ASSERT(*tolerant == naive_detection(map, reference.points, directions, tolerance_m));
}

RC_GTEST_PROP(EvalOracle, OverallRatioLiesBetweenTheOthers, ()) {
  Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const Reference reference{random_points(rng, 5, 1.0, 0.0), 0.0, "random"};
  const auto score =
      correct_detection(random_points(rng, 5, 1.0, 0.0), reference, column_directions({0.1, {-1.0, -1.0}}, 20, 20));
  RC_ASSERT(score.has_value());
  const double overall = score->overall_ratio();
  RC_ASSERT(overall >= std::min(score->full_ratio(), score->empty_ratio()) - 1e-12);
  RC_ASSERT(overall <= std::max(score->full_ratio(), score->empty_ratio()) + 1e-12);
}

double naive_share_within(const PointSet& from, const PointSet& to, double limit_m) {
  double within = 0.0;
  for (const Vec2 p : from.points()) within += naive_distance_m(p, to) <= limit_m ? 1.0 : 0.0;
  return within / double(from.size());
}

PointSet naive_one_per_cell(const PointSet& set, double cell_m) {
  std::vector<Vec2> kept;
  std::map<std::pair<double, double>, bool> taken;
  for (const Vec2 p : set.points())
    if (!std::exchange(taken[{std::floor(p.x / cell_m), std::floor(p.y / cell_m)}], true)) kept.push_back(p);
  return *PointSet::make(kept);
}

RC_GTEST_PROP(EvalOracle, WallDistanceIsWhatCountingGives, ()) {
  Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const PointSet map = random_points(rng, 1 + rng.below(200), 1.0, 0.0);
  const Reference reference{random_points(rng, 1 + rng.below(100), 3.0, 0.0), 0.0, "random"};
  const PointSet path = random_points(rng, 3, 1.0, 0.0);
  std::vector<Vec2> near_path;
  for (const Vec2 p : reference.points.points())
    if (naive_distance_m(p, path) <= 2.5) near_path.push_back(p);
  RC_PRE(!near_path.empty());
  const PointSet reachable = *PointSet::make(near_path);

  const TwoWayWallDistance score = wall_distance(map, reference, path);
  const PointSet thinned = naive_one_per_cell(map, 0.05);
  for (const auto& [one, points] : {std::pair{score.all, map}, std::pair{score.one_per_cell, thinned}}) {
    RC_ASSERT(one.points == points.size());
    for (std::size_t k = 0; k < accuracy_distances_m.size(); ++k)
      RC_ASSERT(std::abs(one.accuracy[k] - naive_share_within(points, reference.points, accuracy_distances_m[k])) <=
                1e-12);
    RC_ASSERT(one.reference_points == reachable.size());
    RC_ASSERT(std::abs(one.coverage - naive_share_within(reachable, points, 0.10)) <= 1e-12);
  }
}

}  // namespace
}  // namespace echoarc
