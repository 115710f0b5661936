// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

/// Yamauchi: Laser-Limited Sonar (Frontier-Based Exploration, 1997). One sweep from an alcove in the corner of a large
/// room with smooth walls: the evidence grid of the sonars alone beside that of laser-limited readings, by the cells
/// that are called free and are not. Scene `alcove`.
[[nodiscard]] Result<StudyReport> yamauchi(const StudyHost& host);

}  // namespace echoarc::studies
