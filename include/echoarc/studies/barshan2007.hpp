// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

/// Barshan: Directional Processing of Ultrasonic Arc Maps and its Comparison with Existing Techniques, IJRR 26(8),
/// 2007. Tables 1 to 8, Figures 3 to 5 and 11 to 15, the rankings of sections 3.8 and 4.2, and the parameter studies
/// that section 4.3 reports of. Scenes `curve`, `room-a`, `room-c`, `corner-90`, `corner-60`, `corner-30`,
/// `layout-linear`, `layout-circular`, `layout-random`.
[[nodiscard]] Result<StudyReport> barshan2007(const StudyHost& host);

}  // namespace echoarc::studies
