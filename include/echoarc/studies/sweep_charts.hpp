// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/studies/svg_chart.hpp"
#include "echoarc/studies/sweep.hpp"

namespace echoarc::studies {

/// A chart under the name that a file gets.
struct NamedChart {
  std::string name;  ///< "mae", "cdr", "coverage"
  Chart chart;
};

/// A sweep in pictures: MAE, correct detection ratios and coverage over the first axis that has several values, a
/// line per method and combination of the others, means with the spread over the seeds. Of a single line all ratios are
/// shown, else the overall one. Charts without a value are left out; of more than `max_chart_lines` lines the first are
/// shown. Without an axis of several values there is a bar per method.
[[nodiscard]] std::vector<NamedChart> sweep_charts(const SweepResult& sweep);

inline constexpr std::size_t max_chart_lines = 14;

}  // namespace echoarc::studies
