// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "echoarc/core/arc_crossing.hpp"
#include "live/replay.hpp"

namespace echoarc::live {

/// Which arcs a method of arcs compares with one another, by its options.
struct ComparedArcs {
  enum class Scope : std::uint8_t { all, per_sensor, total };
  Scope scope = Scope::total;
  std::size_t arcs = 250;
  Angle theta_t;  ///< least angle of a crossing; 0 where the method does not ask or finds it itself
  BeamPolicy policy = BeamPolicy::bisector;
};
[[nodiscard]] ComparedArcs compared_arcs(std::string_view method, const OptionMap& all_options);

/// A ping whose arc crosses another.
struct Partner {
  std::size_t place = 0;  ///< in the log
  ArcCrossing crossing;   ///< on the own arc (a) and on the partner's (b)
};

/// What became of all pings of a log in the search for those that cross an arc.
struct Partners {
  std::vector<Partner> crossing;  ///< in the order of time
  std::vector<UnusedPings> unused;
};
[[nodiscard]] Partners find_partners(const Evidence& evidence, std::size_t own, const Arc& arc,
                                     const ComparedArcs& compared);

}  // namespace echoarc::live
