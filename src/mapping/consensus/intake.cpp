// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "mapping/consensus/intake.hpp"

#include "mapping/counted_arc.hpp"

namespace echoarc::consensus {
namespace {

bool is_beam(Angle beam_width) {
  return beam_width > Angle{} && beam_width < degrees(180.0);
}

}  // namespace

std::optional<EchoArc> echo_of(const Reading& reading, const ConsensusOptions& options, InsertCounters& counters) {
  const auto range_m = echo_range_m(reading.outcome);
  if (range_m && (!(*range_m > 0.0) || !is_beam(reading.beam_width))) {
    ++counters.no_arc;
    return std::nullopt;
  }
  if (range_m && *range_m >= options.range_max_m) {
    ++counters.passed_over;
    return std::nullopt;
  }
  const auto arc = counted_arc(reading, options.beam_policy, counters);
  if (!arc) return std::nullopt;
  if (!ArcHistory::is_storable(*arc) || !is_finite(arc->axis()) || !is_finite(reading.T_world_robot)) {
    ++counters.no_arc;
    return std::nullopt;
  }
  return EchoArc{*arc, {reading.ping, reading.time_s, reading.rx}, reading.tx, reading.beam_width, 0};
}

}  // namespace echoarc::consensus
