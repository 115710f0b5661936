// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <vector>

#include "cli/map_output.hpp"
#include "echoarc/io/run_report.hpp"

namespace echoarc::cli {

/// "run1: 3304 pings of 8 sensors, ..." and what became of the pings.
void print_pings(const Log& log, const SensingReport& sensing);

/// What each method made of it, with its cost, and where the pictures are. `folder` is the final name.
void print_maps(const MapRun& run, const std::vector<io::MethodReport>& reports, const std::filesystem::path& folder);

}  // namespace echoarc::cli
