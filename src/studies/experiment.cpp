// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/experiment.hpp"

#include <limits>
#include <mutex>
#include <utility>

#include "echoarc/sensing/sensing.hpp"
#include "echoarc/sim/simulate.hpp"
#include "echoarc/studies/scene_reference.hpp"

namespace echoarc::studies {
namespace {

/// The exact points of a method that has them; none for grids.
Result<std::optional<PointSet>> exact_points(const MapExport& map) {
  const std::span<const MapPoint> points = map.points.points();
  if (points.empty() || points.front().label == PointLabel::cell) return std::optional<PointSet>{};
  Result<PointSet> set = PointSet::of_points(map.points);
  if (!set) return set.error();
  return std::optional{std::move(*set)};
}

Result<MethodResult> judge(const AnyMethod& method, const SceneScorer& scorer) {
  const Result<MapExport> map = method.export_map();
  if (!map) return map.error();
  const Result<PointSet> cells = PointSet::of_occupied(map->states);
  if (!cells) return cells.error();
  const Result<std::optional<PointSet>> points = exact_points(*map);
  if (!points) return points.error();
  MethodResult result;
  result.map = scorer.judged(*cells);
  result.cells = scorer.score(result.map);
  result.points = *points ? scorer.score(**points) : result.cells;
  result.counters = method.counters();
  return result;
}

}  // namespace

void sense_into(Trial& trial, const SensingOptions& options, bool with_laser_limited) {
  Sensing sensing = sensing_for(trial.log, options, with_laser_limited);
  for (const Ping& ping : trial.log.pings) sensing.push(ping);
  if (trial.log.pings.empty())
    for (const Poll& poll : trial.log.polls) sensing.push(poll);
  sensing.end_of_polls();
  sensing.end_of_odometry();
  trial.readings.assign(sensing.readings().begin(), sensing.readings().end());
  if (with_laser_limited) trial.limited.assign(sensing.limited_readings().begin(), sensing.limited_readings().end());
  trial.sensing = sensing.report();
}

Result<SceneScorer> SceneScorer::make(Reference reference, const SceneScoring& scoring) {
  DirectionSet directions = scene_directions(scoring);
  if (const Result<void> valid = validate(directions); !valid) return valid.error();
  return SceneScorer(std::make_shared<const Reference>(std::move(reference)), std::move(directions), scoring);
}

bool SceneScorer::inside(Vec2 p) const {
  const Box& region = scoring_.region;
  return p.x >= region.low.x && p.x < region.high.x && p.y >= region.low.y && p.y < region.high.y;
}

CorrectDetection SceneScorer::detection(const PointSet& map) const {
  return correct_detection(map, *reference_, directions_).value();  // checked by `make`
}

PointSet SceneScorer::judged(const PointSet& map) const {
  std::vector<Vec2> kept;
  for (const Vec2 p : map.points())
    if (inside(p)) kept.push_back(p);
  // Part of a set that is valid.
  return map.cell_m() > 0.0 ? PointSet::of_cells(std::move(kept), map.cell_m()).value()
                            : PointSet::make(std::move(kept)).value();
}

MapScore SceneScorer::score(const PointSet& map) const {
  const PointSet inside_map = judged(map);
  MapScore score;
  score.points = inside_map.size();
  double sum_m = 0.0;
  for (const Vec2 p : inside_map.points()) sum_m += nearest_.distance_m(p);
  score.mae_m = inside_map.empty() ? std::numeric_limits<double>::quiet_NaN() : sum_m / double(inside_map.size());
  score.detection = detection(inside_map);
  return score;
}

/// The scorer of a scene whose reference is the truth: the drive does not depend on the seed.
struct Experiment::SharedTruth {
  std::mutex mutex;
  std::shared_ptr<const SceneScorer> scorer;
};

Experiment::Experiment(StudyScene scene, SensingOptions sensing, std::shared_ptr<const sim::World> world)
    : scene_(std::move(scene)), sensing_(sensing), world_(std::move(world)), truth_(std::make_shared<SharedTruth>()) {}

Result<Experiment> Experiment::make(StudyScene scene, SensingOptions sensing) {
  const Box& region = scene.scoring.region;
  if (!(region.low.x < region.high.x && region.low.y < region.high.y))
    return Error{ErrorCode::bad_value, "the scene has no judged region", scene.scene.name,
                 "give [scoring] region a width and a height"};
  Result<sim::World> world = sim::World::make(scene.scene.world);
  if (!world) return world.error();
  return Experiment(std::move(scene), sensing, std::make_shared<const sim::World>(std::move(*world)));
}

Result<std::shared_ptr<const SceneScorer>> Experiment::scorer_for(const Log& log) const {
  const auto make = [&]() -> Result<std::shared_ptr<const SceneScorer>> {
    Result<Reference> reference = scene_reference(*world_, log, scene_.scoring);
    if (!reference) return reference.error();
    Result<SceneScorer> scorer = SceneScorer::make(std::move(*reference), scene_.scoring);
    if (!scorer) return scorer.error();
    return std::make_shared<const SceneScorer>(std::move(*scorer));
  };
  if (scene_.scoring.reference == ReferenceSource::structured_light) return make();
  const std::lock_guard lock(truth_->mutex);
  if (truth_->scorer == nullptr) {
    Result<std::shared_ptr<const SceneScorer>> scorer = make();
    if (!scorer) return scorer.error();
    truth_->scorer = std::move(*scorer);
  }
  return truth_->scorer;
}

Result<Trial> Experiment::trial(std::uint64_t seed, bool with_laser_limited) const {
  Result<sim::Simulation> run = sim::simulate(scene_.scene, seed);
  if (!run) return run.error();
  return trial(seed, std::move(run->log), with_laser_limited);
}

Result<Trial> Experiment::trial(std::uint64_t seed, Log log, bool with_laser_limited) const {
  Trial trial;
  trial.seed = seed;
  trial.log = std::move(log);
  sense_into(trial, sensing_, with_laser_limited);
  Result<std::shared_ptr<const SceneScorer>> scorer = scorer_for(trial.log);
  if (!scorer) return scorer.error();
  trial.scorer = std::move(*scorer);
  return trial;
}

OptionMap grid_of(const SceneScoring& scoring) {
  return {{"cell_m", scoring.cell_m}, {"origin_x_m", scoring.region.low.x}, {"origin_y_m", scoring.region.low.y}};
}

Result<AnyMethod> make_method(const MethodSpec& spec, const SceneScoring& scoring) {
  OptionMap options = spec.options;
  const OptionMap grid = grid_of(scoring);
  options.insert(grid.begin(), grid.end());  // what the spec names stays
  return echoarc::make_method(spec.method, options);
}

Result<std::vector<MethodResult>> run_methods(const Trial& trial, std::span<const MethodSpec> specs,
                                              const std::function<double()>& thread_cpu_s) {
  const auto now = [&] { return thread_cpu_s ? thread_cpu_s() : 0.0; };
  InlineExecutor executor;
  std::vector<MethodResult> results;
  for (const MethodSpec& spec : specs) {
    Result<AnyMethod> method = make_method(spec, trial.scoring());
    if (!method) return method.error();
    const bool limited = method->takes_laser_limited() && !trial.limited.empty();
    const double begin_s = now();
    method->insert(limited ? trial.limited : trial.readings, executor);
    const double inserted_s = now();
    method->finish(executor);
    const double finished_s = now();
    Result<MethodResult> result = judge(*method, *trial.scorer);
    if (!result) return result.error();
    result->insert_cpu_s = inserted_s - begin_s;
    result->finish_cpu_s = finished_s - inserted_s;
    results.push_back(std::move(*result));
  }
  return results;
}

}  // namespace echoarc::studies
