// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

#include "echoarc/eval/free_cells.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/studies/map_picture.hpp"
#include "echoarc/studies/study_host.hpp"

/// Grid methods in a simulated room, held against what is truly free in it.
namespace echoarc::studies {

/// The true states of the cells of a scene's judged region; free is what the robot can get to from where it starts.
/// Cells are aligned with the world's origin, as those of the methods are.
[[nodiscard]] DenseGrid<CellState> scene_truth(const StudyScene& scene, double cell_m);

struct GridScore {
  FreeCells cells;
  DenseGrid<CellState> states;  ///< empty unless asked for
};

/// Simulates the scene and gives its log to all methods. Scores in the order of the methods.
[[nodiscard]] Result<std::vector<GridScore>> score_grids(const StudyScene& scene, std::uint64_t seed,
                                                         std::vector<AnyMethod> methods,
                                                         const DenseGrid<CellState>& truth, bool keep_states,
                                                         const SensingOptions& sensing = {});

/// A grid map with the true surfaces drawn into it as thin lines.
[[nodiscard]] Image grid_picture(const StudyScene& scene, const DenseGrid<CellState>& states);

}  // namespace echoarc::studies
