// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/eval/correct_detection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/arc.hpp"
#include "echoarc/eval/nearest_points.hpp"

namespace echoarc {
namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;

/// Lines begin <= k < end of a family.
struct LineRange {
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

std::int64_t clipped(double line, const LineFamily& family) {
  return static_cast<std::int64_t>(std::clamp(line, 0.0, double(family.count)));
}

/// The line of `p` and, for a cell of side `cell_m` around it, the lines k with their middle (k + 1/2) width in
/// [t - cell/2, t + cell/2). For cells as wide as a line that is the line of the centre again.
LineRange lines_through(const LineFamily& family, Vec2 p, double cell_m) {
  const Vec2 from_corner = p - family.corner;
  if (dot(from_corner, family.along) < 0.0) return {};
  const double t = dot(from_corner, family.across) / family.width_m;
  double begin = std::floor(t);
  double end = begin + 1.0;
  if (cell_m > family.width_m) {
    const double reach = 0.5 * cell_m / family.width_m;
    begin = std::min(begin, std::ceil(t - reach - 0.5));
    end = std::max(end, std::ceil(t + reach - 0.5));
  }
  return {clipped(begin, family), clipped(end, family)};
}

/// The ray of `p` and, for a cell of side `cell_m` around it, those with their middle less than half a cell from `p` at
/// its distance: [begin, end) may reach beyond both ends of the family, rays counted round and round.
LineRange rays_through(const RayFamily& fan, Vec2 p, double cell_m) {
  const Vec2 from_centre = p - fan.centre;
  const double distance_m = norm(from_centre);
  if (!(distance_m > 0.0)) return {};
  double turn_rad = (bearing(from_centre) - fan.first).rad();
  turn_rad -= full_turn_rad * std::floor(turn_rad / full_turn_rad);
  const double t = turn_rad / fan.step.rad();
  double begin = std::floor(t);
  double end = begin + 1.0;
  const double reach = std::min(0.5 * cell_m / distance_m, std::numbers::pi) / fan.step.rad();
  begin = std::min(begin, std::ceil(t - reach - 0.5));
  end = std::max(end, std::ceil(t + reach - 0.5));
  return {std::int64_t(begin), std::int64_t(end)};
}

bool contains(const Box& region, Vec2 p) {
  return p.x >= region.low.x && p.x < region.high.x && p.y >= region.low.y && p.y < region.high.y;
}

/// For every ray of a fan, whether one of the points lies on it.
std::vector<bool> full_rays(std::span<const Vec2> points, double cell_m, const RayFamily& fan, const Box& region) {
  std::vector<bool> full(std::size_t(fan.count), false);
  const auto round = std::max<std::int64_t>(1, std::llround(full_turn_rad / fan.step.rad()));
  for (const Vec2 p : points) {
    if (!contains(region, p)) continue;
    const LineRange rays = rays_through(fan, p, cell_m);
    for (std::int64_t k = rays.begin; k < rays.end; ++k) {
      const std::int64_t ray = (k % round + round) % round;
      if (ray < fan.count) full[std::size_t(ray)] = true;
    }
  }
  return full;
}

/// For every line, family by family, whether one of the points lies on it. A coarse cell covers many lines, so ranges
/// are counted at their ends and summed up once: O(points + lines).
std::vector<bool> full_lines(std::span<const Vec2> points, double cell_m, const DirectionSet& directions) {
  std::vector<bool> full;
  for (const LineFamily& family : directions.families) {
    std::vector<std::int64_t> change(std::size_t(family.count) + 1, 0);
    for (const Vec2 p : points) {
      if (!contains(directions.region, p)) continue;
      const LineRange lines = lines_through(family, p, cell_m);
      ++change[std::size_t(lines.begin)];
      --change[std::size_t(lines.end)];
    }
    std::int64_t on_line = 0;
    for (std::size_t k = 0; k < std::size_t(family.count); ++k) {
      on_line += change[k];
      full.push_back(on_line > 0);
    }
  }
  for (const RayFamily& fan : directions.fans) {
    const std::vector<bool> rays = full_rays(points, cell_m, fan, directions.region);
    full.insert(full.end(), rays.begin(), rays.end());
  }
  return full;
}

std::vector<Vec2> points_near(const PointSet& map, const Reference& reference, double tolerance_m) {
  const NearestPoints nearest(reference.points);
  std::vector<Vec2> near;
  for (const Vec2 p : map.points())
    if (nearest.distance_m(p) <= tolerance_m + eps_length_m) near.push_back(p);
  return near;
}

}  // namespace

Result<CorrectDetection> correct_detection(const PointSet& map, const Reference& reference,
                                           const DirectionSet& directions, std::optional<double> tolerance_m) {
  if (const Result<void> valid = validate(directions); !valid) return valid.error();
  if (tolerance_m && !(*tolerance_m >= 0.0))
    return Error{ErrorCode::bad_value, "a tolerance of " + std::to_string(*tolerance_m) + " m", "cdr-tol",
                 "give 0 m or more, or leave it out"};
  const std::vector<bool> truth = full_lines(reference.points.points(), reference.points.cell_m(), directions);
  const std::vector<bool> seen = full_lines(map.points(), map.cell_m(), directions);
  const std::vector<bool> seen_near =
      tolerance_m ? full_lines(points_near(map, reference, *tolerance_m), map.cell_m(), directions) : seen;
  CorrectDetection score;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    ++(truth[k] ? score.full : score.empty);
    if (truth[k] && seen_near[k]) ++score.correct_full;
    if (!truth[k] && !seen[k]) ++score.correct_empty;
  }
  return score;
}

}  // namespace echoarc
