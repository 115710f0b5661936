// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/comparison/judge.hpp"

#include <utility>

#include "echoarc/eval/nearest_points.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::studies::comparison {
namespace {

/// The readings of a log, sensed once for every range cut that the methods ask for.
class SensedOnce {
 public:
  SensedOnce(const Log& log, bool with_laser_limited) : log_(&log), with_laser_limited_(with_laser_limited) {}

  const Trial& with_cut(double range_cut_m) {
    for (const auto& [cut_m, trial] : sensed_)
      if (cut_m == range_cut_m) return *trial;
    auto trial = std::make_unique<Trial>();
    trial->log = *log_;
    SensingOptions options;
    options.range_cut_m = range_cut_m;
    sense_into(*trial, options, with_laser_limited_);
    trial->log = {};
    sensed_.emplace_back(range_cut_m, std::move(trial));
    return *sensed_.back().second;
  }

 private:
  const Log* log_;
  bool with_laser_limited_;
  std::vector<std::pair<double, std::unique_ptr<Trial>>> sensed_;
};

/// What scores look at: the points of a method that has them, else the centres of its occupied cells.
Result<PointSet> scored_points(const MapExport& map) {
  const std::span<const MapPoint> points = map.points.points();
  const bool is_grid = points.empty() || points.front().label == PointLabel::cell;
  return is_grid ? PointSet::of_occupied(map.states) : PointSet::of_points(map.points);
}

Result<MapExport> map_of(const ComparedMethod& compared, const OptionMap& grid, SensedOnce& sensed) {
  OptionMap options = compared.options;
  options.insert(grid.begin(), grid.end());
  Result<AnyMethod> method = echoarc::make_method(compared.method, options);
  if (!method) return method.error();
  const Trial& trial = sensed.with_cut(compared.range_cut_m);
  const bool limited = method->takes_laser_limited() && !trial.limited.empty();
  InlineExecutor executor;
  method->insert(limited ? trial.limited : trial.readings, executor);
  method->finish(executor);
  return method->export_map();
}

}  // namespace

Result<PointSet> odometry_path(const Log& log) {
  std::vector<Vec2> path;
  path.reserve(log.odometry.size());
  for (const Odometry& sample : log.odometry) path.push_back(sample.T_world_robot.position);
  return PointSet::make(std::move(path));
}

Result<JudgedRun> judge_run(const Log& log, const Yardstick& yardstick, std::span<const ComparedMethod> methods,
                            const SceneScorer* scorer, bool keep_points) {
  SensedOnce sensed(log, !log.scans.empty());
  const NearestPoints nearest(yardstick.reference.points);
  const OptionMap grid = scorer == nullptr ? OptionMap{} : grid_of(scorer->scoring());
  JudgedRun run;
  for (const ComparedMethod& compared : methods) {
    const Result<MapExport> map = map_of(compared, grid, sensed);
    if (!map) return map.error();
    Result<PointSet> points = scored_points(*map);
    if (!points) return points.error();
    Result<std::vector<ClaimedPoint>> claims = claimed_points(map->points, nearest, WallDistanceOptions{}.thin_cell_m);
    if (!claims) return claims.error();
    ComparedMap judged;
    judged.distance = wall_distance(*points, yardstick.reference, yardstick.path);
    if (yardstick.whole) judged.against_whole = wall_distance(*points, *yardstick.whole, yardstick.path);
    judged.claims = std::move(*claims);
    if (scorer != nullptr) {
      const Result<PointSet> pixels = PointSet::of_occupied(map->states);
      if (!pixels) return pixels.error();
      judged.pixels = scorer->score(*pixels);
    }
    run.maps.push_back(std::move(judged));
    if (keep_points) run.points.push_back(std::move(*points));
  }
  return run;
}

}  // namespace echoarc::studies::comparison
