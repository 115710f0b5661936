// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "echoarc/nav/voronoi_graph.hpp"

namespace echoarc::nav {

/// A place of a Voronoi diagram and its distance to the nearest walls.
struct ClearPlace {
  Vec2 place;
  double clearance_m = 0.0;
};

/// A piece of a Voronoi diagram between two of its vertices.
struct DiagramPiece {
  std::size_t from = 0;  ///< number of the vertex it begins at
  std::size_t to = 0;
  std::vector<ClearPlace> line;  ///< at least two
};

/// Pieces joined to a graph: vertices where two pieces meet vanish in an edge, pieces shorter than `merge_m` in a node.
/// With `inside` only the connected part with the place nearest to it is kept.
[[nodiscard]] VoronoiGraph join_pieces(std::vector<DiagramPiece> pieces, std::size_t vertices, double merge_m,
                                       std::optional<Vec2> inside);

}  // namespace echoarc::nav
