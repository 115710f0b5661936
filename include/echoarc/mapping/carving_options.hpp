// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <tuple>

#include "echoarc/core/options.hpp"

namespace echoarc {

/// Fields of `int history`, `double guard_m`, `double max_range_m`, `bool carve_with_timeouts`: how arcs are carved.
template <class Options>
[[nodiscard]] constexpr auto carving_fields() {
  return std::tuple{
      field(
          "history", &Options::history,
          {.unit = "arcs",
           .min = 0,
           .max = 1'000'000,
           .doc = "arcs that newer readings can still change; each new one replaces the oldest. 0: none is ever carved",
           .source = "[Silver04] 5.C: 250"}),
      field("guard_m", &Options::guard_m,
            {.unit = "m",
             .min = 0.0,
             .max = 1.0,
             .doc = "depth before an echo that its reading does not carve, for the error of the ranges",
             .source = "[Silver04] eq. 3.2: 0"}),
      field("max_range_m", &Options::max_range_m,
            {.unit = "m",
             .min = 0.01,
             .max = 1000.0,
             .doc = "echoes beyond this are left out, as if not heard",
             .source = "[Silver04] appendix B: 150 inches"}),
      field("carve_with_timeouts", &Options::carve_with_timeouts,
            {.doc = "let silence carve, too: free to the sensor's trusted range, or to max_range_m if that is less"})};
}

/// Fields of `bool error_threshold`, `double max_error_m`, `bool archive`: which points of carved arcs the map holds.
template <class Options>
[[nodiscard]] constexpr auto carved_point_fields() {
  return std::tuple{
      field("error_threshold", &Options::error_threshold,
            {.doc = "keep a carved or centerline point only if its error bound is at most max_error_m",
             .source = "[Silver04] Fig. 13b"}),
      field("max_error_m", &Options::max_error_m,
            {.unit = "m", .min = 0.0, .max = 100.0, .doc = "largest error bound E_s with error_threshold"}),
      field("archive", &Options::archive,
            {.doc = "keep the last point of every arc that leaves the history (a global map); otherwise the map holds "
                    "the arcs of the history alone (a local map)",
             .source = "[Silver04] Fig. 13 and Fig. 9"})};
}

}  // namespace echoarc
