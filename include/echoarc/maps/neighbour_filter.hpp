// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/maps/point_map.hpp"

namespace echoarc {

/// Which points have company ([Silver04] App. B).
struct NeighbourRule {
  int min_neighbours = 2;  ///< 0: every point
  double radius_m = 0.2;   ///< within this, ends included
};

/// The points of a map that have enough other points near them, whatever their labels; with their pings, in their
/// order; and its segments with as many points near their middles. The map itself is left alone: what is lonely now may
/// get neighbours.
[[nodiscard]] PointMap with_neighbours(const PointMap& points, const NeighbourRule& rule = {});

}  // namespace echoarc
