// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "echoarc/core/log.hpp"
#include "echoarc/eval/parameter_choice.hpp"
#include "echoarc/eval/reference.hpp"
#include "echoarc/studies/spread.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/sweep_axis.hpp"

namespace echoarc::studies {

/// A recorded drive and what its maps are held against. An infinite region judges whole maps, on the methods' own
/// grids.
struct JudgedLog {
  Log log;
  Reference reference;
  SceneScoring scoring;  ///< its `reference` and `polynomial_degree` play no part
};

/// What is mapped again and again: a scene, simulated once per seed, or a log.
using SweepSubject = std::variant<StudyScene, JudgedLog>;

struct SweepRequest {
  SweepSubject subject;
  std::vector<std::string> methods;  ///< of the catalogue, no two alike
  /// Every combination of their values is tried. An axis of a single method's options with several values must not meet
  /// other methods.
  std::vector<SweepAxis> axes;
};

/// What is measured of every map; NaN where there is nothing to measure. Lengths in metres, shares in 0..1.
struct SweepScores {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double mae_m = none;         ///< of the centres of occupied cells ([Barshan07] 3.8)
  double mae_points_m = none;  ///< of the exact points of methods that have them, else the same
  double cdr_full = none;
  double cdr_empty = none;
  double cdr_overall = none;
  double within_5cm = none;  ///< of the cells' centres
  double within_10cm = none;
  double within_20cm = none;
  double coverage = none;  ///< see `WallDistance`
  double cells = none;     ///< occupied, in the judged region
  double cpu_per_reading_s = none;
};

/// A score as tables name it.
struct SweepMetric {
  std::string_view name;  ///< "mae"
  std::string_view title;
  std::string_view unit;  ///< "m", "share", "s" or ""
  double SweepScores::* value;
};
[[nodiscard]] std::span<const SweepMetric> sweep_metrics();

/// One method with one combination of values.
struct SweepRow {
  std::string method;
  std::vector<OptionValue> values;  ///< one per axis
  std::vector<SweepScores> runs;    ///< one per seed

  [[nodiscard]] Spread spread(const SweepMetric& metric) const;
};

/// The rows of a method that the parameter rule takes, by their means over the seeds.
struct SweepChoice {
  std::string method;
  std::size_t best = 0;                 ///< index of a row
  std::vector<std::size_t> candidates;  ///< see `ParameterChoice`
};

struct SweepResult {
  std::vector<SweepAxis> axes;
  std::vector<std::uint64_t> seeds;  ///< a single 0 for a log
  std::vector<SweepRow> rows;        ///< method by method; the last axis varies fastest
  std::vector<SweepChoice> choices;  ///< of methods with correct detection ratios and several rows, all of one world
};

/// More maps than this (methods x combinations x seeds) are a mistake.
inline constexpr std::size_t max_sweep_maps = 100'000;

/// Maps and scores every combination. A drive is simulated once for every seed and every combination of its scene's
/// options, sensed once for every combination of sensing's, and all methods work on the same readings. Seeds are 1, 2,
/// ... as many as `host` wants; of a log there is one run. Scores but CPU times do not depend on the threads of
/// `host.executor`. Errors: no method, an unknown one or one named twice, two axes of one option, an axis without
/// values, too many maps, whatever simulation, scoring and methods object to; interruption.
[[nodiscard]] Result<SweepResult> run_sweep(const SweepRequest& request, const StudyHost& host);

}  // namespace echoarc::studies
