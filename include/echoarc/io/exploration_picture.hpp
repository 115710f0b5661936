// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

#include "echoarc/core/log.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/maps/dense_grid.hpp"
#include "echoarc/nav/strategy.hpp"
#include "echoarc/sim/scene.hpp"

namespace echoarc::io {

/// Draws what came of an exploration: the map that plans were made on, the true world and way, and what the strategy
/// had in mind at the end. An empty map is left out. Errors: those of `write_picture`.
[[nodiscard]] Result<void> write_exploration_picture(const std::filesystem::path& path, const sim::Scene& scene,
                                                     const Log& log, const DenseGrid<CellState>& map,
                                                     const nav::Sketch& sketch);

}  // namespace echoarc::io
