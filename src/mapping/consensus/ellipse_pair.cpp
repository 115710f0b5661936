// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/ellipse_pair.hpp"

#include <cmath>

namespace echoarc::consensus {
namespace {

double squared(double x) {
  return x * x;
}

Angle snapped(Angle a) {
  return radians(consensus::snapped(a.rad()));
}

/// u of the bin of `t_other` on arc `j`; 0 beyond its ends.
double weight_at(const BeamBins& bins, Angle step, Angle t_other, const float* weight) {
  const int k = shifted_bins(t_other / step) + bins.half;
  return k >= 0 && k < bins.count() ? double(weight[k]) : 0.0;
}

/// ln(1 - nu exp(-t'^2/2 sigma_b^2) g^2) where the other arc looked squarely at what lies well before its range.
double contradiction(const ConsensusOptions& options, const BeamBins& bins, Angle t_other, double e_m, double g) {
  constexpr Angle tie = radians(1e-6);
  if (e_m >= -options.free_margin_m || abs(t_other) > options.facing_angle + tie) return 0.0;
  const double beam = std::exp(-0.5 * squared(t_other.rad() / double(bins.sigma_rad)));
  return std::log1p(-options.facing * beam * g * g);
}

}  // namespace

void add_any_pair(const ArcTable& arcs, const ConsensusOptions& options, std::size_t i, std::size_t j,
                  const float* wall_weight, const float* point_weight, const BinSums& sums) {
  const Arc& own = arcs[i].arc;
  const Arc& other = arcs[j].arc;
  const BeamBins& bins = arcs.bins(j);
  const auto agreement = [&](double e_m) { return std::exp(-0.5 * squared(e_m / options.range_sigma_m)); };
  for (int m = 0; m < arcs.bins(i).count(); ++m) {
    const Angle direction = own.axis() + (m - arcs.bins(i).half) * options.step;
    const Vec2 n = unit(direction);
    const Vec2 p = touch_point(own, n);

    // A wall that touches the own arc at p, and the other arc at its point of the same normal.
    const Vec2 apart = touch_point(other, n) - p;
    const double wall_e_m = snapped(-dot(n, apart));
    const double g = std::exp(-0.5 * squared(snapped(cross(n, apart)) / options.wall_length_m));
    const Angle wall_t = snapped(wrap(direction - other.axis()));
    const double wall_u = weight_at(bins, options.step, wall_t, wall_weight);
    sums.wall_support[m] += float(std::log1p(g * wall_u * agreement(wall_e_m)));
    sums.wall_free[m] += float(contradiction(options, bins, wall_t, wall_e_m, g));

    // A point at p, which the other arc passes through.
    const double point_e_m = snapped(other.half_path_m(p) - other.range_m());
    const Angle point_t = snapped(wrap(bearing(normal_through(other, p)) - other.axis()));
    const double point_u = weight_at(bins, options.step, point_t, point_weight);
    sums.point_support[m] += float(std::log1p(point_u * agreement(point_e_m)));
    sums.point_free[m] += float(contradiction(options, bins, point_t, point_e_m, 1.0));
  }
}

}  // namespace echoarc::consensus
