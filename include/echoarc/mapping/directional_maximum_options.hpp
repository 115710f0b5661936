// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <tuple>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/voting.hpp"

namespace echoarc {

/// Where the lines of interest come from.
enum class DirectionOfInterest {
  automatic,      ///< followed_wall where the log names the followed wall, else pca
  axis,           ///< parallels to one fixed direction
  los,            ///< the line of sight of every echo
  path_normal,    ///< perpendicular to the robot's path; to both sides unless the log names the wall
  followed_wall,  ///< perpendicular to the path, towards the nearest wall
  pca,            ///< across the main spread of the counts, window by window
  polar,          ///< rays around vantage points on the path
};
constexpr std::array<Choice<DirectionOfInterest>, 7> choices(DirectionOfInterest /*tag*/) {
  using D = DirectionOfInterest;
  return {{{D::automatic, "auto"},
           {D::axis, "axis"},
           {D::los, "los"},
           {D::path_normal, "path_normal"},
           {D::followed_wall, "followed_wall"},
           {D::pca, "pca"},
           {D::polar, "polar"}}};
}

/// Which of the two middle maxima of a line survives when their number is even.
enum class TieRule {
  near,  ///< the one nearer the robot
  far,   ///< the other
  hash,  ///< either, by a hash of seed and line: the paper's random choice, repeatable
};
constexpr std::array<Choice<TieRule>, 3> choices(TieRule /*tag*/) {
  return {{{TieRule::near, "near"}, {TieRule::far, "far"}, {TieRule::hash, "hash"}}};
}

/// What becomes of cells that reach the threshold but lie on no line of interest.
enum class UnvisitedRule { zero, keep };
constexpr std::array<Choice<UnvisitedRule>, 2> choices(UnvisitedRule /*tag*/) {
  return {{{UnvisitedRule::zero, "zero"}, {UnvisitedRule::keep, "keep"}}};
}

/// How the views from several vantage points become one map.
enum class PolarFusion {
  any,      ///< what survives from one vantage point
  support,  ///< what survives from one and has a survivor of another within two cells
};
constexpr std::array<Choice<PolarFusion>, 2> choices(PolarFusion /*tag*/) {
  return {{{PolarFusion::any, "union"}, {PolarFusion::support, "support"}}};
}

/// How a line of interest is processed.
template <class O>
[[nodiscard]] constexpr auto line_fields() {
  return std::tuple{
      field("doi", &O::doi, {.doc = "where the lines of interest come from", .source = "[Barshan07] 3.3, 4.2, 5"}),
      field("axis_deg", &O::axis,
            {.unit = "deg",
             .min = -360.0,
             .max = 360.0,
             .doc = "doi axis: direction of the lines, away from the robot",
             .source = "[Barshan07] 3.3: +y for the curve"}),
      field("tie", &O::tie,
            {.doc = "which of two middle maxima survives", .source = "[Barshan07] 3.3 takes one at random"}),
      field("tie_seed", &O::tie_seed, {.min = 0, .max = 2147483647, .doc = "tie hash: seed of the choice"}),
      field("unvisited", &O::unvisited,
            {.doc = "cells at the threshold that no line of interest visits: dropped or kept"})};
}

/// Where lines of interest come from.
template <class O>
[[nodiscard]] constexpr auto provider_fields() {
  return std::tuple{
      field("tangent_window_m", &O::tangent_window_m,
            {.unit = "m",
             .min = 0.001,
             .max = 10.0,
             .doc = "doi path_normal, followed_wall: the path's tangent is taken over this far to either side"}),
      field("wall_switch_stops", &O::wall_switch_stops,
            {.unit = "stops",
             .min = 1,
             .max = 1000,
             .doc = "doi followed_wall: stops in a row with the nearest echo on the other side before the side changes",
             .source = "[Barshan07] 4.2: nearest wall"}),
      field("pca_window_m", &O::pca_window_m,
            {.unit = "m", .min = 0.01, .max = 100.0, .doc = "doi pca: edge of a window", .source = "[Barshan07] 3.3"}),
      field("pca_stride_m", &O::pca_stride_m,
            {.unit = "m", .min = 0.01, .max = 100.0, .doc = "doi pca: distance between windows"}),
      field("pca_max_ratio", &O::pca_max_ratio,
            {.min = 0.0,
             .max = 1.0,
             .doc = "doi pca: windows whose smaller eigenvalue exceeds this share of the larger have no direction"}),
      field("pca_min_weight", &O::pca_min_weight,
            {.unit = "arcs", .min = 0.0, .max = 1e9, .doc = "doi pca: windows with a smaller sum of counts have none"}),
      field("polar_spacing_m", &O::polar_spacing_m,
            {.unit = "m",
             .min = 0.01,
             .max = 1e6,
             .doc = "doi polar: distance between vantage points along the path",
             .source = "[Barshan07] 5, future work"}),
      field("polar_step_deg", &O::polar_step,
            {.unit = "deg", .min = 0.01, .max = 90.0, .doc = "doi polar: angle between rays"}),
      field("polar_fusion", &O::polar_fusion,
            {.doc = "doi polar: keep what any vantage point sees, or what a second one supports within two cells"})};
}

struct DirectionalMaximumOptions {
  double cell_m = 0.01;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  int threshold = 4;
  ArcSampling sampling = ArcSampling::exact;
  DirectionOfInterest doi = DirectionOfInterest::automatic;
  Angle axis = degrees(90.0);
  TieRule tie = TieRule::near;
  int tie_seed = 0;
  UnvisitedRule unvisited = UnvisitedRule::zero;
  double tangent_window_m = 0.10;
  int wall_switch_stops = 3;
  double pca_window_m = 0.60;
  double pca_stride_m = 0.30;
  double pca_max_ratio = 0.5;
  double pca_min_weight = 20.0;
  double polar_spacing_m = 1.0;
  Angle polar_step = degrees(0.25);
  PolarFusion polar_fusion = PolarFusion::any;

  static constexpr auto fields() {
    using O = DirectionalMaximumOptions;
    return std::tuple_cat(grid_fields<O>(), arc_fields<O>(), vote_fields<O>(), line_fields<O>(), provider_fields<O>());
  }
};

}  // namespace echoarc
