// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "echoarc/studies/experiment.hpp"
#include "studies/barshan/methods.hpp"

/// Everything that is measured of one of the paper's set-ups, over all seeds.
namespace echoarc::studies::barshan {

/// A parameter varied over values; the first eight are those of Tables 2 to 6.
struct SweepPlan {
  std::string_view id;         ///< of `published_sweeps`, "T2-vt"
  std::string_view published;  ///< set-up the paper printed it for: title of a place
  Technique technique = Technique::vt;
  bool edges = false;  ///< TBF: edge-like points alone
  int columns = 20;    ///< TBF: of the window
  std::vector<double> values;
};
/// The same for every place.
[[nodiscard]] std::vector<SweepPlan> sweep_plans();
/// Position of an id in `sweep_plans`.
[[nodiscard]] std::size_t sweep_index(std::string_view id);

/// Transversal angles of Figures 13 to 15: 0 to 90 degrees.
inline constexpr int angle_count = 91;

/// One seed.
struct PlaceRun {
  double arcs = 0.0;
  double arcs_in_region = 0.0;
  std::vector<MethodResult> printed;          ///< as `printed_rows`; maps of the first seed alone
  std::vector<std::vector<MapScore>> sweeps;  ///< as `sweep_plans`
  std::vector<MapScore> atm_org;              ///< by transversal angle in degrees
  std::vector<MapScore> atm_mod;
  std::vector<Vec2> votes;  ///< cells of the arc map of the first seed
  std::vector<Vec2> path;   ///< of the first seed
};

struct PlaceStudy {
  Place place = Place::curve;
  sim::WorldDescription world;
  SceneScoring scoring;
  CorrectDetection directions;  ///< full and empty of the first seed's reference
  std::vector<PlaceRun> runs;   ///< by seed
};

/// Runs a scene over the host's seeds. `sweeps`: with the sweeps of parameter and transversal angle.
[[nodiscard]] Result<PlaceStudy> run_place(const StudyHost& host, StudyProgress& progress, Place place,
                                           std::string_view scene, bool sweeps);

/// Echoes of a log that have an arc, and those whose arc passes through a region.
struct ArcCount {
  std::size_t all = 0;
  std::size_t inside = 0;
};
[[nodiscard]] ArcCount count_arcs(std::span<const Reading> readings, const Box& region);

}  // namespace echoarc::studies::barshan
