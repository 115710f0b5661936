// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/studies/comparison.hpp"

namespace echoarc::report {

/// A comparison, and where it came from.
struct ComparisonDocument {
  std::string version;  ///< of echoarc
  std::string command;  ///< that makes it again
  studies::Comparison comparison;
};

/// Every score and calibration as JSON; values that are no numbers are null.
[[nodiscard]] std::string comparison_json(const ComparisonDocument& document);

/// One HTML file that needs nothing beside it. Text is escaped. Errors: a picture that cannot be encoded.
[[nodiscard]] Result<std::string> comparison_page(const ComparisonDocument& document);

/// A file of the comparison's folder.
struct ReportFile {
  std::string path;  ///< within the folder: "comparison.json", "tables/scores.md", "pictures/run1.png"
  std::string bytes;
};
/// All of them. Errors: a picture that cannot be encoded.
[[nodiscard]] Result<std::vector<ReportFile>> comparison_files(const ComparisonDocument& document);

}  // namespace echoarc::report
