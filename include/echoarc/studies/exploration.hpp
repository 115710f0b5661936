// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/live/navigator.hpp"
#include "echoarc/nav/strategy.hpp"
#include "echoarc/nav/voronoi_graph.hpp"
#include "echoarc/sim/scene.hpp"
#include "echoarc/studies/experiment.hpp"
#include "echoarc/studies/followed_direction.hpp"
#include "echoarc/studies/reachable_floor.hpp"
#include "echoarc/studies/study_host.hpp"

namespace echoarc::studies {

/// A robot that finds its own way through a scene.
struct ExplorationRequest {
  sim::Scene scene;
  std::string strategy;  ///< for messages
  std::function<std::unique_ptr<nav::Strategy>()> make_strategy;
  live::NavigatorOptions maps;
  std::optional<SceneScoring> scoring;  ///< by which the method's map of the log is judged
  std::vector<Vec2> goals;              ///< places that matter: how near the robot came to each is told
  double limit_s = 3600.0;              ///< simulated; a robot that is still under way then is stopped
  bool keep_log = false;                ///< what the robot said, for maps and scores; a building's is large
};

/// How far it was at one moment.
struct CoverageSample {
  double time_s = 0.0;
  double travelled_m = 0.0;
  double covered = 0.0;  ///< share of the floor that the robot can get to, see `ReachableFloor`
};

struct ExplorationRun {
  std::uint64_t seed = 0;
  nav::Status status = nav::Status::running;  ///< running: the time was over
  std::string reason;
  double time_s = 0.0;
  double travelled_m = 0.0;
  std::uint64_t collisions = 0;               ///< how often the bumper held the robot
  double least_clearance_m = 0.0;             ///< of the hull from what stands still, over the whole way
  std::vector<CoverageSample> coverage;       ///< every 10 s, and the end
  std::vector<double> goal_distance_m;        ///< how near the robot's centre came to each goal
  DenseGrid<CellState> map;                   ///< that plans were made on, at the end
  std::optional<DirectionScores> directions;  ///< where a wall was followed and the scoring has walls
  std::optional<MapScore> score;              ///< of the method's points over all that was heard
  std::optional<nav::VoronoiGraph> graph;     ///< of a strategy that makes one
  nav::Sketch sketch;                         ///< what the strategy had in mind at the end
  Log log;                                    ///< with truth; empty unless it was asked for
  double steering_p99_s = 0.0;  ///< CPU time of the strategy's step: avoidance and planning; 0 without a clock
  double cpu_s = 0.0;
};

/// One run. The same request and seed give the same run, times of the clock apart. Errors: those of
/// `SimulatedSource::make` and `Navigator::make`; interrupted. Of the host `cancelled` and `thread_cpu_s` are used.
[[nodiscard]] Result<ExplorationRun> explore(const ExplorationRequest& request, const ReachableFloor& floor,
                                             std::uint64_t seed, const StudyHost& host);

/// Runs with the seeds 1, 2, ... of the host.
[[nodiscard]] Result<std::vector<ExplorationRun>> explore_seeds(const ExplorationRequest& request,
                                                                const StudyHost& host);

}  // namespace echoarc::studies
