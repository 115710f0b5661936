// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_report.hpp"

/// Pieces of the page, each a piece of HTML that is closed in itself.
namespace echoarc::report {

/// `text` with everything escaped that HTML gives a meaning, and bytes that are no UTF-8 left as they are.
[[nodiscard]] std::string escaped(std::string_view text);
/// "2.23", "1.70", "–" for what is no number.
[[nodiscard]] std::string number(double value, int decimals);
/// "holds", "does not hold", "cannot be told".
[[nodiscard]] std::string_view words(studies::Verdict verdict);

[[nodiscard]] std::string claim_table(const studies::StudySection& section);
[[nodiscard]] std::string table(const studies::StudyTable& table);
[[nodiscard]] std::string chart(const studies::ChartFigure& figure);
[[nodiscard]] Result<std::string> picture(const studies::PictureFigure& figure);

}  // namespace echoarc::report
