// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/studies/experiment.hpp"
#include "studies/barshan/methods.hpp"

namespace echoarc::studies::barshan {

/// The maps of a technique for every value of its parameter at once: a cell is set when its level reaches the
/// parameter. VT: the arcs that cross it. DM: the same, where it survives on a line of interest; the maximum of a line
/// does not depend on the threshold. MP: its set neighbours. BU: P. TBF: the most triangulations of a point in it.
struct LevelMap {
  struct LeveledCell {
    Vec2 centre;
    double level = 0.0;
  };
  std::vector<LeveledCell> cells;  ///< of the judged region
  double cell_m = 0.01;
  bool strict = false;  ///< BU: the level must exceed the parameter

  [[nodiscard]] bool set(const LeveledCell& cell, double parameter) const {
    return strict ? cell.level > parameter : cell.level >= parameter;
  }
};

/// `options` are those of the method but for the parameter. VT, DM, MP, BU and TBF. Errors: those of the method.
[[nodiscard]] Result<LevelMap> level_map(const Trial& trial, Technique technique, const OptionMap& options);

/// The score at each parameter; the same as mapping anew with it.
[[nodiscard]] std::vector<MapScore> scores_at(const LevelMap& map, const SceneScorer& scorer,
                                              std::span<const double> parameters);

}  // namespace echoarc::studies::barshan
