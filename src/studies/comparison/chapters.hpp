// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

#include "echoarc/studies/comparison_findings.hpp"
#include "echoarc/studies/comparison_report.hpp"

/// The chapters of a comparison's report.
namespace echoarc::studies::comparison {

/// "93.1"; "-" for what is no number.
[[nodiscard]] std::string percent(double share);
/// "93.1 / 68.9": share within 10 cm and coverage.
[[nodiscard]] std::string accuracy_and_coverage(const MeanScores& scores);
/// "run1-first-20-s": a place's name as part of a file name or an anchor.
[[nodiscard]] std::string anchor_of(const std::string& place);

[[nodiscard]] ComparisonSection score_section(const Comparison& comparison);
[[nodiscard]] ComparisonSection duel_section(const Comparison& comparison);
[[nodiscard]] ComparisonSection truncation_section(const Comparison& comparison);
[[nodiscard]] ComparisonSection calibration_section(const Comparison& comparison);
[[nodiscard]] ComparisonSection pixel_section(const Comparison& comparison);
[[nodiscard]] ComparisonSection picture_section(const Comparison& comparison);

}  // namespace echoarc::studies::comparison
