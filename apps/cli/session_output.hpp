// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>

#include "echoarc/core/result.hpp"
#include "echoarc/live/mapper.hpp"

namespace echoarc::cli {

/// run.json of what a mapper has taken so far.
[[nodiscard]] std::string session_report(const live::Mapper& mapper);

/// The finished maps of all methods and run.json, as `echoarc map` writes them, into the session's folder; says where.
[[nodiscard]] Result<void> write_session_maps(const std::filesystem::path& folder, const live::Mapper& mapper);

}  // namespace echoarc::cli
