// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "echoarc/core/arc.hpp"
#include "echoarc/core/options.hpp"
#include "echoarc/maps/arc_raster.hpp"
#include "echoarc/maps/grid_geometry.hpp"
#include "echoarc/maps/neighbour_filter.hpp"

/// Options that several methods share. A method's option struct has members of these names and joins the fields:
///
///     static constexpr auto fields() { return std::tuple_cat(grid_fields<VotingOptions>(), std::tuple{field(...)}); }
namespace echoarc {

constexpr std::array<Choice<BeamPolicy>, 3> choices(BeamPolicy /*tag*/) {
  return {{{BeamPolicy::bisector, "bisector"}, {BeamPolicy::both, "both"}, {BeamPolicy::either, "either"}}};
}

constexpr std::array<Choice<ArcSampling>, 2> choices(ArcSampling /*tag*/) {
  return {{{ArcSampling::sampled, "sampled"}, {ArcSampling::exact, "exact"}}};
}

/// Fields of `double cell_m`, `double origin_x_m`, `double origin_y_m`, `int max_memory_mib`: where the cells lie and
/// how much memory the map may take.
template <class Options>
[[nodiscard]] constexpr auto grid_fields() {
  return std::tuple{
      field(
          "cell_m", &Options::cell_m,
          {.unit = "m", .min = 0.001, .max = 10.0, .doc = "edge of a grid cell", .source = "[Barshan07] 3.2: 0.01 m"}),
      field("origin_x_m", &Options::origin_x_m,
            {.unit = "m", .min = -1e6, .max = 1e6, .doc = "x of the lower left corner of cell (0, 0), world"}),
      field("origin_y_m", &Options::origin_y_m,
            {.unit = "m", .min = -1e6, .max = 1e6, .doc = "y of the lower left corner of cell (0, 0), world"}),
      field("max_memory_mib", &Options::max_memory_mib,
            {.unit = "MiB",
             .min = 1,
             .max = 1 << 20,
             .doc = "memory the map may take; readings beyond it are left out and counted"})};
}

/// Field of `BeamPolicy beam_policy`: which part of the ellipse of a bistatic reading is its arc.
template <class Options>
[[nodiscard]] constexpr auto arc_fields() {
  return std::tuple{
      field("beam_policy", &Options::beam_policy,
            {.doc = "part of a bistatic reading's ellipse that is its arc: within half a beam of the mean "
                    "axis, inside both beams, or inside either",
             .source = "[Barshan07] 2, Fig. 1b draws it without a rule"})};
}

/// Fields of `int min_neighbours`, `double neighbour_radius_m` for methods whose map is points: lonely points are left
/// out of what `export_map` hands over, and come back when they get neighbours.
template <class Options>
[[nodiscard]] constexpr auto neighbour_fields() {
  return std::tuple{
      field("min_neighbours", &Options::min_neighbours,
            {.unit = "points",
             .min = 0,
             .max = 100,
             .doc = "points with fewer others around them are not handed out; 0: all are; 2 is a good value",
             .source = "[Silver04] App. B"}),
      field("neighbour_radius_m", &Options::neighbour_radius_m,
            {.unit = "m", .min = 0.001, .max = 100.0, .doc = "how far away a neighbour may be"})};
}

template <class Options>
[[nodiscard]] NeighbourRule neighbour_rule(const Options& options) {
  return {options.min_neighbours, options.neighbour_radius_m};
}

template <class Options>
[[nodiscard]] GridGeometry geometry_of(const Options& options) {
  return {options.cell_m, {options.origin_x_m, options.origin_y_m}};
}

template <class Options>
[[nodiscard]] std::size_t memory_limit_bytes(const Options& options) {
  return std::size_t(options.max_memory_mib) << 20;
}

}  // namespace echoarc
