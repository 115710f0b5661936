// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "echoarc/eval/wall_distance.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sim/simulate.hpp"
#include "echoarc/studies/experiment.hpp"
#include "echoarc/studies/scene_reference.hpp"
#include "studies/sweep_plan.hpp"

namespace echoarc::studies {
namespace {

constexpr std::array metrics{SweepMetric{"mae", "MAE", "m", &SweepScores::mae_m},
                             SweepMetric{"mae_points", "MAE of points", "m", &SweepScores::mae_points_m},
                             SweepMetric{"cdr_full", "CDR_F", "share", &SweepScores::cdr_full},
                             SweepMetric{"cdr_empty", "CDR_E", "share", &SweepScores::cdr_empty},
                             SweepMetric{"cdr_overall", "CDR_O", "share", &SweepScores::cdr_overall},
                             SweepMetric{"within_5cm", "<=5 cm", "share", &SweepScores::within_5cm},
                             SweepMetric{"within_10cm", "<=10 cm", "share", &SweepScores::within_10cm},
                             SweepMetric{"within_20cm", "<=20 cm", "share", &SweepScores::within_20cm},
                             SweepMetric{"coverage", "coverage", "share", &SweepScores::coverage},
                             SweepMetric{"cells", "cells", "", &SweepScores::cells},
                             SweepMetric{"cpu_per_reading", "CPU per reading", "s", &SweepScores::cpu_per_reading_s}};

bool is_whole_plane(const Box& region) {
  return !std::isfinite(region.low.x) || !std::isfinite(region.high.x);
}

/// Without a region there is no grid to share: the method's own, whatever `make_method` of a scoring would set.
void keep_own_grid(MethodSpec& spec) {
  OptionMap own = echoarc::make_method(spec.method).value().options();
  for (const char* option : {"cell_m", "origin_x_m", "origin_y_m"})
    if (const auto found = own.find(option); found != own.end()) spec.options.insert(*found);
}

/// A drive as it was sensed, with where the robot was.
struct SensedDrive {
  Trial trial;
  PointSet path;
};

SweepScores scores_of(const MethodResult& result, const SensedDrive& drive, bool timed) {
  const SceneScorer& scorer = *drive.trial.scorer;
  const WallDistance walls = wall_distance(result.map, scorer.reference(), drive.path).all;
  SweepScores scores{.mae_m = result.cells.mae_m,
                     .mae_points_m = result.points.mae_m,
                     .cdr_full = result.cells.detection.full_ratio(),
                     .cdr_empty = result.cells.detection.empty_ratio(),
                     .cdr_overall = result.cells.detection.overall_ratio(),
                     .within_5cm = walls.accuracy[0],
                     .within_10cm = walls.accuracy[1],
                     .within_20cm = walls.accuracy[2],
                     .coverage = walls.coverage,
                     .cells = double(result.cells.points)};
  if (timed && !drive.trial.readings.empty())
    scores.cpu_per_reading_s = result.cpu_s() / double(drive.trial.readings.size());
  return scores;
}

/// Everything that a sweep works out once, and the rows it fills.
class SweepRun {
 public:
  SweepRun(const SweepRequest& request, const StudyHost& host)
      : request_(request),
        host_(host),
        drives_(request.axes, SweepStage::drive),
        sensings_(request.axes, SweepStage::sensing),
        mappings_(request.axes, SweepStage::mapping),
        seeds_(scene() == nullptr ? 1 : std::size_t(host.seeds)),
        progress_(host, drives_.count() * seeds_ * (1 + sensings_.count() * mappings_.count() * methods())) {}

  Result<SweepResult> run();

 private:
  [[nodiscard]] const StudyScene* scene() const { return std::get_if<StudyScene>(&request_.subject); }
  [[nodiscard]] std::size_t methods() const { return request_.methods.size(); }
  [[nodiscard]] std::vector<std::size_t> places_of(std::size_t drive, std::size_t sensing, std::size_t mapping) const;
  [[nodiscard]] Result<std::vector<Experiment>> experiments_of(std::size_t drive) const;
  [[nodiscard]] Result<std::vector<SensedDrive>> simulate(std::size_t drive, std::uint64_t seed) const;
  [[nodiscard]] Result<std::vector<SensedDrive>> sense_log() const;
  [[nodiscard]] Result<SweepScores> map_one(const SensedDrive& drive, std::size_t task) const;
  [[nodiscard]] MethodSpec spec_of(std::size_t task) const;
  Result<void> map_block(std::size_t first, std::size_t count);
  void lay_out_rows();
  void choose();

  const SweepRequest& request_;
  const StudyHost& host_;
  Combinations drives_;
  Combinations sensings_;
  Combinations mappings_;
  std::size_t seeds_;
  StudyProgress progress_;
  bool limited_ = false;                              // some method wants laser-limited readings
  std::vector<std::vector<Experiment>> experiments_;  // by drive, by sensing
  SweepResult result_;
};

std::vector<std::size_t> SweepRun::places_of(std::size_t drive, std::size_t sensing, std::size_t mapping) const {
  std::vector<std::size_t> places(request_.axes.size());
  drives_.write(drive, places);
  sensings_.write(sensing, places);
  mappings_.write(mapping, places);
  return places;
}

Result<std::vector<Experiment>> SweepRun::experiments_of(std::size_t drive) const {
  std::vector<Experiment> experiments;
  for (std::size_t sensing = 0; sensing < sensings_.count(); ++sensing) {
    const std::vector<std::size_t> places = places_of(drive, sensing, 0);
    Result<StudyScene> changed = scene_of(*scene(), request_.axes, places);
    if (!changed) return changed.error();
    const Result<SensingOptions> options = sensing_of(request_.axes, places);
    if (!options) return options.error();
    Result<Experiment> experiment = Experiment::make(std::move(*changed), *options);
    if (!experiment) return experiment.error();
    experiments.push_back(std::move(*experiment));
  }
  return experiments;
}

Result<SensedDrive> with_path(Result<Trial> trial) {
  if (!trial) return trial.error();
  Result<PointSet> path = PointSet::make(path_positions(trial->log));
  if (!path) return path.error();
  return SensedDrive{std::move(*trial), std::move(*path)};
}

Result<std::vector<SensedDrive>> SweepRun::simulate(std::size_t drive, std::uint64_t seed) const {
  const Result<sim::Simulation> simulation = sim::simulate(experiments_[drive].front().scene().scene, seed);
  if (!simulation) return simulation.error();
  std::vector<SensedDrive> sensed;
  for (const Experiment& experiment : experiments_[drive]) {
    Result<SensedDrive> one = with_path(experiment.trial(seed, simulation->log, limited_));
    if (!one) return one.error();
    sensed.push_back(std::move(*one));
  }
  return sensed;
}

Result<std::vector<SensedDrive>> SweepRun::sense_log() const {
  const auto& judged = std::get<JudgedLog>(request_.subject);
  Result<SceneScorer> scorer = SceneScorer::make(judged.reference, judged.scoring);
  if (!scorer) return scorer.error();
  const auto shared = std::make_shared<const SceneScorer>(std::move(*scorer));
  std::vector<SensedDrive> sensed;
  for (std::size_t sensing = 0; sensing < sensings_.count(); ++sensing) {
    const Result<SensingOptions> options = sensing_of(request_.axes, places_of(0, sensing, 0));
    if (!options) return options.error();
    Trial trial{.log = judged.log, .scorer = shared};
    sense_into(trial, *options, limited_);
    Result<SensedDrive> one = with_path(std::move(trial));
    if (!one) return one.error();
    sensed.push_back(std::move(*one));
  }
  return sensed;
}

/// Tasks are counted by mapping, then by method.
MethodSpec SweepRun::spec_of(std::size_t task) const {
  MethodSpec spec = method_of(request_.methods[task % methods()], request_.axes, places_of(0, 0, task / methods()));
  const auto* judged = std::get_if<JudgedLog>(&request_.subject);
  if (judged != nullptr && is_whole_plane(judged->scoring.region)) keep_own_grid(spec);
  return spec;
}

Result<SweepScores> SweepRun::map_one(const SensedDrive& drive, std::size_t task) const {
  const MethodSpec spec = spec_of(task);
  const Result<std::vector<MethodResult>> results = run_methods(drive.trial, std::span(&spec, 1), host_.thread_cpu_s);
  if (!results) return results.error();
  return scores_of(results->front(), drive, bool(host_.thread_cpu_s));
}

/// A few drives at a time, so that memory does not grow with the sweep. Blocks of (drive, seed), seeds fastest.
Result<void> SweepRun::map_block(std::size_t first, std::size_t count) {
  using Sensed = std::vector<SensedDrive>;
  const Result<std::vector<Sensed>> driven =
      run_tasks<Sensed>(host_, count, progress_, [&](std::size_t k) -> Result<Sensed> {
        const std::size_t drive = (first + k) / seeds_;
        return scene() == nullptr ? sense_log() : simulate(drive, result_.seeds[(first + k) % seeds_]);
      });
  if (!driven) return driven.error();
  const std::size_t per_sensing = mappings_.count() * methods();
  const std::size_t per_drive = sensings_.count() * per_sensing;
  const Result<std::vector<SweepScores>> scores = run_tasks<SweepScores>(
      host_, count * per_drive, progress_,
      [&](std::size_t k) { return map_one((*driven)[k / per_drive][k % per_drive / per_sensing], k % per_sensing); });
  if (!scores) return scores.error();
  const std::size_t rows_per_method = result_.rows.size() / methods();
  for (std::size_t k = 0; k < scores->size(); ++k) {
    const std::size_t driven_as = first + k / per_drive;
    const std::size_t task = k % per_sensing;
    const auto places = places_of(driven_as / seeds_, k % per_drive / per_sensing, task / methods());
    const std::size_t row = task % methods() * rows_per_method + combination_index(request_.axes, places);
    result_.rows[row].runs[driven_as % seeds_] = (*scores)[k];
  }
  return {};
}

void SweepRun::lay_out_rows() {
  result_.axes = request_.axes;
  for (std::size_t k = 0; k < seeds_; ++k) result_.seeds.push_back(scene() == nullptr ? 0 : k + 1);
  const std::size_t combinations = drives_.count() * sensings_.count() * mappings_.count();
  for (const std::string& method : request_.methods)
    for (std::size_t combination = 0; combination < combinations; ++combination) {
      SweepRow row{.method = method, .values = {}, .runs = std::vector<SweepScores>(seeds_)};
      std::size_t rest = combination;
      for (auto axis = request_.axes.rbegin(); axis != request_.axes.rend(); ++axis) {
        row.values.insert(row.values.begin(), axis->values[rest % axis->values.size()]);
        rest /= axis->values.size();
      }
      result_.rows.push_back(std::move(row));
    }
}

void SweepRun::choose() {
  // A parameter is chosen for one world: how the world behaves is no parameter.
  if (drives_.count() > 1) return;
  const std::size_t per_method = result_.rows.size() / methods();
  for (std::size_t method = 0; per_method > 1 && method < methods(); ++method) {
    std::vector<ParameterScore> scores;
    const std::size_t first = method * per_method;
    const auto mean_of = [&](std::size_t row, double SweepScores::* value) {
      return result_.rows[row].spread(*std::ranges::find(metrics, value, &SweepMetric::value)).mean;
    };
    for (std::size_t row = first; row < first + per_method; ++row)
      scores.push_back({mean_of(row, &SweepScores::cdr_full), mean_of(row, &SweepScores::cdr_empty),
                        mean_of(row, &SweepScores::cdr_overall), mean_of(row, &SweepScores::mae_m)});
    const auto choice = choose_parameter(scores);
    if (!choice) continue;
    SweepChoice chosen{.method = request_.methods[method], .best = first + choice->best, .candidates = {}};
    for (const std::size_t candidate : choice->candidates) chosen.candidates.push_back(first + candidate);
    result_.choices.push_back(std::move(chosen));
  }
}

Result<SweepResult> SweepRun::run() {
  for (const std::string& method : request_.methods)
    limited_ = limited_ || echoarc::make_method(method).value().takes_laser_limited();
  for (std::size_t drive = 0; scene() != nullptr && drive < drives_.count(); ++drive) {
    Result<std::vector<Experiment>> made = experiments_of(drive);
    if (!made) return made.error();
    experiments_.push_back(std::move(*made));
  }
  lay_out_rows();
  const std::size_t drives = drives_.count() * seeds_;
  const std::size_t block = std::max<std::size_t>(2 * host_.executor->concurrency(), 1);
  for (std::size_t first = 0; first < drives; first += block)
    if (const Result<void> mapped = map_block(first, std::min(block, drives - first)); !mapped) return mapped.error();
  choose();
  return std::move(result_);
}

}  // namespace

std::span<const SweepMetric> sweep_metrics() {
  return metrics;
}

Spread SweepRow::spread(const SweepMetric& metric) const {
  std::vector<double> measured;
  for (const SweepScores& run : runs) measured.push_back(run.*metric.value);
  return spread_of(measured);
}

Result<SweepResult> run_sweep(const SweepRequest& request, const StudyHost& host) {
  const bool is_log = std::holds_alternative<JudgedLog>(request.subject);
  if (host.seeds < 1) return Error{ErrorCode::bad_value, "the sweep has no seed", "--seeds", "give at least 1"};
  if (const Result<void> checked = check(request, is_log ? 1 : std::size_t(host.seeds)); !checked)
    return checked.error();
  return SweepRun(request, host).run();
}

}  // namespace echoarc::studies
