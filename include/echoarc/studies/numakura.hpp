// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

/// Numakura, Shimizu Okatani, Maekawa: Acquisition of an Environmental Map by Sonar Data. Two rooms, in each the four
/// maps of Figs. 9 and 10: without a test for outliers, with the geometric one, with the one for consistency, with
/// both; compared by the cells that are called free and are not. Scenes `numakura-a`, `numakura-b`.
[[nodiscard]] Result<StudyReport> numakura(const StudyHost& host);

}  // namespace echoarc::studies
