// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include "echoarc/sim/simulate.hpp"
#include "echoarc/studies/comparison.hpp"
#include "echoarc/studies/scene_reference.hpp"
#include "studies/chart_axis.hpp"
#include "studies/comparison/judge.hpp"

namespace echoarc::studies {
namespace {

using comparison::JudgedRun;
using comparison::Yardstick;

// Reference points every 2 mm, looked at from every 2 cm of the path; on drives of hours fewer will do.
constexpr double surface_step_m = 0.002;
constexpr double eye_step_m = 0.02;
constexpr double long_drive_s = 1800.0;
constexpr double long_surface_step_m = 0.01;
constexpr double long_eye_step_m = 0.25;

/// The scenes of [Barshan07] whose pixel scores are compared.
struct PixelScene {
  std::string_view scene;
  std::string_view experiment;
};
constexpr std::array<PixelScene, 3> pixel_scenes{{{"curve", "E1"}, {"room-a", "E3"}, {"room-c", "E4"}}};

/// A place made ready: what does not depend on the seed.
struct Site {
  ComparedPlace place;
  const Log* log = nullptr;  ///< recorded
  std::shared_ptr<const Log> cut;
  std::optional<StudyScene> scene;
  std::shared_ptr<const Experiment> experiment;  ///< of scenes with pixel scores
  std::shared_ptr<const Yardstick> yardstick;
  int seeds = 1;
};

Result<Yardstick> laser_yardstick(const Log& log) {
  Result<Reference> reference = laser_reference(log);
  if (!reference) return reference.error();
  Result<PointSet> path = comparison::odometry_path(log);
  if (!path) return path.error();
  return Yardstick{std::move(*reference), std::move(*path), std::nullopt};
}

double length_s(const Log& log) {
  return log.odometry.empty() ? 0.0 : log.odometry.back().time_s - log.odometry.front().time_s;
}

/// All surfaces that the robot could see on its way, wherever the scene's own scoring looks.
Result<Yardstick> truth_yardstick(const StudyScene& scene, const Log& log) {
  const Result<sim::World> world = sim::World::make(scene.scene.world);
  if (!world) return world.error();
  const bool is_long = length_s(log) > long_drive_s;
  const double step_m = is_long ? long_surface_step_m : surface_step_m;
  const std::vector<Vec2> eyes = path_positions(log, is_long ? long_eye_step_m : eye_step_m);
  Result<PointSet> visible = PointSet::make(visible_points(*world, surface_points(world->description(), step_m), eyes));
  if (!visible) return visible.error();
  if (visible->empty())
    return Error{ErrorCode::bad_value, "nothing is visible from the robot's path", scene.scene.name,
                 "check the drive of the scene"};
  Result<PointSet> path = PointSet::make(path_positions(log, 0.0));
  if (!path) return path.error();
  return Yardstick{
      {std::move(*visible), surface_step_m, "surfaces visible from the path"}, std::move(*path), std::nullopt};
}

Result<std::vector<Site>> log_sites(const ComparedLog& recorded) {
  Result<Yardstick> whole = laser_yardstick(recorded.log);
  if (!whole) return whole.error();
  std::vector<Site> sites(1);
  const double seconds = length_s(recorded.log);
  sites.front().log = &recorded.log;
  sites.front().place.name = recorded.name;
  sites.front().place.seconds = seconds;
  sites.front().yardstick = std::make_shared<const Yardstick>(*whole);
  for (const double cut_s : truncations_s) {
    if (cut_s >= seconds) continue;
    Site site;
    site.cut = std::make_shared<const Log>(first_seconds(recorded.log, cut_s));
    site.log = site.cut.get();
    Result<Yardstick> yardstick = laser_yardstick(*site.cut);
    if (!yardstick) continue;  // a laser that was silent for so long
    yardstick->whole = whole->reference;
    site.place.kind = PlaceKind::truncated;
    site.place.name = recorded.name + ", first " + fixed(cut_s, 0) + " s";
    site.place.seconds = cut_s;
    site.yardstick = std::make_shared<const Yardstick>(std::move(*yardstick));
    sites.push_back(std::move(site));
  }
  return sites;
}

Result<Site> scene_site(const StudyHost& host, const std::string& name, StudyScene scene) {
  Site site;
  site.place.name = name;
  site.place.kind = PlaceKind::scene;
  const Result<sim::Simulation> first = sim::simulate(scene.scene, 1);
  if (!first) return first.error();
  site.place.seconds = length_s(first->log);
  site.seeds = site.place.seconds > long_drive_s ? 1 : host.seeds;
  Result<Yardstick> yardstick = truth_yardstick(scene, first->log);
  if (!yardstick) return yardstick.error();
  site.yardstick = std::make_shared<const Yardstick>(std::move(*yardstick));
  const auto pixels = std::ranges::find(pixel_scenes, name, &PixelScene::scene);
  if (pixels != pixel_scenes.end()) {
    site.place.experiment = std::string(pixels->experiment);
    Result<Experiment> experiment = Experiment::make(scene);
    if (!experiment) return experiment.error();
    site.experiment = std::make_shared<const Experiment>(std::move(*experiment));
  }
  site.scene = std::move(scene);
  return site;
}

/// Of a scene with pixel scores: what its own scoring holds a log against.
Result<std::shared_ptr<const SceneScorer>> pixel_scorer(const Site& site, std::uint64_t seed, const Log& log) {
  if (!site.experiment) return std::shared_ptr<const SceneScorer>{};
  const Result<Trial> trial = site.experiment->trial(seed, log);
  if (!trial) return trial.error();
  return trial->scorer;
}

struct SeedRun {
  std::vector<ComparedMap> maps;
  std::optional<PictureFigure> picture;
};

Result<SeedRun> run_site(const Site& site, std::uint64_t seed, std::span<const ComparedMethod> methods) {
  std::optional<sim::Simulation> simulated;
  if (site.scene) {
    Result<sim::Simulation> run = sim::simulate(site.scene->scene, seed);
    if (!run) return run.error();
    simulated = std::move(*run);
  }
  const Log& log = simulated ? simulated->log : *site.log;
  const bool drawn = seed == 1 && site.place.kind != PlaceKind::truncated;
  const Result<std::shared_ptr<const SceneScorer>> scorer = pixel_scorer(site, seed, log);
  if (!scorer) return scorer.error();
  Result<JudgedRun> judged = comparison::judge_run(log, *site.yardstick, methods, scorer->get(), drawn);
  if (!judged) return judged.error();
  SeedRun run{std::move(judged->maps), std::nullopt};
  if (drawn) run.picture = comparison::picture_of(site.place.name, *site.yardstick, methods, judged->points);
  return run;
}

Result<std::vector<Site>> prepare(const StudyHost& host, const ComparisonRequest& request, StudyProgress& progress) {
  std::vector<Site> sites;
  for (const ComparedLog& log : request.logs) {
    Result<std::vector<Site>> of_log = log_sites(log);
    if (!of_log) return of_log.error();
    std::ranges::move(*of_log, std::back_inserter(sites));
    progress.step();
  }
  std::vector<StudyScene> scenes;  // the host hands them out to one thread
  for (const std::string& name : request.scenes) {
    Result<StudyScene> scene = host.scene(name);
    if (!scene) return scene.error();
    scenes.push_back(std::move(*scene));
  }
  Result<std::vector<Site>> of_scenes = run_tasks<Site>(host, scenes.size(), progress, [&](std::size_t k) {
    return scene_site(host, request.scenes[k], std::move(scenes[k]));
  });
  if (!of_scenes) return of_scenes.error();
  std::ranges::move(*of_scenes, std::back_inserter(sites));
  return sites;
}

template <class Record>
void keep_until(std::vector<Record>& records, double end_s) {
  std::erase_if(records, [&](const Record& record) { return !(record.time_s < end_s); });
}

}  // namespace

Log first_seconds(const Log& log, double seconds) {
  Log cut = log;
  const double end_s = (log.odometry.empty() ? 0.0 : log.odometry.front().time_s) + seconds;
  keep_until(cut.odometry, end_s);
  keep_until(cut.pings, end_s);
  keep_until(cut.scans, end_s);
  keep_until(cut.polls, end_s);
  keep_until(cut.truth, end_s);
  keep_until(cut.walls, end_s);
  return cut;
}

Result<Comparison> compare_methods(const StudyHost& host, const ComparisonRequest& request) {
  // How many pieces a log is cut into is not known yet: each counts as whole and every cut.
  const std::size_t log_tasks = request.logs.size() * (2 + truncations_s.size());
  StudyProgress progress(host, log_tasks + request.scenes.size() * std::size_t(1 + host.seeds));
  Result<std::vector<Site>> sites = prepare(host, request, progress);
  if (!sites) return sites.error();
  struct Task {
    std::size_t site = 0;
    std::uint64_t seed = 1;
  };
  std::vector<Task> tasks;
  for (std::size_t s = 0; s < sites->size(); ++s)
    for (int seed = 1; seed <= (*sites)[s].seeds; ++seed) tasks.push_back({s, std::uint64_t(seed)});
  Result<std::vector<SeedRun>> runs = run_tasks<SeedRun>(host, tasks.size(), progress, [&](std::size_t k) {
    return run_site((*sites)[tasks[k].site], tasks[k].seed, request.methods);
  });
  if (!runs) return runs.error();
  Comparison comparison{.seeds = host.seeds, .methods = request.methods, .places = {}};
  for (Site& site : *sites) {
    site.place.provenance = site.yardstick->reference.provenance;
    site.place.maps.resize(request.methods.size());
    comparison.places.push_back(std::move(site.place));
  }
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    ComparedPlace& place = comparison.places[tasks[k].site];
    SeedRun& run = (*runs)[k];
    for (std::size_t m = 0; m < run.maps.size(); ++m) place.maps[m].push_back(std::move(run.maps[m]));
    if (run.picture) place.picture = std::move(run.picture);
  }
  return comparison;
}

}  // namespace echoarc::studies
