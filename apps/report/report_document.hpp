// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/studies/study_report.hpp"

namespace echoarc::report {

/// Studies as one document.
struct ReportDocument {
  std::string version;  ///< of echoarc
  std::string command;  ///< that makes the document again
  std::vector<studies::StudyReport> studies;
};

/// One HTML file that needs nothing beside it: styles, charts and pictures are inside. Text is escaped.
/// Errors: a picture that cannot be encoded.
[[nodiscard]] Result<std::string> html_page(const ReportDocument& document);

/// The same figures as JSON, schema/reproduction.schema.json; pictures by size alone. Values that are no numbers are
/// null.
[[nodiscard]] std::string json_report(const ReportDocument& document);

}  // namespace echoarc::report
