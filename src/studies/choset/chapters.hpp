// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

/// The chapters of the study of [Choset03].
namespace echoarc::studies::choset {

/// S1-a to S1-d: the algebra of section IV, worked out; nothing is simulated. `scene` is driven at the paper's speed.
[[nodiscard]] StudySection resolution_numbers(const sim::Scene& scene);

/// A narrow opening, passed near and far.
[[nodiscard]] Result<StudySection> narrow_opening(const StudyHost& host, StudyProgress& progress);
/// The mouth of the narrow corridor at the foot of the T.
[[nodiscard]] Result<StudySection> t_world(const StudyHost& host, StudyProgress& progress);
/// Regions of constant depth.
[[nodiscard]] Result<StudySection> constant_depth(const StudyHost& host, StudyProgress& progress);

/// How many drives each of the chapters above simulates for every seed.
inline constexpr std::size_t drives_per_seed = 2 + 1 + 1;

}  // namespace echoarc::studies::choset
