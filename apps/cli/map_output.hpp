// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/feature_extraction.hpp"
#include "echoarc/core/log.hpp"
#include "echoarc/io/run_report.hpp"
#include "echoarc/mapping/catalog.hpp"
#include "echoarc/pipeline/pipeline.hpp"

namespace echoarc::cli {

/// A finished run: what writing and telling need.
struct MapRun {
  const Log& log;
  LogRun result;
  std::vector<AnyMethod> methods;
  FeatureExtraction features;
};

/// Writes path.csv, one folder per method and, if wanted, features/ into `folder`. Returns the share of each method in
/// the run report.
[[nodiscard]] Result<std::vector<io::MethodReport>> write_maps(const std::filesystem::path& folder, MapRun& run);

/// Outcome counters by name, and every rejection reason with its count: pings plain, odometry behind "odometry.".
void count_pings(const SensingReport& sensing, io::RunReport& report);

}  // namespace echoarc::cli
