// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "studies/barshan/level_map.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "echoarc/mapping/bayes_update.hpp"

namespace echoarc::studies::barshan {
namespace {

using Levels = std::vector<LevelMap::LeveledCell>;

Result<MapExport> export_of(const Trial& trial, const MethodSpec& spec) {
  Result<AnyMethod> method = make_method(spec, trial.scoring());
  if (!method) return method.error();
  InlineExecutor executor;
  method->insert(trial.readings, executor);
  method->finish(executor);
  return method->export_map();
}

MethodSpec spec_with(std::string method, OptionMap options, std::string parameter, std::int64_t value) {
  options[std::move(parameter)] = value;
  return {"", std::move(method), std::move(options)};
}

template <class Level>
Levels occupied_cells(const DenseGrid<CellState>& states, const Level& level) {
  Levels cells;
  for (std::int32_t j = 0; j < states.height(); ++j)
    for (std::int32_t i = 0; i < states.width(); ++i)
      if (states.at({i, j}) == CellState::occupied)
        cells.push_back({states.geometry().centre({i, j}), double(level(Cell{i, j}))});
  return cells;
}

Result<Levels> vote_levels(const Trial& trial, std::string method, const OptionMap& options) {
  const Result<MapExport> map = export_of(trial, spec_with(std::move(method), options, "threshold", 1));
  if (!map) return map.error();
  const auto& votes = std::get<DenseGrid<std::uint16_t>>(map->values);
  return occupied_cells(map->states, [&](Cell cell) { return votes.at(cell); });
}

Result<Levels> neighbour_levels(const Trial& trial, const OptionMap& options) {
  const Result<MapExport> map = export_of(trial, spec_with("mp", options, "neighbours", 0));
  if (!map) return map.error();
  const DenseGrid<CellState>& states = map->states;
  return occupied_cells(states, [&](Cell cell) {
    int count = 0;
    for (const Cell offset : {Cell{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}) {
      const Cell other{cell.i + offset.i, cell.j + offset.j};
      if (states.box().contains(other) && states.at(other) == CellState::occupied) ++count;
    }
    return count;
  });
}

Result<Levels> probability_levels(const Trial& trial, OptionMap options) {
  const OptionMap grid = grid_of(trial.scoring());
  options.insert(grid.begin(), grid.end());
  const Result<BayesUpdateOptions> checked = make_options<BayesUpdateOptions>(options);
  if (!checked) return checked.error();
  BayesUpdate method(*checked);
  InlineExecutor executor;
  method.insert(trial.readings, executor);
  Levels cells;
  method.map().for_each_nonzero([&](Cell cell, const BayesCell& evidence) {
    const double p = bayes_value(evidence, checked->combination);
    if (p > 0.5) cells.push_back({method.map().geometry().centre(cell), p});
  });
  return cells;
}

Result<Levels> triangulation_levels(const Trial& trial, const OptionMap& options) {
  const Result<MapExport> map = export_of(trial, spec_with("tbf", options, "threshold", 1));
  if (!map) return map.error();
  const GridGeometry geometry{trial.scoring().cell_m, trial.scoring().region.low};
  std::map<Cell, double> most;
  for (const MapPoint& point : map->points.points()) {
    // Its own ping stands in front of the older ones.
    double& level = most[geometry.cell_of(point.position)];
    level = std::max(level, double(point.support_count) - 1.0);
  }
  Levels cells;
  for (const auto& [cell, level] : most) cells.push_back({geometry.centre(cell), level});
  return cells;
}

Result<Levels> levels_of(const Trial& trial, Technique technique, const OptionMap& options) {
  switch (technique) {
    case Technique::vt: return vote_levels(trial, "vt", options);
    case Technique::dm: return vote_levels(trial, "dm", options);
    case Technique::mp: return neighbour_levels(trial, options);
    case Technique::bu: return probability_levels(trial, options);
    default: assert(technique == Technique::tbf); return triangulation_levels(trial, options);
  }
}

}  // namespace

Result<LevelMap> level_map(const Trial& trial, Technique technique, const OptionMap& options) {
  Result<Levels> cells = levels_of(trial, technique, options);
  if (!cells) return cells.error();
  std::erase_if(*cells, [&](const LevelMap::LeveledCell& cell) { return !trial.scorer->inside(cell.centre); });
  return LevelMap{std::move(*cells), trial.scoring().cell_m, technique == Technique::bu};
}

std::vector<MapScore> scores_at(const LevelMap& map, const SceneScorer& scorer, std::span<const double> parameters) {
  std::vector<double> distances_m;
  for (const LevelMap::LeveledCell& cell : map.cells) distances_m.push_back(scorer.distance_m(cell.centre));
  std::vector<MapScore> scores;
  for (const double parameter : parameters) {
    std::vector<Vec2> centres;
    double sum_m = 0.0;
    for (std::size_t k = 0; k < map.cells.size(); ++k) {
      if (!map.set(map.cells[k], parameter)) continue;
      centres.push_back(map.cells[k].centre);
      sum_m += distances_m[k];
    }
    MapScore score;
    score.points = centres.size();
    score.mae_m = centres.empty() ? std::numeric_limits<double>::quiet_NaN() : sum_m / double(centres.size());
    score.detection = scorer.detection(PointSet::of_cells(std::move(centres), map.cell_m).value());
    scores.push_back(score);
  }
  return scores;
}

}  // namespace echoarc::studies::barshan
