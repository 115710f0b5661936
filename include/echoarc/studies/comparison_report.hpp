// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/studies/comparison.hpp"
#include "echoarc/studies/study_report.hpp"
#include "echoarc/studies/text_table.hpp"

namespace echoarc::studies {

/// A part of what is shown of a comparison; whatever is empty is left out.
struct ComparisonSection {
  std::string id;  ///< an anchor
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<TextTable> tables;
  std::vector<ChartFigure> charts;
  std::vector<PictureFigure> pictures;
};

/// The comparison as tables, charts and pictures, in the order in which they are read.
[[nodiscard]] std::vector<ComparisonSection> comparison_sections(const Comparison& comparison);

}  // namespace echoarc::studies
