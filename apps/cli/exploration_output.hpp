// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "echoarc/core/result.hpp"
#include "echoarc/studies/exploration.hpp"

namespace echoarc::cli {

struct ExplorationReport {
  std::string command;                         ///< that makes it again
  const studies::ExplorationRequest* request;  ///< outlives this
  const std::vector<studies::ExplorationRun>& runs;
};

[[nodiscard]] std::string exploration_table(const ExplorationReport& report);
[[nodiscard]] std::string exploration_json(const ExplorationReport& report);
/// runs.csv, coverage.csv, run.json, timings.json; of every run a picture, its graph where it has one, and with `logs`
/// its log.
[[nodiscard]] Result<void> write_exploration(const std::filesystem::path& folder, const ExplorationReport& report,
                                             bool logs);

}  // namespace echoarc::cli
