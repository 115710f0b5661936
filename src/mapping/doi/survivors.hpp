// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <vector>

#include "echoarc/mapping/directional_maximum_options.hpp"
#include "echoarc/mapping/doi_history.hpp"
#include "echoarc/mapping/vote_grid.hpp"

namespace echoarc::doi {

/// The cells that survive on the lines of the chosen direction of interest, row by row, each once.
[[nodiscard]] std::vector<Cell> survivors(const VoteGrid::Counts& counts, const DoiHistory& history,
                                          const DirectionalMaximumOptions& options);

/// The cells of each view that have a cell of another view within \p reach_cells (in both coordinates), united.
[[nodiscard]] std::vector<Cell> supported(std::span<const std::vector<Cell>> views, std::int32_t reach_cells);

}  // namespace echoarc::doi
