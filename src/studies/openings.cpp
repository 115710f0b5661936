// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/openings.hpp"

#include <algorithm>
#include <cmath>

namespace echoarc::studies {

std::vector<Gap> open_stretches(const sim::WorldDescription& world, Vec2 a, Vec2 b, double tolerance_m) {
  const double length = norm(b - a);
  const Vec2 along = (b - a) / length;
  std::vector<Gap> covered;
  for (const sim::Wall& wall : world.walls) {
    if (std::abs(cross(along, wall.a - a)) > tolerance_m || std::abs(cross(along, wall.b - a)) > tolerance_m) continue;
    const double begin_m = dot(along, wall.a - a);
    const double end_m = dot(along, wall.b - a);
    covered.push_back({std::min(begin_m, end_m), std::max(begin_m, end_m)});
  }
  covered.push_back({length, length});
  std::ranges::sort(covered, {}, &Gap::begin_m);
  constexpr double least_m = 1e-3;
  std::vector<Gap> open;
  double done_m = 0.0;
  for (const Gap& wall : covered) {
    const double end_m = std::min(wall.begin_m, length);
    if (end_m - done_m > least_m) open.push_back({done_m, end_m});
    done_m = std::max(done_m, wall.end_m);
  }
  return open;
}

Strip strip_over(Vec2 a, Vec2 b, const Gap& stretch, double depth_m) {
  const Vec2 along = (b - a) / norm(b - a);
  return {a + stretch.begin_m * along, a + stretch.end_m * along, depth_m, depth_m};
}

}  // namespace echoarc::studies
