// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

#include "echoarc/nav/voronoi_graph.hpp"

namespace echoarc::nav {

/// The graph as GraphML (graphml.graphdrawing.org): an undirected graph; nodes with x_m, y_m, type, distance_m and ways
/// (bearings in degrees and edges in cyclic order), edges with length_m, min_clearance_m and polyline ("x,y x,y ...").
/// The same graph gives the same text; numbers read back as the same values.
[[nodiscard]] std::string to_graphml(const VoronoiGraph& graph);

/// The graph as JSON: {"nodes": [{"id", "place": [x, y], "type", "distance_m", "ways": [{"bearing_deg", "edge",
/// "given_up"}]}], "edges": [{"id", "from", "to", "length_m", "min_clearance_m", "polyline": [[x, y], ...]}]}. What is
/// no finite number becomes null.
[[nodiscard]] std::string to_json(const VoronoiGraph& graph);

}  // namespace echoarc::nav
