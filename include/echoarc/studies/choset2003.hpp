// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_host.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::studies {

/// Choset, Nagatani, Lazar: The Arc-Transversal Median Algorithm, IEEE T-RA 19(3), 2003. The numbers of its section
/// IV; a narrow opening passed at two distances (Figs. 6, 16, 17); the T world on a scripted way (Figs. 21, 22);
/// regions of constant depth of a turn on the spot (Figs. 11, 12). Scenes `opening-near`, `opening-far`, `t-world`,
/// `rcd`.
[[nodiscard]] Result<StudyReport> choset2003(const StudyHost& host);

}  // namespace echoarc::studies
