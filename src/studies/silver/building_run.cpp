// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/silver/building_run.hpp"

#include <algorithm>
#include <utility>

#include "echoarc/eval/free_cells.hpp"
#include "echoarc/eval/statistics.hpp"
#include "echoarc/mapping/atm.hpp"
#include "echoarc/mapping/carve.hpp"
#include "echoarc/mapping/centerline.hpp"
#include "echoarc/mapping/combined.hpp"
#include "echoarc/mapping/evidence_grid.hpp"
#include "echoarc/sensing/sensing.hpp"
#include "echoarc/sim/simulate.hpp"
#include "echoarc/studies/local_maps.hpp"
#include "echoarc/studies/scene_reference.hpp"
#include "studies/grid_scores.hpp"
#include "studies/silver/chapters.hpp"
#include "studies/simulated_drive.hpp"

namespace echoarc::studies::silver {
namespace {

constexpr double surface_step_m = 0.05;
constexpr double coarse_cell_m = 0.2;

template <class Options>
Options local_options(double guard_m = 0.0) {
  Options options;
  options.archive = false;
  if constexpr (requires { options.guard_m; }) options.guard_m = guard_m;
  return options;
}

std::vector<AnyMethod> watched_methods() {
  std::vector<AnyMethod> methods;
  methods.emplace_back(AtmSilver(local_options<AtmSilver::Options>()));
  methods.emplace_back(Carve(local_options<CarveOptions>()));
  methods.emplace_back(Combined(local_options<CombinedOptions>()));
  methods.emplace_back(Centerline());
  methods.emplace_back(Carve(local_options<CarveOptions>(inch_m)));
  methods.emplace_back(Combined(local_options<CombinedOptions>(inch_m)));
  return methods;
}

template <class Method>
Method mapped(std::span<const Reading> readings, typename Method::Options options = {}) {
  InlineExecutor executor;
  Method method(std::move(options));
  method.insert(readings, executor);
  method.finish(executor);
  return method;
}

Accuracy accuracy_of(std::span<const Vec2> points, const NearestPoints& surfaces) {
  std::vector<double> distances_m;
  for (const Vec2 point : points) distances_m.push_back(surfaces.distance_m(point));
  const auto near = std::ranges::count_if(distances_m, [](double d) { return d <= 0.10; });
  return {points.size(), median(distances_m), points.empty() ? 0.0 : double(near) / double(points.size())};
}

std::vector<Vec2> centers_of(std::span<const Reading> readings) {
  return positions(mapped<Centerline>(readings).map().points());
}

// The points of Fig. 13b: arcs that carving has made narrow enough.
std::vector<Vec2> carved_of(std::span<const Reading> readings) {
  CarveOptions options;
  options.error_threshold = true;
  return positions(labelled(mapped<Carve>(readings, options).map().points(), {PointLabel::carved}));
}

std::vector<Vec2> medians_of(std::span<const Reading> readings) {
  return positions(labelled(mapped<AtmSilver>(readings).map().points(), {PointLabel::atm}));
}

Stamping study_stamping(std::span<const Reading> readings, std::span<const Vec2> centers,
                        const NearestPoints& surfaces) {
  std::vector<AnyMethod> methods = watched_methods();
  InlineExecutor executor;
  Stamping stamping;
  stamping.arcs = study_arcs(methods, readings, executor);
  stamping.readings = readings.size();
  stamping.centers = accuracy_of(centers, surfaces);
  return stamping;
}

Result<double> mapped_area_m2(std::span<const Reading> readings, const DenseGrid<CellState>& truth) {
  EvidenceGridOptions options;
  options.cell_m = coarse_cell_m;
  const Result<MapExport> map = mapped<EvidenceGrid>(readings, options).export_map();
  if (!map) return map.error();
  const FreeCells cells = count_free_cells(map.value().states, truth);
  return double(cells.true_free) * cells.cell_area_m2;
}

std::vector<Vec2> path_of(const Log& log) {
  std::vector<Vec2> path;
  for (const Odometry& sample : log.truth)
    if (path.empty() || norm(sample.T_world_robot.position - path.back()) > 0.1)
      path.push_back(sample.T_world_robot.position);
  return path;
}

/// Firings are told from registers by how far apart the array fires; to within 5 %, as the default 38 to 42 ms are.
SensingOptions polled_filters(double interval_s) {
  SensingOptions options = paper_filters();
  options.poll_gap_min_s = 0.95 * interval_s;
  options.poll_gap_max_s = 1.05 * interval_s;
  return options;
}

}  // namespace

SensingOptions paper_filters() {
  SensingOptions options;
  options.range_cut_m = 3.81;
  options.jump_filter_m = 0.5;
  return options;
}

Result<BuildingTruth> building_truth(const StudyScene& scene) {
  Result<PointSet> surfaces = PointSet::make(surface_points(scene.scene.world, surface_step_m));
  if (!surfaces) return surfaces.error();
  return BuildingTruth{std::move(*surfaces), scene_truth(scene, coarse_cell_m)};
}

Result<BuildingRun> tour_building(const StudyScene& scene, const BuildingTruth& truth, const NearestPoints& surfaces,
                                  std::uint64_t seed, bool keep) {
  sim::Scene polled = scene.scene;
  polled.polling.polled = true;
  Result<sim::Simulation> simulation = sim::simulate(polled, seed);
  if (!simulation) return simulation.error();
  Log& log = simulation->log;
  const std::vector<Reading> from_polls = sense(log, polled_filters(scene.scene.sonar.interval_s)).readings;
  SensingOptions naively = paper_filters();
  naively.polling = Polling::naive;
  const std::vector<Vec2> naive = centers_of(sense(log, naively).readings);
  log.polls.clear();
  log.pings = std::move(simulation->polled_pings);
  const std::vector<Reading> readings = sense(log, paper_filters()).readings;

  const std::vector<Vec2> centers = centers_of(readings);
  const std::vector<Vec2> polled_centers = centers_of(from_polls);
  const std::vector<Vec2> medians = medians_of(readings);
  const std::vector<Vec2> carved = carved_of(readings);
  BuildingRun run;
  run.stamped = study_stamping(readings, centers, surfaces);
  run.polled = study_stamping(from_polls, polled_centers, surfaces);
  run.naive_centers = accuracy_of(naive, surfaces);
  run.atm = accuracy_of(medians, surfaces);
  run.carved = accuracy_of(carved, surfaces);
  run.path_m = path_length_m(log);
  run.pings = log.pings.size();
  const Result<double> area = mapped_area_m2(readings, truth.states);
  if (!area) return area.error();
  run.mapped_m2 = area.value();
  if (keep) {
    run.stamped_points = centers;
    run.naive_points = naive;
    run.polled_points = polled_centers;
    run.atm_points = medians;
    run.carved_points = carved;
    run.path = path_of(log);
  }
  return run;
}

}  // namespace echoarc::studies::silver
