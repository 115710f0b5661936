// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/barshan/place_runs.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "echoarc/core/arc.hpp"
#include "echoarc/studies/scene_reference.hpp"
#include "studies/barshan/level_map.hpp"

namespace echoarc::studies::barshan {
namespace {

// Arcs are looked at every so far.
constexpr double arc_step_m = 0.01;

std::vector<double> range(double first, double last, double step) {
  std::vector<double> values;
  for (int k = 0; first + k * step <= last + 0.5 * step; ++k) values.push_back(first + k * step);
  return values;
}

/// 0.990, 0.991, ... 0.999, and "1.000": what rounds to it.
std::vector<double> probabilities() {
  std::vector<double> values;
  for (int k = 990; k <= 999; ++k) values.push_back(double(k) / 1000.0);
  values.push_back(0.9995);
  return values;
}

bool passes_through(const Arc& arc, const Box& region) {
  const double from = arc.t_begin().rad();
  const double to = arc.t_end().rad();
  const double steps = std::max(1.0, std::ceil((to - from) * arc.range_m() / arc_step_m));
  for (double k = 0.0; k <= steps; k += 1.0) {
    const Vec2 p = arc.point_at(radians(from + (to - from) * k / steps));
    if (p.x >= region.low.x && p.x < region.high.x && p.y >= region.low.y && p.y < region.high.y) return true;
  }
  return false;
}

std::vector<MethodSpec> angle_specs(Technique technique, Place place) {
  std::vector<MethodSpec> specs;
  for (int degree = 0; degree < angle_count; ++degree) specs.push_back(spec_of(technique, place, degree));
  return specs;
}

Result<std::vector<MapScore>> angle_scores(const Trial& trial, Technique technique, Place place) {
  const Result<std::vector<MethodResult>> results = run_methods(trial, angle_specs(technique, place));
  if (!results) return results.error();
  std::vector<MapScore> scores;
  for (const MethodResult& result : *results) scores.push_back(result.cells);
  return scores;
}

OptionMap fixed_options(const SweepPlan& plan, Place place) {
  OptionMap options = spec_of(plan.technique, place, plan.values.front()).options;
  for (const std::string_view parameter : {"threshold", "neighbours"})
    if (const auto found = options.find(parameter); found != options.end()) options.erase(found);
  if (plan.technique == Technique::tbf) {
    options["show"] = std::string(plan.edges ? "edges" : "all");
    options["columns"] = std::int64_t{plan.columns};
  }
  return options;
}

Result<void> add_sweeps(PlaceRun& run, const Trial& trial, Place place) {
  for (const SweepPlan& plan : sweep_plans()) {
    const Result<LevelMap> map = level_map(trial, plan.technique, fixed_options(plan, place));
    if (!map) return map.error();
    run.sweeps.push_back(scores_at(*map, *trial.scorer, plan.values));
  }
  Result<std::vector<MapScore>> org = angle_scores(trial, Technique::atm_org, place);
  if (!org) return org.error();
  run.atm_org = std::move(*org);
  Result<std::vector<MapScore>> mod = angle_scores(trial, Technique::atm_mod, place);
  if (!mod) return mod.error();
  run.atm_mod = std::move(*mod);
  return {};
}

std::vector<MethodSpec> printed_specs(Place place) {
  std::vector<MethodSpec> specs;
  for (const PrintedRow& row : printed_rows(place)) specs.push_back(spec_of(row.technique, place, row.parameter));
  return specs;
}

/// The cells of the arc map, for a picture.
Result<std::vector<Vec2>> vote_cells(const Trial& trial) {
  const Result<LevelMap> map = level_map(trial, Technique::vt, {});
  if (!map) return map.error();
  std::vector<Vec2> cells;
  for (const LevelMap::LeveledCell& cell : map->cells) cells.push_back(cell.centre);
  return cells;
}

Result<PlaceRun> run_seed(const StudyHost& host, const Experiment& experiment, Place place, std::uint64_t seed,
                          bool sweeps) {
  const Result<Trial> trial = experiment.trial(seed);
  if (!trial) return trial.error();
  PlaceRun run;
  const ArcCount arcs = count_arcs(trial->readings, trial->scoring().region);
  run.arcs = double(arcs.all);
  run.arcs_in_region = double(arcs.inside);
  Result<std::vector<MethodResult>> printed = run_methods(*trial, printed_specs(place), host.thread_cpu_s);
  if (!printed) return printed.error();
  run.printed = std::move(*printed);
  if (sweeps)
    if (const Result<void> done = add_sweeps(run, *trial, place); !done) return done.error();
  if (seed == 1) {
    Result<std::vector<Vec2>> votes = vote_cells(*trial);
    if (!votes) return votes.error();
    run.votes = std::move(*votes);
    run.path = path_positions(trial->log);
  } else {
    for (MethodResult& result : run.printed) result.map = {};
  }
  return run;
}

}  // namespace

std::vector<SweepPlan> sweep_plans() {
  using T = Technique;
  return {{"T2-vt", "room (a)", T::vt, false, 20, range(1, 10, 1)},
          {"T2-dm", "room (a)", T::dm, false, 20, range(1, 10, 1)},
          {"T3-mp", "curved surface", T::mp, false, 20, range(0, 8, 1)},
          {"T4-bu", "curved surface", T::bu, false, 20, probabilities()},
          {"T5-tbf", "room (a)", T::tbf, false, 20, range(1, 8, 1)},
          {"T5-tbf-10", "room (a)", T::tbf, false, 10, range(1, 8, 1)},
          {"T6-tbf", "room (a)", T::tbf, true, 20, range(1, 8, 1)},
          {"T6-tbf-10", "room (a)", T::tbf, true, 10, range(1, 8, 1)}};
}

std::size_t sweep_index(std::string_view id) {
  const std::vector<SweepPlan> plans = sweep_plans();
  const auto found = std::ranges::find(plans, id, &SweepPlan::id);
  assert(found != plans.end());
  return std::size_t(found - plans.begin());
}

ArcCount count_arcs(std::span<const Reading> readings, const Box& region) {
  ArcCount count;
  for (const Reading& reading : readings) {
    const std::optional<Arc> arc = arc_of(reading);
    if (!arc) continue;
    ++count.all;
    if (passes_through(*arc, region)) ++count.inside;
  }
  return count;
}

Result<PlaceStudy> run_place(const StudyHost& host, StudyProgress& progress, Place place, std::string_view scene,
                             bool sweeps) {
  Result<StudyScene> loaded = host.scene(scene);
  if (!loaded) return loaded.error();
  const Result<Experiment> experiment = Experiment::make(std::move(*loaded));
  if (!experiment) return experiment.error();
  PlaceStudy study;
  study.place = place;
  study.world = experiment->scene().scene.world;
  study.scoring = experiment->scene().scoring;
  Result<std::vector<PlaceRun>> runs = run_tasks<PlaceRun>(host, std::size_t(host.seeds), progress, [&](std::size_t k) {
    return run_seed(host, *experiment, place, std::uint64_t(k) + 1, sweeps);
  });
  if (!runs) return runs.error();
  study.runs = std::move(*runs);
  study.directions = study.runs.front().printed.front().cells.detection;
  return study;
}

}  // namespace echoarc::studies::barshan
