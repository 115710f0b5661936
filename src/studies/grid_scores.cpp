// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/grid_scores.hpp"

#include <cmath>
#include <utility>

#include "echoarc/pipeline/pipeline.hpp"
#include "echoarc/sim/simulate.hpp"
#include "echoarc/studies/scene_reference.hpp"

namespace echoarc::studies {

DenseGrid<CellState> scene_truth(const StudyScene& scene, double cell_m) {
  const GridGeometry whole{cell_m, {}};
  const CellBox box = whole.cells_of(scene.scoring.region);
  const GridGeometry geometry{cell_m, whole.corner({box.i_begin, box.j_begin})};
  const std::vector<Vec2> surfaces = surface_points(scene.scene.world, 0.25 * cell_m);
  return true_states(surfaces, geometry, std::int32_t(box.width()), std::int32_t(box.height()),
                     scene.scene.drive.start.position);
}

Result<std::vector<GridScore>> score_grids(const StudyScene& scene, std::uint64_t seed, std::vector<AnyMethod> methods,
                                           const DenseGrid<CellState>& truth, bool keep_states,
                                           const SensingOptions& sensing) {
  Result<sim::Simulation> simulation = sim::simulate(scene.scene, seed);
  if (!simulation) return simulation.error();
  InlineExecutor executor;
  static_cast<void>(run_log(simulation->log, sensing, methods, executor));  // the maps are in the methods
  std::vector<GridScore> scores;
  for (const AnyMethod& method : methods) {
    Result<MapExport> map = method.export_map();
    if (!map) return map.error();
    GridScore score{count_free_cells(map->states, truth), {}};
    if (keep_states) score.states = std::move(map->states);
    scores.push_back(std::move(score));
  }
  return scores;
}

Image grid_picture(const StudyScene& scene, const DenseGrid<CellState>& states) {
  MapPicture picture(scene.scoring.region, 480);
  picture.add_cells(states);
  picture.add_surfaces(scene.scene.world, {213, 94, 0}, 2);
  return picture.image();
}

}  // namespace echoarc::studies
