// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "echoarc/eval/correct_detection.hpp"
#include "echoarc/eval/timing.hpp"
#include "echoarc/eval/wall_distance.hpp"

namespace echoarc {

/// All scores of one map against one reference.
struct ScoreReport {
  std::string reference;  ///< provenance
  std::uint64_t reference_points = 0;
  TwoWayWallDistance wall_distance;                   ///< `all.mean_m` is the mean absolute error
  std::optional<CorrectDetection> correct_detection;  ///< none without directions of interest
  std::optional<double> cells_mae_m;  ///< of the cells inside the directions' region; none without directions
  std::optional<double> detection_tolerance_m;
  std::optional<TimingSummary> timing;  ///< none unless the host measured it
};

/// What the scores need besides map and reference.
struct ScoreRequest {
  PointSet path;  ///< positions of the robot; see `wall_distance`
  WallDistanceOptions wall_distance;
  std::optional<DirectionSet> directions;
  std::optional<double> detection_tolerance_m;  ///< see `correct_detection`
};

/// `cells`: what is judged direction by direction, the cells the map is drawn with, where that is not `map` itself.
/// Errors: options or directions out of range.
[[nodiscard]] Result<ScoreReport> score(const PointSet& map, const Reference& reference, const ScoreRequest& request,
                                        const PointSet* cells = nullptr);

/// One line of a report. `name` is fixed and the same in text and JSON; `value` may be NaN.
struct ScoreRow {
  std::string name;
  double value = 0.0;
  std::string unit;  ///< "" for counts, "share", "m", "s"
  std::string note;  ///< what the number means, for people
};

/// The report as a plain table, in a fixed order; rows without a measurement (CDR, timing) are left out.
[[nodiscard]] std::vector<ScoreRow> rows(const ScoreReport& report);

}  // namespace echoarc
