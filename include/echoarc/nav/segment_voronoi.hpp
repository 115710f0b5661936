// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <optional>
#include <span>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/core/result.hpp"
#include "echoarc/core/vec2.hpp"
#include "echoarc/nav/voronoi_graph.hpp"

namespace echoarc::nav {

/// A straight wall of a finished map, world, m; of length 0 it is a point.
struct WallSegment {
  Vec2 begin;
  Vec2 end;
};

struct SegmentVoronoiOptions {
  double min_clearance_m = 0.325;
  Angle separation = degrees(30.0);
  double spacing_m = 0.05;
  double merge_m = 0.02;
  double resolution_m = 1e-4;

  static constexpr auto fields() {
    using O = SegmentVoronoiOptions;
    return std::tuple{field("min_clearance_m", &O::min_clearance_m,
                            {.unit = "m", .min = 0.001, .max = 100.0, .doc = "what is nearer to a wall is cut off"}),
                      field("separation_deg", &O::separation,
                            {.unit = "deg", .min = 0.0, .max = 120.0, .doc = "walls seen under less are one obstacle"}),
                      field("spacing_m", &O::spacing_m,
                            {.unit = "m", .min = 0.001, .max = 10.0, .doc = "between the vertices of a curved edge"}),
                      field("merge_m", &O::merge_m,
                            {.unit = "m", .min = 0.0, .max = 1.0, .doc = "nodes joined by a shorter edge are one"}),
                      field("resolution_m", &O::resolution_m,
                            {.unit = "m", .min = 1e-5, .max = 0.1, .doc = "to which the ends of walls are rounded"})};
  }
};

/// The generalised Voronoi graph of a finished map, by the diagram of its walls (Fortune's sweep as in Boost.Polygon);
/// what a graph traced on the spot is held against. Walls may touch and cross. With `inside` only the part of the graph
/// around that place is kept. An error if a coordinate is no number or beyond 2^29 times the
/// resolution (53 km).
[[nodiscard]] Result<VoronoiGraph> segment_voronoi(std::span<const WallSegment> walls, std::optional<Vec2> inside = {},
                                                   const SegmentVoronoiOptions& options = {});

}  // namespace echoarc::nav
