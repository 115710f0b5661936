// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/maps/point_map.hpp"

/// Whether what a method says of its own points is so: a probability of .8 should be right four times in five, and a
/// 90 % bound should hold nine times in ten.
namespace echoarc {

/// What a method claims of one map point, and how far the point really is from the reference.
struct ClaimedPoint {
  PointLabel label = PointLabel::wall;
  double probability = 1.0;  ///< claimed: that the point is at most `right_within_m` away
  double bound_m = 0.0;      ///< claimed to hold with 90 %
  double distance_m = 0.0;   ///< to the nearest reference point
};
/// A point no further than this from the reference is right.
inline constexpr double right_within_m = 0.10;

/// The claims of a map, in its order: of every point, or with `thin_cell_m` > 0 of the first point of every cell
/// floor(p / thin_cell_m). Empty for a map without beliefs. Errors: those of `PointSet::make`.
[[nodiscard]] Result<std::vector<ClaimedPoint>> claimed_points(const PointMap& map, const NearestPoints& reference,
                                                               double thin_cell_m = 0.0);

/// A share k / n with the interval that holds the true one with 95 % (Wilson 1927, eq. for z = 1.96); all NaN for
/// n = 0.
struct ObservedShare {
  std::uint64_t hits = 0;
  std::uint64_t of = 0;
  double share = 0.0;
  double low = 0.0;
  double high = 0.0;
};
[[nodiscard]] ObservedShare observed_share(std::uint64_t hits, std::uint64_t of);

/// Claims that say about the same.
struct CalibrationBin {
  double low = 0.0;  ///< of what was claimed; a probability belongs to the bin it begins, a bound to the one it ends
  double high = 0.0;
  double claimed = 0.0;  ///< mean of what was claimed; NaN for an empty bin
  ObservedShare observed;
};

struct Calibration {
  std::uint64_t points = 0;
  double claimed = 0.0;               ///< mean probability; NaN without points
  ObservedShare right;                ///< points within `right_within_m`
  ObservedShare bound_held;           ///< points within their own bound
  std::vector<CalibrationBin> by_p;   ///< claimed: probability; observed: right
  std::vector<CalibrationBin> bound;  ///< claimed: bound, m; observed: bound held
  /// Mean gap of claim and observation over the bins of `by_p`, weighted by their points: the expected calibration
  /// error (Naeini et al. 2015). NaN without points.
  double error = 0.0;
};

/// `p_bins` bins of equal width over 0..1; bounds in bins that end at 5, 7.5, 10, 15, 20, 30 and 50 cm, and above. A
/// distance that exceeds a limit by rounding alone does not exceed it, as in `wall_distance`. Claims that are NaN count
/// as probability 0 and a bound that does not hold.
[[nodiscard]] Calibration calibrate(std::span<const ClaimedPoint> points, int p_bins = 10);

}  // namespace echoarc
