// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include "echoarc/features/landmarks.hpp"

namespace echoarc {
namespace {

constexpr int most_steps = 30;

Vec2 mean_normal(std::span<const DepthRegion> regions) {
  Vec2 sum;
  for (const DepthRegion& region : regions) sum = sum + region.normal();
  return norm(sum) > 0.0 ? sum / norm(sum) : Vec2{1.0, 0.0};
}

}  // namespace

WallFit fit_wall(std::span<const DepthRegion> regions) {
  const auto n = double(regions.size());
  Vec2 middle;
  double depth_m = 0.0;
  for (const DepthRegion& region : regions) {
    middle = middle + region.position / n;
    depth_m += region.depth_m / n;
  }
  // For a direction n the best H is the mean of n.S_k + r_k; what is left over is e_k = n.s_k + rho_k about the means.
  Angle direction = bearing(mean_normal(regions));
  for (int step = 0; step < most_steps; ++step) {
    const Vec2 normal = unit(direction);
    double slope = 0.0;
    double curvature = 0.0;
    for (const DepthRegion& region : regions) {
      const Vec2 s = region.position - middle;
      const double left_over = dot(normal, s) + region.depth_m - depth_m;
      const double change = dot(perpendicular(normal), s);
      slope += left_over * change;
      curvature += change * change;
    }
    if (curvature <= 0.0) break;
    const Angle turn = radians(-slope / curvature);
    direction += turn;
    if (std::abs(turn.rad()) < 1e-14) break;
  }
  WallFit fit{unit(direction), dot(unit(direction), middle) + depth_m, 0.0};
  double squares = 0.0;
  for (const DepthRegion& region : regions) {
    const double left_over = fit.distance_m - dot(fit.normal, region.position) - region.depth_m;
    squares += left_over * left_over / n;
  }
  fit.rms_m = std::sqrt(squares);
  return fit;
}

PointFit fit_point(std::span<const DepthRegion> regions) {
  const auto n = double(regions.size());
  PointFit fit;
  for (const DepthRegion& region : regions) fit.position = fit.position + region.echo_point() / n;
  const auto rms_at = [&](Vec2 p) {
    double squares = 0.0;
    for (const DepthRegion& region : regions) {
      const double left_over = norm(p - region.position) - region.depth_m;
      squares += left_over * left_over / n;
    }
    return std::sqrt(squares);
  };
  fit.rms_m = rms_at(fit.position);
  for (int step = 0; step < most_steps; ++step) {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Vec2 gradient;
    for (const DepthRegion& region : regions) {
      const Vec2 away = fit.position - region.position;
      const double distance_m = norm(away);
      if (distance_m <= 0.0) continue;
      const Vec2 u = away / distance_m;
      gradient = gradient + (distance_m - region.depth_m) * u;
      xx += u.x * u.x;
      xy += u.x * u.y;
      yy += u.y * u.y;
    }
    const double determinant = xx * yy - xy * xy;
    if (determinant <= 1e-12 * (xx + yy) * (xx + yy)) break;  // all seen from one side: no more to be learnt
    const Vec2 move{-(yy * gradient.x - xy * gradient.y) / determinant,
                    -(xx * gradient.y - xy * gradient.x) / determinant};
    double share = 1.0;
    while (share > 1e-6 && rms_at(fit.position + share * move) > fit.rms_m) share *= 0.5;
    if (share <= 1e-6) break;
    fit.position = fit.position + share * move;
    fit.rms_m = rms_at(fit.position);
    if (share * norm(move) < 1e-13) break;
  }
  return fit;
}

}  // namespace echoarc
