// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string>
#include <vector>

#include "echoarc/core/options.hpp"
#include "echoarc/live/inquiry.hpp"

namespace echoarc::live {

/// The formulas behind the cells of a trace. Adds to every cell the terms that they speak of beyond the method's own:
/// `before` and `after`, and what an inverse sonar model says as `p_band` or `p_free`. A formula whose result is not
/// among the terms of a cell says nothing of that cell.
[[nodiscard]] std::vector<FormulaLine> formulas_of(std::string_view method, const OptionMap& options,
                                                   const Reading& reading, std::vector<CellChange>& cells);

}  // namespace echoarc::live
