// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/eval/calibration.hpp"
#include "echoarc/studies/comparison.hpp"

/// What a comparison says: means over seeds, who is better than whom, whether claims hold.
namespace echoarc::studies {

/// How map points count: every one, or one per 5 cm cell, so that dense clusters do not flatter.
using Counting = WallDistance TwoWayWallDistance::*;
inline constexpr Counting every_point = &TwoWayWallDistance::all;
inline constexpr Counting one_per_cell = &TwoWayWallDistance::one_per_cell;

/// Means over the seeds of one method on one place; shares in 0..1, NaN where no map had a point.
struct MeanScores {
  double points = 0.0;
  std::array<double, 3> accuracy{};  ///< within `accuracy_distances_m`
  double coverage = 0.0;
  double mean_m = 0.0;  ///< distance of map points from the reference
};
[[nodiscard]] MeanScores mean_scores(std::span<const ComparedMap> maps, Counting counting);
/// The same against the laser of the whole log; NaN but for truncated logs.
[[nodiscard]] MeanScores mean_scores_against_whole(std::span<const ComparedMap> maps, Counting counting);

/// A map has to have so many points to be compared, and both scores have to differ by so much.
inline constexpr double compared_points = 100.0;
inline constexpr double clear_margin = 0.01;

/// Whether both are large enough to be compared.
[[nodiscard]] bool comparable(const MeanScores& a, const MeanScores& b);
/// Whether `a` has more points within 10 cm and finds more, each by `clear_margin` or more.
[[nodiscard]] bool dominates(const MeanScores& a, const MeanScores& b);

/// A method that is better in both scores than another on one place.
struct Dominance {
  std::size_t place = 0;
  std::size_t better = 0;  ///< method
  std::size_t worse = 0;
  Counting counting = one_per_cell;
};
/// Every case in which a method that is no mode of consensus dominates one, of all places and both ways of counting.
[[nodiscard]] std::vector<Dominance> dominators_of_consensus(const Comparison& comparison);

/// How one method fares against the consensus as shipped over all places where both can be compared.
struct Duel {
  std::size_t method = 0;
  std::size_t places = 0;
  std::size_t dominated = 0;          ///< by the consensus
  std::size_t not_more_accurate = 0;  ///< places where the consensus is not clearly more accurate
  std::size_t not_more_complete = 0;
  std::vector<std::size_t> others;  ///< places where it is not
};
/// Of every method but consensus; empty when consensus was not run.
[[nodiscard]] std::vector<Duel> duels(const Comparison& comparison, Counting counting);

/// The claims of one method, one point per 5 cm cell, pooled over whole logs and scenes that `wanted` accepts. Of
/// scenes the first seed alone when several places are pooled, so that a drive counts once.
enum class Pool : std::uint8_t { logs, scenes, all };
[[nodiscard]] std::vector<ClaimedPoint> pooled_claims(const Comparison& comparison, std::size_t method, Pool pool);
/// Of one place, all seeds.
[[nodiscard]] std::vector<ClaimedPoint> claims_of(const ComparedPlace& place, std::size_t method);
/// Those of one label.
[[nodiscard]] std::vector<ClaimedPoint> with_label(std::span<const ClaimedPoint> claims, PointLabel label);

}  // namespace echoarc::studies
