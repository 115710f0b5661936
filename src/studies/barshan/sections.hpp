// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "echoarc/studies/study_report.hpp"
#include "studies/barshan/place_runs.hpp"

/// Sections of the report, out of finished runs.
namespace echoarc::studies::barshan {

/// One figure of every run.
using Figure = std::function<double(const MapScore&)>;
[[nodiscard]] double mae_cm(const MapScore& score);
[[nodiscard]] double cdr_overall(const MapScore& score);
[[nodiscard]] double cdr_full(const MapScore& score);
[[nodiscard]] double cdr_empty(const MapScore& score);

/// Means over the seeds of one sweep: a value per parameter.
[[nodiscard]] std::vector<double> mean_by_parameter(const PlaceStudy& study, std::size_t sweep, const Figure& figure);

/// Tables 1, 7 and 8 with printed parameters, arcs and directions, maps as in Figures 3, 11 and 12.
[[nodiscard]] StudySection comparison_section(const PlaceStudy& study);
/// Rankings of 3.8 and 4.2, pair by pair.
[[nodiscard]] StudySection ranking_section(const std::vector<const PlaceStudy*>& places);
/// The same tables with the parameters that the paper's rule takes on our data.
[[nodiscard]] StudySection rule_section(const std::vector<const PlaceStudy*>& places);
/// Tables 2 to 6.
[[nodiscard]] StudySection sweep_section(const std::vector<const PlaceStudy*>& places);
/// Figures 13 to 15.
[[nodiscard]] StudySection angle_section(const std::vector<const PlaceStudy*>& places);
/// Times of section 4.4.
[[nodiscard]] StudySection time_section(const std::vector<const PlaceStudy*>& places);
/// Figures 4 and 5, and the corner of 30 degrees.
[[nodiscard]] StudySection corner_section(const std::vector<PlaceStudy>& corners);

}  // namespace echoarc::studies::barshan
