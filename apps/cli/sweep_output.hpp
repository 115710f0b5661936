// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>

#include "echoarc/studies/sweep.hpp"

namespace echoarc::cli {

/// A finished sweep, and what it was made with.
struct SweepReport {
  std::string subject;  ///< scene or log, as given
  std::string command;  ///< that makes it again
  studies::SweepResult result;
};

/// Means over the seeds, a line per method and combination; the rows of the parameter rule are marked.
[[nodiscard]] std::string sweep_table(const SweepReport& report);
/// Everything, every run included.
[[nodiscard]] std::string sweep_json(const SweepReport& report);
/// Writes run.json, sweep.csv (means and spreads), runs.csv and a chart per kind of score into an existing folder.
[[nodiscard]] Result<void> write_sweep(const std::filesystem::path& folder, const SweepReport& report);

}  // namespace echoarc::cli
