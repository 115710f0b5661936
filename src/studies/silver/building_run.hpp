// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/maps/point_map.hpp"
#include "echoarc/studies/arc_study.hpp"
#include "echoarc/studies/study_host.hpp"

/// One tour of the building of [Silver04] 5, and everything measured on it.
namespace echoarc::studies::silver {

/// The methods whose histories are watched, in this order. `guarded`: a reading does not carve the last inch before its
/// echo, so that the error of a range does not carve what it has just measured.
enum class Watched : std::uint8_t { atm, carve, combined, centerline, carve_guarded, combined_guarded };
inline constexpr std::size_t watched_count = 6;

/// How well points lie on the true surfaces.
struct Accuracy {
  std::uint64_t points = 0;
  double median_m = 0.0;     ///< distance to the nearest surface
  double within_10cm = 0.0;  ///< share of the points
};

/// The same firings, with the time each ping was really sent, and told from polled registers (App. A).
struct Stamping {
  std::vector<ArcStudy> arcs;  ///< by `Watched`
  std::uint64_t readings = 0;
  Accuracy centers;  ///< of the centerline map
};

struct BuildingRun {
  Stamping stamped;
  Stamping polled;
  Accuracy naive_centers;  ///< polled registers dated by the poll that shows them (Fig. 14)
  Accuracy atm;            ///< final medians (Fig. 13a)
  Accuracy carved;         ///< middles of sufficiently carved arcs (Fig. 13b)
  double path_m = 0.0;
  std::uint64_t pings = 0;
  double mapped_m2 = 0.0;  ///< of the true free space, what readings have declared free
  // For the pictures; kept if asked for. Positions alone: a building has many.
  std::vector<Vec2> stamped_points, naive_points, polled_points, atm_points, carved_points, path;

  [[nodiscard]] const ArcStudy& study(Watched method) const { return stamped.arcs[static_cast<std::size_t>(method)]; }
};

/// What does not depend on the seed: points on the surfaces, and the true states of coarse cells.
struct BuildingTruth {
  PointSet surfaces;
  DenseGrid<CellState> states;
};
[[nodiscard]] Result<BuildingTruth> building_truth(const StudyScene& scene);

/// Errors: those of `simulate`.
[[nodiscard]] Result<BuildingRun> tour_building(const StudyScene& scene, const BuildingTruth& truth,
                                                const NearestPoints& surfaces, std::uint64_t seed, bool keep);

}  // namespace echoarc::studies::silver
