// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <set>
#include <vector>

#include "echoarc/nav/cost_map.hpp"

namespace echoarc::nav {

/// Out of where the robot cannot be, or of a pocket between such cells that it cannot leave otherwise.
struct EscapeWay {
  std::vector<Cell> cells;  ///< from the start on
  Cell end;                 ///< passable, and no part of the pocket
};

/// The passable cells that are joined to `start`, if none of them is further than `reach_m` away along a row or column:
/// a pocket. Empty if the start itself is blocked; none if it is no pocket.
[[nodiscard]] std::optional<std::set<Cell>> pocket_around(const CostMap& map, Cell start, double reach_m);

/// The shortest way from `start` to a passable cell outside `pocket`, at the most `longest_m`, through cells that are
/// not occupied. Where the start itself is, the map errs, for the robot stands there: then the cells under it do not
/// stop it either.
[[nodiscard]] std::optional<EscapeWay> shortest_escape(const CostMap& map, Cell start, const std::set<Cell>& pocket,
                                                       double longest_m);

}  // namespace echoarc::nav
