// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/studies/localisation.hpp"

namespace echoarc::cli {

struct LocalisationReport {
  std::string command;                          ///< that makes it again
  const studies::LocalisationRequest* request;  ///< outlives this
  const std::vector<studies::LocalisationRun>& runs;
};

[[nodiscard]] std::string localisation_table(const LocalisationReport& report);
[[nodiscard]] std::string localisation_json(const LocalisationReport& report);
/// runs.csv, believed.csv (what was believed and what was true, every second), run.json.
[[nodiscard]] Result<void> write_localisation(const std::filesystem::path& folder, const LocalisationReport& report);

}  // namespace echoarc::cli
