// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <tuple>

#include "echoarc/core/options.hpp"
#include "echoarc/maps/arc_history.hpp"

namespace echoarc {

constexpr std::array<Choice<HistoryScope>, 3> choices(HistoryScope /*tag*/) {
  return {{{HistoryScope::all, "all"}, {HistoryScope::per_sensor, "per_sensor"}, {HistoryScope::total, "total"}}};
}

/// Fields of `HistoryScope history`, `int history_arcs`, `bool archive`, for the methods that compare arcs with one
/// another.
template <class Options>
[[nodiscard]] constexpr auto history_fields() {
  return std::tuple{
      field("history", &Options::history,
            {.doc = "which arcs are compared: all of the log, or the newest per receiver or in total",
             .source = "[Choset03] IV-D: 10 per sensor; [Silver04] 5.C: 250 in total; [Barshan07]: all"}),
      field("history_arcs", &Options::history_arcs,
            {.unit = "arcs",
             .min = 1,
             .max = 1000000,
             .doc = "history per_sensor, total: how many are kept; a new one displaces the oldest",
             .source = "[Choset03] IV-D, [Silver04] 5.C"}),
      field("archive", &Options::archive,
            {.doc = "keep the final point of an arc that leaves the history (global map); off: the map shows the "
                    "history alone (local map)",
             .source = "[Silver04] Fig. 13"})};
}

}  // namespace echoarc
