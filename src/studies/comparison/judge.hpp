// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "echoarc/eval/reference.hpp"
#include "echoarc/studies/comparison.hpp"

namespace echoarc::studies::comparison {

/// What maps of one run are held against. Const calls from several threads are safe.
struct Yardstick {
  Reference reference;
  PointSet path;                   ///< of the robot
  std::optional<Reference> whole;  ///< of a truncated log: what the whole log's laser saw
};

struct JudgedRun {
  std::vector<ComparedMap> maps;  ///< by method
  std::vector<PointSet> points;   ///< their points, where asked for
};

/// Every method over one log, each map scored. With `scorer` the maps lie on the grid of its scoring, and their pixels
/// are scored, too. `keep_points` for pictures. Errors: those of `make_method`, `export_map` and `PointSet`.
[[nodiscard]] Result<JudgedRun> judge_run(const Log& log, const Yardstick& yardstick,
                                          std::span<const ComparedMethod> methods, const SceneScorer* scorer,
                                          bool keep_points);

/// Positions of the log's odometry.
[[nodiscard]] Result<PointSet> odometry_path(const Log& log);

/// Maps side by side, two in a row: the reference grey, points within 10 cm of it dark, others red.
[[nodiscard]] std::optional<PictureFigure> picture_of(const std::string& place, const Yardstick& yardstick,
                                                      std::span<const ComparedMethod> methods,
                                                      std::span<const PointSet> points);

}  // namespace echoarc::studies::comparison
