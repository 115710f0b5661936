// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "echoarc/mapping/grid_options.hpp"
#include "echoarc/mapping/history_options.hpp"
#include "echoarc/mapping/transversal_medians.hpp"

namespace echoarc {

/// What the three papers make of an arc with n transversal crossings; all take the median of three or more and the only
/// one of one.
enum class AtmVariant : std::uint8_t {
  org,     ///< [Choset03]: none - the middle of the arc; two - nothing
  mod,     ///< [Barshan07] 3.6: none - nothing; two - their mean
  silver,  ///< [Silver04] 2.D: none - the middle of the arc; two - their mean
};

constexpr std::array<Choice<TransversalAngle>, 3> choices(TransversalAngle /*tag*/) {
  return {{{TransversalAngle::given, "given"},
           {TransversalAngle::from_gain, "from_gain"},
           {TransversalAngle::from_histogram, "from_histogram"}}};
}

constexpr std::array<Choice<HistogramStatistic>, 3> choices(HistogramStatistic /*tag*/) {
  return {
      {{HistogramStatistic::mean, "mean"}, {HistogramStatistic::mode, "mode"}, {HistogramStatistic::median, "median"}}};
}

/// Fields of `TransversalAngle angle`, `Angle theta_t`, `double gain`, `HistogramStatistic statistic`,
/// `double range_quantum_m`, `bool small_d_center`: which crossings count.
template <class Options>
[[nodiscard]] constexpr auto transversal_fields() {
  return std::tuple{
      field("angle", &Options::angle,
            {.doc = "where the least crossing angle comes from: given, solved from a resolution gain for each arc, or "
                    "a central value of all crossing angles",
             .source = "[Choset03] eq. 2; [Barshan07] 4.3"}),
      field("theta_t_deg", &Options::theta_t,
            {.unit = "deg",
             .min = 0.0,
             .max = 90.0,
             .doc = "angle given: arcs that cross at this angle or more count",
             .source = "[Choset03] IV-B: 30; [Barshan07] 4.3: 13 for the curve, 5 for rooms"}),
      field("gain", &Options::gain,
            {.min = 0.0,
             .max = 1e6,
             .doc = "angle from_gain: by how much a crossing shortens the interval that holds the echo; arcs too near "
                    "to reach it have no transversal crossing",
             .source = "[Choset03] IV-D: 10"}),
      field("statistic", &Options::statistic,
            {.doc = "angle from_histogram: which central value", .source = "[Barshan07] 4.3"}),
      field("range_quantum_m", &Options::range_quantum_m,
            {.unit = "m",
             .min = 0.0,
             .max = 1.0,
             .doc = "the band of distances a range stands for; gives the points' bounds, and the angle from_gain",
             .source = "[Choset03] IV-B: 1 inch"}),
      field("small_d_center", &Options::small_d_center,
            {.doc = "take the middle of arcs so near that a crossing could not shorten them",
             .source = "[Choset03] IV-B"})};
}

template <class Options>
[[nodiscard]] TransversalRule transversal_rule_of(const Options& options) {
  return {options.angle, options.theta_t, options.gain, options.statistic, options.range_quantum_m};
}

/// Options of the arc-transversal median; the variants differ in what their papers set.
template <AtmVariant variant>
struct AtmOptions {
  double cell_m = 0.01;  ///< of the exported picture; the points themselves are exact
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  int max_memory_mib = 1024;
  BeamPolicy beam_policy = BeamPolicy::bisector;
  TransversalAngle angle = TransversalAngle::given;
  Angle theta_t = degrees(variant == AtmVariant::mod ? 13.0 : 30.0);
  double gain = 10.0;
  HistogramStatistic statistic = HistogramStatistic::median;
  double range_quantum_m = inch_m;
  bool small_d_center = false;
  HistoryScope history = variant == AtmVariant::org   ? HistoryScope::per_sensor
                         : variant == AtmVariant::mod ? HistoryScope::all
                                                      : HistoryScope::total;
  int history_arcs = variant == AtmVariant::org ? 10 : 250;
  bool archive = true;
  int min_neighbours = 0;
  double neighbour_radius_m = 0.2;

  static constexpr auto fields() {
    using O = AtmOptions;
    return std::tuple_cat(grid_fields<O>(), arc_fields<O>(), transversal_fields<O>(), history_fields<O>(),
                          neighbour_fields<O>());
  }
};

}  // namespace echoarc
