// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "echoarc/studies/study_report.hpp"

/// Rows and claims out of one figure per seed.
namespace echoarc::studies {

inline constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// "0.32 m"; "-" for what is no number.
[[nodiscard]] std::string figure_text(double value, int decimals, std::string_view unit);

struct RowText {
  std::string quantity;
  std::string condition;
  std::string unit;
  int decimals = 3;
};
/// `paper`: NaN where it has no number.
[[nodiscard]] StudyRow row_of(RowText text, double paper, std::span<const double> ours);
[[nodiscard]] StudyRow row_of(RowText text, std::string paper, std::span<const double> ours);

struct ClaimText {
  std::string id;
  std::string text;
  std::string source;
};
/// How a figure is written in a claim's evidence, and by what it is multiplied before.
struct FigureFormat {
  std::string_view unit;
  int decimals = 2;
  double factor = 1.0;
};
/// That figure a is below figure b. Holds or fails on the means; seeds with both figures count.
[[nodiscard]] Claim claim_less(ClaimText text, std::span<const double> a, std::span<const double> b,
                               const FigureFormat& format);
/// That a figure reaches a limit, or stays at or below it.
[[nodiscard]] Claim claim_at_least(ClaimText text, std::span<const double> values, double limit,
                                   const FigureFormat& format);

/// One figure of every run: `figures(runs, [](const Run& run) { return run.gap_m; })`.
template <class Run, class Figure>
[[nodiscard]] std::vector<double> figures(const std::vector<Run>& runs, const Figure& figure) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const Run& run : runs) values.push_back(static_cast<double>(figure(run)));
  return values;
}

}  // namespace echoarc::studies
