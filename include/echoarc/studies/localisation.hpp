// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/nav/global_localisation.hpp"
#include "echoarc/sim/scene.hpp"
#include "echoarc/studies/study_host.hpp"

namespace echoarc::studies {

/// What the robot is told at the beginning.
enum class KnownStart : std::uint8_t {
  pose,     ///< where it stands
  nothing,  ///< it may stand anywhere on the map
  misled,   ///< where it stands; after a while it is carried elsewhere, and nobody tells it
};

/// What it localises itself on.
enum class LocalisationMap : std::uint8_t {
  surfaces,  ///< the world as it is: cells that a surface goes through are occupied
  evidence,  ///< an evidence grid of an earlier drive along the same way, with perfect odometry and another seed
};

/// A robot that goes its scripted way with odometry that drifts, and finds out by its sonars where it is.
struct LocalisationRequest {
  sim::Scene scene;
  KnownStart start = KnownStart::pose;
  LocalisationMap map = LocalisationMap::surfaces;
  double cell_m = 0.05;
  double limit_s = 3600.0;      ///< of driving that is watched
  int laps = 1;                 ///< the way is driven so many times; it should end where it begins
  bool scatter = false;         ///< every seed begins at a leg of its own, drawn from those long enough before the end
  double carry_after_s = 60.0;  ///< when the robot is misled: it is carried away then ...
  double carry_ahead_s = 30.0;  ///< ... to where it would have been so much later
  nav::LocalisationOptions options;
};

/// What the robot believed at one moment, and what was true.
struct LocalisationSample {
  double time_s = 0.0;
  nav::LocalisationState state = nav::LocalisationState::lost;
  Pose2 T_map_believed;
  Pose2 T_map_true;
};

/// A claim is right within 0.5 m and 10 degrees, and a confident wrong one from 1 m or 30 degrees on. Both are asked
/// whenever odometry is heard, and only while the robot says "localised".
struct LocalisationRun {
  std::uint64_t seed = 0;
  double time_s = 0.0;
  double travelled_m = 0.0;
  std::optional<double> found_s;  ///< first right claim since the beginning, or since it was carried away
  std::optional<double> found_m;  ///< the way until then
  int wrong_claims = 0;           ///< how often it came to claim a wrong pose; being carried away begins none
  double wrong_s = 0.0;           ///< for how long in all
  double misled_s = 0.0;          ///< of these right after it was carried away, before it first doubted
  double localised_share = 0.0;   ///< of the time
  double ambiguous_share = 0.0;
  double error_median_m = 0.0;  ///< of what it claimed; NaN where it claimed nothing
  double error_p95_m = 0.0;
  double heading_p95_deg = 0.0;
  double any_error_p95_m = 0.0;   ///< of its best guess after the first right claim, claimed or not; NaN as before
  double odometry_error_m = 0.0;  ///< what odometry alone believed at the end
  std::string last_word;          ///< the estimate's reason at the end
  double step_p99_s = 0.0;        ///< CPU time of one update; 0 without a clock
  double step_max_s = 0.0;
  double cpu_s = 0.0;                       ///< of all updates
  std::vector<LocalisationSample> samples;  ///< every second
};

/// Cells that a surface of the world goes through are occupied, those that the start can be connected to are free, and
/// what lies behind walls is unknown. Frame: that of the world.
[[nodiscard]] DenseGrid<CellState> surface_map(const sim::WorldDescription& world, Vec2 start, double cell_m);

/// One run. The same request and seed give the same run, times of the clock apart. Errors: those of `simulate`; a map
/// out of all proportion. Of the host `cancelled` and `thread_cpu_s` are used.
[[nodiscard]] Result<LocalisationRun> localise(const LocalisationRequest& request, std::uint64_t seed,
                                               const StudyHost& host);

/// Runs with the seeds `first_seed`, `first_seed` + 1, ...: as many as the host says.
[[nodiscard]] Result<std::vector<LocalisationRun>> localise_seeds(const LocalisationRequest& request,
                                                                  const StudyHost& host, std::uint64_t first_seed = 1);

}  // namespace echoarc::studies
