// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/sensing/sensing_options.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

/// The chapters of the study of [Silver04].
namespace echoarc::studies::silver {

/// Latency and azimuth resolution over a building.
[[nodiscard]] Result<StudySection> building(const StudyHost& host, StudyProgress& progress);
/// A hallway that looks closed to the one map and open to the other.
[[nodiscard]] Result<StudySection> hallway(const StudyHost& host, StudyProgress& progress);
/// How soon a wall ahead appears in the maps.
[[nodiscard]] Result<StudySection> junction(const StudyHost& host, StudyProgress& progress);

/// Seeds of the building: the drive is long, and its figures are means over 10^5 pings. At most `host.seeds`.
inline constexpr int building_seeds = 3;

/// What App. B filters before any map: ranges beyond 150 inches, and jumps of a sensor.
[[nodiscard]] SensingOptions paper_filters();

}  // namespace echoarc::studies::silver
