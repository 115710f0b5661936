// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

/// Silver, Morales, Rekleitis, Lisien, Choset: Arc Carving, 2004. A building of more than 5000 m^2 on a scripted tour:
/// Table I, Figs. 7 and 10 to 14; a narrow hallway (Fig. 9); the way up to the bar of a T (Fig. 4). Scenes `office`,
/// `hallway`, `junction`.
[[nodiscard]] Result<StudyReport> silver2004(const StudyHost& host);

}  // namespace echoarc::studies
