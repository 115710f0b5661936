// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "echoarc/core/executor.hpp"
#include "echoarc/eval/arc_statistics.hpp"
#include "echoarc/mapping/catalog.hpp"

namespace echoarc::studies {

/// What one method makes of its arcs, and how soon ([Silver04] 5.B and 5.C).
struct ArcStudy {
  std::string method;
  Latency latency;
  std::vector<AzimuthClass> azimuth;  ///< by radius; of the arcs that left the history
  std::uint64_t finished = 0;         ///< arcs that left the history alive
  std::uint64_t improved = 0;         ///< of those, crossed or carved
  double fully_carved_share = std::numeric_limits<double>::quiet_NaN();  ///< NaN for methods that do not carve
};

/// Gives `readings` (as `sense` makes them of a log) to the methods scan by scan, in one pass, and looks at their
/// histories after every scan once they are full. A history that never fills, as one that keeps every arc, is looked at
/// once, in the end. Point marking has no history: its arcs are all processed at once. Other methods without a history
/// of arcs give no sample. The methods are finished afterwards and hold their maps. One task of `executor` per method.
[[nodiscard]] std::vector<ArcStudy> study_arcs(std::span<AnyMethod> methods, std::span<const Reading> readings,
                                               Executor& executor, const RadiusBins& bins = {});

}  // namespace echoarc::studies
